import { describe, expect, it, vi } from "vitest";
import library from "../../../crate/lab/src/perception/study.rs?raw";
import bundled from "../../public/study/walks.study.json?raw";
import type { StudyTexts } from "../engine/whole-protocol";
import { study as german } from "./study-de";
import { study as english } from "./study-en";
import { shownText, storedText } from "./standard-texts";

vi.mock("./view-words", async () => {
  const { words } = await import("./de");
  return { perceptionWords: () => words };
});

const NAMES = Object.keys(english) as (keyof StudyTexts)[];

it("are those of the library and of the study of the page", () => {
  const { texts } = JSON.parse(bundled) as { texts: StudyTexts };
  const defaults = library.replace(/\\n/g, "\n").replace(/\\\n\s*/g, "");
  for (const name of NAMES) {
    const [first = "missing"] = english[name];
    expect(defaults).toContain(`"${first}"`);
    expect(english[name]).toContain(texts[name]);
  }
});

it("have a translation each", () => {
  for (const name of NAMES) expect(german[name].length, name).toBe(english[name].length);
});

describe("in German", () => {
  it("appear in German, and are stored in English", () => {
    for (const name of NAMES)
      for (const [place, text] of english[name].entries()) {
        expect(shownText(name, text)).toBe(german[name][place]);
        expect(storedText(name, shownText(name, text))).toBe(text);
      }
  });

  it("stay as they are when somebody has written them", () => {
    expect(shownText("question", "Which one?")).toBe("Which one?");
    expect(storedText("question", "Welche?")).toBe("Welche?");
  });
});
