import { beforeEach, expect, it } from "vitest";
import { HeldWorkers } from "../../engine/held.fake";
import { words } from "../../words/en";
import type { WordsStore } from "../../words/words";
import { BeliefChapter, TO_RHYTHMIC_DMP, TO_UNCOUPLED } from "./belief-chapter";
import persons from "../../../../docs/comparison/primary-claims.md?raw";
import { belief as german } from "../../words/de/belief";
import { belief as english, type Ratio } from "../../words/en/belief";
import { beliefOf, ratiosOf, threeRounds } from "./rounds";

let workers: HeldWorkers;
let chapter: BeliefChapter;
beforeEach(async () => {
  workers = new HeldWorkers();
  // Trainings end after their first step.
  workers.answer("trainExperiment", async (real, experiment, report) => ({
    ...(await real(experiment, report, AbortSignal.abort())),
    cancelled: false,
  }));
  const store = { now: words } as unknown as WordsStore;
  chapter = new BeliefChapter(store, workers, () => 0.4);
  chapter.arrive();
  await workers.settled();
});

it("gives nothing away before the guess, and opens the curtain only at a press", async () => {
  const found = [chapter.guess(), chapter.control(), chapter.reveal()];
  expect(found).toEqual([words.chapters.belief.guess, null, null]);
  expect(chapter.lab(), "a link would name the truth").toEqual({ view: "synthetic" });
  expect(workers.asked("trainExperiment")).toHaveLength(0);
  chapter.guessed(chapter.round.truth);
  expect([chapter.guess(), chapter.belief, chapter.control()]).toEqual([null, null, null]);
  await workers.settled();
  // After one step, each part still has a say in the other.
  expect([chapter.belief, chapter.truth]).toEqual(["both", null]);
  expect(chapter.control()).not.toBeNull();
});

it("starts anew when the visitor comes back", async () => {
  chapter.guessed("ab");
  await workers.settled();
  chapter.leave();
  expect(chapter.guess()).not.toBeNull();
  expect(chapter.truth).toBeNull();
});

it.each([
  ["better than the DMP (rhythmic)", TO_RHYTHMIC_DMP],
  ["Coupled parts predict better", TO_UNCOUPLED],
] as [string, Ratio][])("has the numbers of the table, which are undecided: %s", (name, ratio) => {
  const [mean, low, high] = ratio.map((value) => value.toFixed(2));
  const claim = persons.split("\n").find((line) => line.includes(name)) ?? "";
  expect(claim).toContain(`: ${mean} times (${low} to ${high}) in the mean of 10 persons`);
  expect(claim).toMatch(/\| undecided \|$/);
});

it("says the numbers in both languages", () => {
  expect(english.closing(TO_UNCOUPLED, TO_RHYTHMIC_DMP)).toMatch(
    /0\.73 times \(0\.51 to 1\.06\) .*1\.18 times .*ten persons: both undecided\./,
  );
  expect(german.closing(TO_UNCOUPLED, TO_RHYTHMIC_DMP)).toMatch(
    /0,73-mal .*1,18-mal .*zehn Personen: beides unentschieden\./,
  );
});

/** Numbers between 0 and 1 that a seed decides. */
function numbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state * 16807) % 2147483647;
    return state / 2147483647;
  };
}

it("has each answer once in three rounds, in an order that cannot be foreseen", () => {
  const orders = new Set<string>();
  for (let seed = 1; seed < 200; seed++) {
    const rounds = threeRounds(numbers(1000 * seed));
    expect(rounds.map(({ truth }) => truth).sort()).toEqual(["ab", "ba", "none"]);
    for (const { experiment, truth } of rounds) {
      expect(experiment.driving).toBe(truth !== "none");
      expect(experiment.seed).toBeGreaterThanOrEqual(0);
      expect(experiment.seed).toBeLessThan(10);
    }
    orders.add(rounds.map(({ truth }) => truth).join());
  }
  expect(orders.size).toBe(6);
});

it("reads the belief from the couplings, mirrored as the points on the screen", () => {
  const verdict = { forth: 2.1, back: 1911, forthIsRight: true, backIsRight: true };
  const round = {
    experiment: { seed: 0, driving: true, points: 10 as const },
    isMirrored: false,
    truth: "ab" as const,
  };
  expect(beliefOf(ratiosOf({ verdict }, round), 10)).toBe("ab");
  expect(beliefOf(ratiosOf({ verdict }, { ...round, isMirrored: true }), 10)).toBe("ba");
  expect(beliefOf({ ab: 10, ba: 10 }, 10)).toBe("none");
  expect(beliefOf({ ab: 1, ba: 1 }, 10)).toBe("both");
});
