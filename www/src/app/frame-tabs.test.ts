import { expect, it } from "vitest";
import { EXERCISE_NAMES } from "../exercises/exercises";
import { FrameTabs, TRAINING_EXERCISE } from "./frame-tabs";

it("are few, and those that an address has opened stay", () => {
  const tabs = new FrameTabs();
  const shown = (tab: "listen" | "numbers") => tabs.shown({ tab, exercise: 1 });
  expect(shown("listen")).toEqual(["listen", "loops"]);
  expect(shown("numbers")).toEqual(["listen", "loops", "numbers"]);
  expect(shown("listen")).toEqual(["listen", "loops", "numbers"]);
});

it("have the training for the exercise with one", () => {
  expect(EXERCISE_NAMES[TRAINING_EXERCISE - 1]).toBe("few");
  const shown = new FrameTabs().shown({ tab: "listen", exercise: TRAINING_EXERCISE });
  expect(shown).toEqual(["listen", "loops", "learn"]);
});
