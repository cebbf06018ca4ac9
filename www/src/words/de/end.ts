import type { Words } from "../en";

export const end: Words["chapters"]["end"] = {
  title: "Jetzt gehört es dir",
  text:
    "Das weißt du nun: Jeder Teil eines Körpers kann eine eigene kleine Regel haben, die um eine Schleife führt. Die " +
    "Regel sagt, wo sie nicht sicher ist. Die Regeln zweier Teile werden multipliziert, und Alpha sagt, wer zählt. So " +
    "kann man Teile trennen, anstoßen und austauschen.",
};
