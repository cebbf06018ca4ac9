export const push = {
  title: "Push it, be the legs",
  text:
    "This walk has no recording to return to. It has a loop, and the loop attracts: whatever disturbs " +
    "the body, the next guesses lead back. Drag a hand, let go, and watch. How long will it take " +
    "until the arms are back in step?",
};
