import { expect, it } from "vitest";
import { beliefOf, ratiosOf, threeRounds } from "./rounds";

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
  const round = { experiment: { seed: 0, driving: true }, isMirrored: false, truth: "ab" as const };
  expect(beliefOf(ratiosOf({ verdict }, round), 10)).toBe("ab");
  expect(beliefOf(ratiosOf({ verdict }, { ...round, isMirrored: true }), 10)).toBe("ba");
  expect(beliefOf({ ab: 10, ba: 10 }, 10)).toBe("none");
  expect(beliefOf({ ab: 1, ba: 1 }, 10)).toBe("both");
});
