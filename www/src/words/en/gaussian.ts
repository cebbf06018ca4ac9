export const gaussian = {
  title: "What is a Gaussian process?",
  text:
    "A Gaussian process guesses a curve from points. Near a point it is sure; far from all points it " +
    "is not, and says so: the band is how sure. Drag the points and watch the curve. A few inducing " +
    "points can stand for all of them.",
};
