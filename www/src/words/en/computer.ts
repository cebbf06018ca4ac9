export const computer = {
  title: "Which one is a computer?",
  text:
    "Two walkers, drawn as points of light. A program walks one of them by published curves of " +
    "people’s gait; a small model that saw that program walk a few times made the other. People see " +
    "movement in a handful of dots at once, and also what is wrong with it. Look at the ankles, the " +
    "hips, the wrists.",
};
