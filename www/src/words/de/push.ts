import type { Words } from "../en";

export const push: Words["chapters"]["push"] = {
  title: "Stoß sie an, sei die Beine",
  text:
    "Dieser Gang hat keine Aufnahme, zu der er zurückkehren könnte. Er hat eine Schleife, und die " +
    "Schleife zieht an: Was auch immer den Körper stört, die nächsten Vermutungen führen zurück. Zieh " +
    "an einer Hand, lass los und sieh zu. Wie lange dauert es, bis die Arme wieder im Takt sind?",
};
