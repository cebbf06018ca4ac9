import type { Words } from "../en";

export const arms: Words["chapters"]["arms"] = {
  title: "Wer sagt den Armen, wann sie schwingen?",
  text:
    "Beine und Arme gehen jeweils ihre eigene Schleife. Ein dünner Faden hält sie zusammen: das Wort " +
    "der Beine darüber, wohin die Arme als Nächstes gehen. Niemand hat dem Modell gesagt, dass es sie " +
    "koppeln soll; es hat das aus drei Gängen gelernt. Gleich schneiden wir den Faden durch, und die " +
    "Beine haben nichts mehr zu sagen. Was tun die Arme?",
};
