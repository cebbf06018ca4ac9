import type { Words } from "../en";

export const next: Words["chapters"]["next"] = {
  title: "Wie geht es weiter?",
  text:
    "Ein Gaußprozess rät den nächsten Schritt. Daraus, wo der Punkt war und wo er ist, schließt er, " +
    "wo er sein wird: Der Pfeil ist seine Vermutung, der Kreis zeigt, wie sicher er ist. Vermutung " +
    "für Vermutung entsteht ein Weg. Wo ist der Punkt in zehn Bildern? Steck eine Nadel dorthin und " +
    "sieh dir dann Zukünfte an, die das Modell für möglich hält.",
};
