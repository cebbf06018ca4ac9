import { expect, it } from "vitest";
import { words as de } from "../words/de/help";
import { words as en } from "../words/en/help";
import { COMMANDS } from "./commands";

/** Keys as the help writes them. */
const WRITTEN: Readonly<Record<string, Record<"en" | "de", string>>> = {
  " ": { en: "space", de: "Leertaste" },
  ArrowLeft: { en: "← →", de: "← →" },
  ArrowRight: { en: "← →", de: "← →" },
};

for (const [language, { keys }] of Object.entries({ en, de }))
  it(`each key of a command is in the help: ${language}`, () => {
    const helped = keys.map(([key]) => key);
    const all = Object.values(COMMANDS).flatMap(({ key }) => key ?? []);
    const missing = all.filter((key) => !helped.includes(WRITTEN[key]?.[language as "en" | "de"] ?? key));
    expect(missing).toEqual([]);
  });
