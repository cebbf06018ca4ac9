/** The explanations of the terms, each of two sentences. */
export const terms = {
  more: "The method, with its equations",
  texts: {
    alpha: {
      title: "coupling variance",
      words:
        "The variance of what one part predicts about another: the smaller it is, the more that prediction counts. Training keeps it between 0.001 and 10, so a learned 10 means that the prediction was not needed.",
    },
    weight: {
      title: "weight",
      words:
        "The share of one prediction in the combined one, from 0 to 1. The weights into a part add up to 1: where one rises, the others fall.",
    },
    coupling: {
      title: "coupling",
      words:
        "How strongly one part drives another, or itself. Every part predicts the next state of every part, and the couplings say whose word counts.",
    },
    expert: {
      title: "expert",
      words:
        "What one part predicts about the next latent of one part, itself included. Each expert is a Gaussian process that sees only its own part’s last frames.",
    },
    "product-of-experts": {
      title: "product of experts",
      words:
        "The rule that combines the experts: their Gaussian predictions are multiplied. The result is their weighted mean, and the expert with the smallest variance α has the largest weight.",
    },
    predictions: {
      title: "predictions, drawn",
      words:
        "Each part’s prediction of the state now is a circle in its colour, with a radius of one standard deviation; thin lines lead to their product in black (white on a dark page), dashed ones have a weight below 0.01. The arrow is the step from the state before, and the band around the path is as wide as the product is unsure.",
    },
    reading: {
      title: "as learned, re-inferred",
      words:
        "As learned: a slider changes the weights only, and every expert predicts as before. Re-inferred: the experts are computed again, as all that the model learned from would have taught them under these couplings; often the motion then stays nearly the same, because other experts take over.",
    },
    measured: {
      title: "measures",
      words:
        "Taken from 20 seconds of this motion, without the first 5, in which it finds its pace: how far hands and feet swing, as a multiple of the motion as learned. In step means that each hand keeps its place in the cycle of the foot of the other side.",
    },
    part: {
      title: "part",
      words:
        "A group of joints, such as the legs, that shares one latent space and has one colour here. A body can be split into up to eight parts.",
    },
    latent: {
      title: "latent",
      words:
        "A point that stands for one pose of a part, with a few numbers instead of many joint angles. The model finds the latents of all frames by itself.",
    },
    "latent-space": {
      title: "latent space",
      words:
        "The space of a part’s latents: near points are similar poses, and a walk is a loop in it. It has Q dimensions; the plots here show it from the side where it is widest.",
    },
    "inducing-point": {
      title: "inducing point",
      words:
        "One of the few examples that the model keeps in place of all frames. Those of the pose map are poses; those of the dynamics are short pieces of movement with what comes next.",
    },
    "dynamics-points": {
      title: "dynamics inducing points",
      words:
        "How many short pieces of movement each expert keeps. More of them can describe a richer movement, and training takes longer.",
    },
    "pose-points": {
      title: "pose inducing points",
      words:
        "How many poses the pose map of each part keeps. More of them give finer poses, and training takes longer.",
    },
    "pose-map": {
      title: "pose map",
      words:
        "The Gaussian process that turns a latent into a pose of its part. It is learned together with the latents and the dynamics.",
    },
    lengthscale: {
      title: "lengthscale",
      words:
        "How far one must go along a latent dimension before the function of a Gaussian process has become another. A dimension with a lengthscale much longer than the latent path hardly matters.",
    },
    "signal-variance": {
      title: "signal variance",
      words:
        "How far the function of a Gaussian process goes up and down, as a variance. For a pose map it is in the squared units of the pose’s columns, mostly radians.",
    },
    "noise-variance": {
      title: "observation noise",
      words:
        "The variance of what the pose map of a part leaves unexplained in its columns. It is small where the recorded poses are followed closely.",
    },
    order: {
      title: "order of the dynamics",
      words:
        "How many earlier frames predict the next one. With two, the model knows where a part is and how fast it moves.",
    },
    bound: {
      title: "evidence lower bound",
      words:
        "How well the model explains the clips, less what it takes to say so. Training raises it, or, in the Lab by default, its sum with smaller weights of the poses; bounds can be compared between models of the same frames only.",
    },
    "bound-terms": {
      title: "terms of the bound",
      words:
        "The bound is a sum: how well poses and dynamics of each part are explained, the first frames, and the entropy of the latents. Knopp et al. (2019) found that the dynamics say more than the poses about how natural the walks of a model look.",
    },
    nats: {
      title: "nat",
      words: "The unit of the bound: information counted with the natural logarithm. One nat is 1.44 bits.",
    },
    iterations: {
      title: "iteration",
      words:
        "One step of the optimiser, which changes the numbers of the model (at first all but the latents) so that the objective rises. Training ends when it no longer rises, or after this many.",
    },
    seed: {
      title: "seed",
      words:
        "The number from which all random numbers of a training follow. The same seed gives the same model; another one may find a better or a worse one.",
    },
    "movement-primitive": {
      title: "movement primitive",
      words:
        "A building block of movement, such as one step cycle of the legs. This model learns one for each part, and couplings make one movement of them.",
    },
    rollout: {
      title: "rollout",
      words:
        "A motion that the model makes: it begins with a few frames of a clip and then predicts frame after frame from its own predictions. Here each step is the mean of the prediction.",
    },
    future: {
      title: "future",
      words:
        "A motion drawn at random: at every frame the next state is not the mean of the prediction but a draw from it. The same seed draws the same one; in the plots a future is shown with the last half second of its path.",
    },
    "moment-matching": {
      title: "moment matching",
      words:
        "What is known of the state if only the first frames are certain: mean and spread, carried from frame to frame as a Gaussian. A Gaussian cannot bend around a loop: in the legs of the start model, after about two thirds of a second, the futures say more.",
    },
    map: {
      title: "MAP models",
      words:
        "Gaussian process dynamical models with one best value for each latent (maximum a posteriori), instead of a distribution. They keep all frames, and so become slow with many.",
    },
    tmp: {
      title: "temporal movement primitives",
      words:
        "A model of curves over time: each joint’s curve is a weighted sum of a few smooth ones. It knows no state, so nothing drives anything.",
    },
    dmp: {
      title: "dynamic movement primitives",
      words:
        "A spring for each joint that is pulled to a goal, or around a cycle, by a learned force. The force is a weighted sum of bases.",
    },
    bases: {
      title: "bases",
      words:
        "The bumps over time whose weighted sum is the force of a DMP. More of them follow the clip more closely.",
    },
    dtw: {
      title: "DTW MSE",
      words:
        "How far a prediction is from the real trial: the mean squared error after dynamic time warping. The warping forgives a prediction that is a little early or late.",
    },
    fold: {
      title: "fold",
      words:
        "One trial held out, while the models learn from the others and see its first frames. Each trial is held out in turn: a model has not seen the rest of what it is scored on.",
    },
    "confusion-rate": {
      title: "confusion rate",
      words:
        "How often people take a model’s movement for the natural one. At one half nobody can tell them apart; at 0 everybody can.",
    },
    "attention-check": {
      title: "attention check",
      words:
        "A trial with a movement that has obviously failed: who looks sees it. Who misses too many of them is left out of the analysis.",
    },
    "catch-trial": {
      title: "catch trial",
      words:
        "Two natural movements, of which one was not shown before. Who only knows the natural ones by heart prefers the one that was.",
    },
    "ln-k": {
      title: "ln K",
      words:
        "How much better a score predicts people’s answers than a constant does, in nats a block of answers. Curve and constant are tried on answers that they were not fitted to.",
    },
  },
};

export type TermsWords = typeof terms;
