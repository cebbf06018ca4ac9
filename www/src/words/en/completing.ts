// The words of a recording that gives one part, in English.
export const words = {
  about:
    "A recording moves one part. The model sees this part alone and infers the others, through the couplings. The outline is the recording.",
  given: "The recording moves",
  recording: "Recording",
  until: "The model sees it",
  toTheEnd: "to the end",
  seconds: (seconds: string) => `for ${seconds} s, then goes on by itself`,
  show: "Show",
  stop: "Back to the model",
  error: (part: string, ratio: string) => `${part}: error ${ratio}`,
  after: (ratio: string) => `afterwards ${ratio}`,
  meaning:
    "The error is 0 where the part moves as recorded, and 1 where it is no better than the mean pose of the clips.",
  ownWalk: "The model’s own motion, as learned",
  notReady: "The model is not ready; try again in a moment",
  failed: "The recording cannot be completed",
  caption: (part: string, clip: string) => ({
    title: "One part recorded, the rest inferred",
    text: `${part}: ${clip}. Outline: the recording`,
  }),
};
