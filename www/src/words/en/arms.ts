export const arms = {
  title: "Who tells the arms when to swing?",
  text:
    "Legs and arms each walk a loop of their own. A thin thread keeps them together: the legs’ say " +
    "about where the arms go next. Nobody told the model to couple them; it learned this from three " +
    "walks. In a moment we cut the thread, and the legs will have no say any more. What will the arms " +
    "do?",
};
