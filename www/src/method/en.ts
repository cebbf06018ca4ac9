/** The view Method: equations, symbols and references. A [text|term] is explained when it is pressed. */
export const words = {
  model: {
    title: "The model",
    latents:
      "A body is split into parts. Each frame of part i is a [latent|latent], a point in a space of Q dimensions. Where the latent goes next is predicted by every part j from its own last frames, and the predictions are combined as a [product of experts|product-of-experts] (Hinton 1999):",
    weights:
      "The smaller a coupling variance, the larger the weight of that expert. Only ratios of the variances into one part change the mean. Each expert is a Gaussian process. Its signal variance is 1: otherwise its scale could be traded for its weight.",
    poses: "A [pose map|pose-map], a Gaussian process too, turns the latent into the pose of the part:",
  },
  training: {
    title: "Training",
    bound:
      "The latents are not known, so training finds a Gaussian distribution for each, together with kernels, couplings and inducing points. It climbs the sum",
    weights:
      "With γ = 1, as in the papers, this is a lower bound on the log evidence. In the Lab γ is Q/D for one body unless told otherwise, latent dimensions by columns of the part: no bound, but latents that are easier to predict (Urtasun et al. 2006). A model of a body whose motion does not go on then learns from its own rollouts, which change the distribution of u alone. “As in the papers”, under Learn, trains with γ = 1 and without own rollouts, as “Compare models” always does; a library that you learn has γ = 1.",
    terms:
      "Each term F of a Gaussian process rests on a few inducing points in place of all frames (Titsias and Lawrence 2010). For R rows and C columns, with the variance n of what is observed and the covariance K of the inducing points:",
    sums: "Ψ₂ and b are sums over the frames of expected products: of two kernel values, and of a kernel value and the target. c₂ is the sum of the expected squares of the targets, and Δ what the inducing points leave unexplained. The time of an iteration grows linearly with the frames.",
  },
  steps: {
    title: "Where the bound comes from",
    list: [
      "Each map gets inducing points: a few inputs, and the outputs there. Given these, the rest of the map is taken not to depend on the data.",
      "In place of the true distribution there is a Gaussian for each latent, one for the inducing outputs of each pose map, and one for those of all experts about a part together. Jensen’s inequality then bounds the log evidence from below.",
      "The maps are integrated out. The best distribution of the inducing outputs has a closed form: 𝐄(u) above.",
      "Kernel values are averaged over the latents. For this kernel the averages are exact: nothing is sampled.",
    ],
  },
  rollout: {
    title: "Rollout",
    text: "A rollout starts with the first p latents of a clip and then predicts frame after frame, all parts together:",
    mean: "Each step is the mean of its prediction, with nothing random.",
  },
  readings: {
    title: "Two readings of a coupling",
    learned: "Experts as learned.",
    learnedText:
      "A slider changes α and so the weights, as in the papers. What each expert predicts stays: what if this part listened less to that one?",
    inferred: "Experts re-inferred.",
    inferredText:
      "Under other couplings the same data would have taught other experts. The model keeps the sums Ψ₂ and b of all it learned from, own rollouts too, so that 𝐄(u) can be computed again for any α. Often the data can be explained under these couplings too, and the motion stays nearly the same.",
    choose: "Choose the reading",
  },
  others: {
    title: "The other models",
    tmp: "[TMP|tmp] (after Clever et al. 2016): every column is a weighted sum of a few curves over a common phase.",
    dmp: "[DMP|dmp] (Ijspeert et al. 2013): a spring pulls every column towards a goal g, and a learned force f follows a given clock s.",
    map: "[MAP|map] (Wang et al. 2008; Velychko et al. 2014): the same dynamics as above, with all frames in place of inducing points, and the most probable latents in place of distributions.",
    score: "The perception score",
    scoreText:
      "Of the vCGPDM, Velychko et al. (2018) found that people take a movement for the natural one less often the larger its error on the training data, and fit a and c; 0.5 would be perfect. Of DMPs, and the error on trials held out, Knopp et al. (2019) found no such curve.",
  },
  table: {
    label: "Properties of the models (Velychko et al. 2018, table 1)",
    model: "Model",
    properties: ["modular", "scalable", "compact", "canonical dynamics", "learned dynamics"],
    yes: "yes",
    no: "no",
    see: "See",
    measuredBy: ", for GPDMs measured by",
    evidence: {
      modular: {
        property: "modular",
        meaning: "its primitives can be used again in other movements",
      },
      scalable: {
        property: "scalable",
        meaning: "with many frames, the time of an iteration grows with less than their cube",
      },
      compact: { property: "compact", meaning: "what a rollout needs does not grow with the frames" },
      dynamics: {
        property: "canonical and learned dynamics",
        meaning: "the dynamics are given before learning, or are any smooth function",
      },
    },
  },
  graphs: {
    one: "Graphical model of one part",
    oneText:
      "Each latent follows from the two before it and gives a pose. Few inducing points (diamonds) stand for both maps.",
    two: "Graphical model of two coupled parts",
    twoText:
      "Two parts. Each predicts also the next latent of the other; the poses are left out. Press a shape to go to its control.",
    part: (place: number) => `part ${place}`,
    latents: "Latents: show their plots",
    bothLatents: "Latents of part 1 and part 2: show their plots",
    poses: "Poses: show the figure",
    dynamicsPoints: "Inducing points of the dynamics: show them in the plots",
    posePoints: "Inducing points of the poses: show them in the plots",
    couplings: "Couplings: show their sliders",
  },
  /** For screen readers. */
  equation: (name: string) => `Equation: ${name}`,
  equations: {
    dynamics: "the next latent",
    weights: "the weights of the experts",
    history: "the history of a part",
    expert: "an expert",
    kernel: "the kernel",
    pose: "the pose map",
    bound: "what training maximises",
    collapsed: "a term of the bound",
    posterior: "the inducing outputs",
    rollout: "a step of the rollout",
    tmp: "the temporal movement primitive",
    dmp: "the dynamic movement primitive",
    map: "the MAP models",
    score: "the perception score",
  },
  /** Words within the equations. */
  inEquations: {
    poses: "poses ",
    dynamics: "dynamics ",
    firstFrames: "first frames",
    entropy: "entropy",
    natural: "taken for natural",
  },
  symbols: {
    title: "The symbols, and where they are on the page",
    label: "Symbols",
    heads: ["Symbol", "Meaning", "On the page"],
    notShown: "not shown",
    meaning: {
      parts: "parts of the body: j predicts i",
      frames: "frame, counted from 0",
      pose: "the pose of part i: joint angles, and how the root moves",
      latent: "latent: the pose of part i in a few numbers",
      dimensions: "dimensions of a latent space",
      history: "the last p latents of part j",
      order: "order of the dynamics",
      expert: "expert: what part j predicts about part i",
      coupling: "coupling variance: small means influential",
      weight: "weight of an expert, 0 to 1",
      dynamicsPoints: "dynamics inducing points: histories, and what follows them",
      dynamicsCount: "how many of them each expert has",
      poseMap: "pose map: from latents to poses",
      posePoints: "pose inducing points, and their poses",
      poseCount: "how many of them each pose map has",
      noise: "variance of the noise of part i’s poses",
      lengths: "squared lengthscale: how far apart two latents are still alike",
      bound: "evidence lower bound, in nats",
    },
    /** What a press on the place of a symbol shows. */
    there: {
      parts: "Parts: how the body is split",
      frames: "the time line",
      pose: "the figure",
      latent: "the dot in its plot",
      dimensions: "Latent dimensions",
      order: "Frames of history",
      expert: "as learned, or re-inferred",
      coupling: "the sliders",
      weight: "the numbers under the sliders",
      dynamicsPoints: "the arrows in the plots",
      dynamicsCount: "Dynamics points",
      posePoints: "the diamonds in the plots",
      poseCount: "Pose points",
      bound: "the chart under Train",
    },
  },
  references: {
    title: "References",
    cite: "Please cite these papers",
    save: "Save as BibTeX",
  },
  back: "Back to the walk",
};

export type MethodWords = typeof words;
