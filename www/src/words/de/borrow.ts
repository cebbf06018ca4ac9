import type { Words } from "../en";

export const borrow: Words["chapters"]["borrow"] = {
  title: "Geliehene Arme",
  text:
    "Jeder Teil hat sein eigenes Primitiv gelernt, und eine Kopplung lässt ihn auf jeden anderen Teil " +
    "hören. So können die Beine einer Bewegung mit den Armen einer anderen gehen. Niemand hat je " +
    "aufgenommen, was du gleich siehst. Welche Beine und welche Arme möchtest du zusammensetzen?",
};
