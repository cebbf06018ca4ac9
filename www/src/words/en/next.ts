export const next = {
  title: "What next?",
  text:
    "A Gaussian process guesses the next step. From where the point was and where it is, it says " +
    "where the point will be: the arrow is its guess, the circle is how sure it is. Guess after guess " +
    "makes a path. Where will the point be ten frames from now? Put a pin there, and then look at " +
    "futures that the model thinks possible.",
};
