import type { Words } from "../en";

export const product: Words["chapters"]["product"] = {
  title: "Zwei Vermutungen, ein Schritt",
  text:
    "Zwei Experten sprechen über den nächsten Schritt der Arme: die Arme selbst und die Beine. Jeder " +
    "gibt eine Vermutung ab und sagt mit einem Kreis, wie sicher er ist. Der Schritt, der getan wird, " +
    "liegt dazwischen, näher bei dem, der sicherer ist. Zieh an einem Kreis: Sein Radius ist Alpha, " +
    "die eine Zahl, die eine Kopplung hat.",
};
