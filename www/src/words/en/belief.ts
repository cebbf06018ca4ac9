export const belief = {
  title: "Do we know, or do we believe?",
  text:
    "Two parts move. Does one drive the other, and which? The truth is behind a curtain, because a " +
    "program made these movements and knows what it did. Vote first. Then a model is trained on the " +
    "movements, here and now, and draws the arrow that it believes in.",
};
