export const loop = {
  title: "A walk is a loop",
  text:
    "A pose of this body has 60 angles. The model writes each pose as three numbers, a point in a " +
    "small space. While the body walks, the point runs round a loop, once for every two steps. Drag " +
    "the dot round the loop and the body follows. Then pull it off the loop, to where the model has " +
    "never seen a pose.",
};
