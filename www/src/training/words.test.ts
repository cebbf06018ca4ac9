import { describe, expect, it } from "vitest";
import { progress } from "../engine/documents.fake";
import { costWords } from "./cost";
import { lab } from "../words/lab";
import { endingWords, timeLeft } from "./words";

describe("the plan of a training", () => {
  it("names one clip or counts several", () => {
    const { newModels } = lab().learn.training;
    expect(newModels(2, 1, false)).toBe("2 new models, of the ticked clip and its body.");
    expect(newModels(1, 1, true)).toBe("A new model, of the ticked sample clip and its body.");
    expect(newModels(4, 3, false)).toBe("4 new models, of the 3 ticked clips and their body.");
  });
});

describe("how a training ended", () => {
  const done = { cancelled: false, reason: "settled" as const };

  it("names the setbacks, if there were any", () => {
    expect(endingWords(done, progress(3))).toBe("the objective no longer rises");
    const setbacks = { jittered: 3, turnedBack: 1 };
    expect(endingWords(done, { ...progress(3), setbacks })).toBe(
      "The objective no longer rises. A covariance needed jitter on its diagonal 3 times. The search turned back once where there was no finite number.",
    );
  });

  it("names the settings that the program reduced", () => {
    const notices = ["40 pose inducing points are reduced, because there are only 20 frames"];
    expect(endingWords({ ...done, notices }, progress(3))).toBe(
      "The objective no longer rises. 40 pose inducing points are reduced, because there are only 20 frames.",
    );
  });
});

describe("the cost of a training", () => {
  const words = (seconds: number, bytes = 1e7, count = 1, workers = 1) =>
    costWords({ seconds, bytes }, count, workers);

  it("is a time when the visitor has to wait", () => {
    expect(costWords(null, 1, 1).words).toBe("");
    expect(words(5).words).toBe("");
    expect(words(43)).toEqual({ words: "At most about 45 s.", absurd: false });
    expect(words(43, 1e7, 4, 2).words).toBe("At most about 1 min 30 s.");
  });

  it("is a warning when the wait is very long or the memory is full", () => {
    expect(words(3600 * 5)).toEqual({
      words: "At most about 5 hours. Fewer frames a second, points or iterations make it shorter.",
      absurd: true,
    });
    expect(words(1e7).words).toContain("116 days");
    expect(words(60, 1e9, 2, 2).words).toContain("2.0 GB of memory");
  });
});

it("rounds the remaining time, and says when it is not known yet", () => {
  expect(timeLeft(null)).toBe("estimating the time left");
  expect(timeLeft(0.2)).toBe("at most 1 s left");
  expect(timeLeft(10)).toBe("at most 10 s left");
  expect(timeLeft(97)).toBe("at most 1 min 40 s left");
  expect(timeLeft(97, true)).toBe("about 1 min 40 s left");
});
