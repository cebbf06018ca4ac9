// The ten questions of understanding: the key words of each answer are on the screen of these chapters, in every
// language.
import { expect, it } from "vitest";
import { words as german } from "../words/de";
import { words as english } from "../words/en";
import type { ChapterName } from "../settings/chapters";

/** For each question the chapters, and key words of the answer in English and German. */
const ANSWERS: readonly [ChapterName[], string[], string[]][] = [
  [
    ["arms", "next"],
    ["was never recorded", "a rule for the next step"],
    ["wurde nie aufgenommen", "eine Regel für den nächsten Schritt"],
  ],
  [
    ["loop"],
    ["the angles move together", "as three numbers", "round a loop"],
    ["bewegen sich die Winkel gemeinsam", "als drei Zahlen", "auf einer Schleife"],
  ],
  [["loop"], ["has never seen", "doubt about the pose"], ["nie gesehen", "Zweifel"]],
  [
    ["next"],
    ["the arrow is its guess", "how sure it is", "standard deviations"],
    ["Der Pfeil ist ihre Vermutung", "wie sicher", "Standardabweichungen"],
  ],
  [["next"], ["Guess after guess makes a path"], ["Vermutung für Vermutung entsteht ein Weg"]],
  [
    ["points"],
    ["a few steps, the inducing points", "is smooth", "between these points"],
    ["wenige Schritte, die Stützpunkte", "ist glatt", "zwischen diesen Punkten"],
  ],
  [
    ["product"],
    ["The two bells are multiplied", "nearer to the smaller circle"],
    ["werden multipliziert", "näher beim kleineren Kreis"],
  ],
  [
    ["arms", "product"],
    ["α is how unsure a source is", "area grows with its variance, alpha"],
    ["α sagt", "der mit ihrer Varianz Alpha wächst"],
  ],
  [
    ["arms"],
    ["find a pace of their own", "Who said “stop” is right too"],
    ["finden ein eigenes Tempo", "„anhalten“"],
  ],
  [
    ["belief"],
    ["Of a recorded walk nobody knows the truth", "explains the recording"],
    ["kennt niemand die Wahrheit", "was die Aufnahme erklärt"],
  ],
];

/** Stands for a measured number, or for a list of them, in a sentence. */
const measured: unknown = new Proxy(() => {}, {
  get: (_, name) => (name === Symbol.toPrimitive ? () => 1 : name === "map" ? () => [1, 1, 1] : measured),
});

/** All sentences of a chapter. */
function sentences(value: unknown): string {
  if (typeof value === "string") return value;
  if (typeof value === "function")
    return String(value(...Array.from({ length: value.length }, () => measured)));
  return Object.values(value ?? {})
    .map(sentences)
    .join("\n");
}

it.each(ANSWERS.map((answer, place) => [place + 1, answer] as const))(
  "question %i can be answered from the screen",
  (_, [chapters, inEnglish, inGerman]) => {
    for (const [language, keys] of [
      [english, inEnglish],
      [german, inGerman],
    ] as const) {
      const screen = chapters.map((chapter) => sentences(language.chapters[chapter])).join("\n");
      for (const key of keys) expect(screen).toContain(key);
    }
  },
);
