export const borrow = {
  title: "Borrow arms",
  text:
    "Each part has learned a primitive of its own, and a coupling lets it listen to any other part. " +
    "So the legs of one movement can walk with the arms of another. Nobody ever recorded what you are " +
    "about to see. Which legs and which arms do you want to put together?",
};
