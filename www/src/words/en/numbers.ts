/** The panel Numbers. A [text|term] in brackets is a term with an explanation. */
export const words = {
  failed: "These numbers could not be computed.",
  empty: "The numbers of the model and its motion appear here.",
  modelNow: "the model now",
  asLearned: "as learned",
  logDensity: {
    title: "Latent log density",
    of: "motion",
    rollout: "a frame of it",
    training: "a frame of the training",
    difference: "difference",
    about: (elbo: string) =>
      `How likely the latents of a frame are under the dynamics as learned, in nats. Knopp et al. (2019) predicted how natural people found walks with another number: the dynamics ELBO of the trained model, here ${elbo}.`,
    caution:
      "Nobody has asked people about this one. Compare only motions of one model. Without noise a motion may be above 0 even at rest.",
  },
  couplings: {
    title: "[Couplings|coupling]",
    label: "Couplings",
    decides: "who decides",
    about: "about",
    alphaLearned: "[α|alpha] learned",
    alphaNow: "α now",
    weightNow: "[w|weight] now",
  },
  angles: {
    title: "Joint angles",
    channel: "Joint and channel",
    against: "against",
    time: "time",
    speed: "its speed (phase plot)",
    save: "Save CSV",
    chart: (upward: string, across: string) => `${upward} against ${across}`,
    axes: {
      time: "time (s)",
      speed: (channel: string, unit: string) => `speed of ${channel} (${unit}/s)`,
      fileUnits: "file units",
    },
    about: (name: string) =>
      `As in the BVH file: ${name}, angles in degrees. The dot is now; it moves while the stage plays.`,
  },
  kernels: {
    poses: "[Pose maps|pose-map]: from latent to pose",
    posesLabel: "Kernels of the pose maps",
    part: "part",
    along: "[Lengthscale|lengthscale] √λ along",
    experts: (order: number) =>
      `[Experts|expert]: from the last ${order === 1 ? "frame" : `${order} frames`} to the next latent`,
    expertsLabel: "Kernels of the experts",
    from: "from",
    note: "Every kernel is squared exponential, without a linear part. The signal variance of every expert is 1: otherwise its scale could be traded for its coupling.",
  },
};

export type NumbersWords = typeof words;
