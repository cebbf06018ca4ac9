export const next = {
  title: "What next?",
  text:
    "The model has learned a rule for the next step: a Gaussian process, as on the card before. From where the point was and where it " +
    "is, the rule says where the point will be: the arrow is its guess, the circle is how sure it is. Guess " +
    "after guess makes a path. Where will the point be ten frames from now? Put a pin there, and then look at " +
    "futures that the model thinks possible.",
  guess: {
    question: "Where will the point be in a third of a second? Move the pin.",
    choices: { pin: "My pin is in place" },
  },
  pin: "The pin: arrow keys move it",
  anywhere: "A start anywhere: arrow keys move it",
  plane: "The latent space of the legs, with the next step",
  hint: "The circle is two standard deviations wide on each side.",
  hintAnywhere: "Now press anywhere: the walk starts there, and the path bends into the loop.",
  again: "Another start",
  away: (deviations: string) => `Your pin is ${deviations} standard deviations from the mean of the futures.`,
  beat: (beaten: number, futures: number) =>
    beaten === 0
      ? `All of the ${futures} futures that the model has drawn are nearer: far off.`
      : `It is nearer than ${beaten} of ${futures} futures that the model has drawn.`,
  back: (seconds: string) => `From there the path came back to the loop after ${seconds} s.`,
  lost: "From there the path did not come back to the loop in four seconds.",
  equation: "The next point of a part is drawn around the guess of the experts f, with the variance α.",
};
