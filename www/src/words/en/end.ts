export const end = {
  title: "Now it is yours",
  text:
    "What you now know: each part of a body can have a small rule of its own, which leads round a loop. The rule " +
    "says where it is not sure. Rules of two parts are multiplied, and alpha says who counts. So parts can be cut, " +
    "pushed and exchanged.",
};
