export const product = {
  title: "Two guesses, one step",
  text:
    "Two experts speak about the arms’ next step: the arms themselves and the legs. Each gives a " +
    "guess and says how sure it is, as a circle. The step that is taken lies between, nearer to the " +
    "one who is surer. Pull at a circle: its radius is alpha, the one number that a coupling has.",
};
