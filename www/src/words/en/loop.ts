export const loop = {
  title: "A walk is a loop",
  text:
    "A pose of the legs is a long list of angles. In a walk the angles move together, so the model writes a " +
    "pose as three numbers, a point in a small space. While the body walks, the point runs round a loop, once " +
    "for every two steps. Drag the dot round the loop and the body follows. Around the loop lie points that " +
    "the model has never seen.",
  guess: {
    question: "We pull the dot off the loop. What will the body do?",
    choices: {
      walk: "Take other steps",
      stop: "Stop in its last pose",
      dissolve: "Nobody knows, not even the model",
    },
  },
  dot: "The dot on the loop of the legs: arrow keys left and right move it round, up and down off the loop",
  plane: "The latent space of the legs",
  sizes: (columns: number, latent: number) => `legs: ${columns} numbers become ${latent}`,
  hint: "Drag the dot round the loop.",
  hintOff: "Now drag the dot anywhere. Colour: where the model knows the pose.",
  walk: "Let it walk",
  offLoop: (here: string, loop: string) =>
    `Here the model’s doubt about the pose is ${here} % of its doubt before training; on the loop it is at most ` +
    `${loop} %. The legs are drawn as faintly as the model is unsure.`,
  onLoop: (loop: string) =>
    `On the loop the model’s doubt about the pose is at most ${loop} % of the doubt that it had before training.`,
  equation: "The pose map g makes a pose y of a point x. Its doubt is the deviation of g at x.",
};
