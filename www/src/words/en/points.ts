export const points = {
  title: "Ten poses are enough",
  text:
    "The model does not keep the recordings. It keeps a few poses and a few steps, the inducing " +
    "points, and computes everything else from them. Place some, or take some away, until the walk " +
    "stumbles. Fewest wins. The bound says how much is lost; it is computed anew for each of your " +
    "choices.",
};
