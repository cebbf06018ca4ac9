import { beforeEach, expect, it, vi } from "vitest";
import { type CouplingsChange, CouplingsStore } from "./couplings-store";

const LEARNED = [
  [1, 4],
  [3, 1],
];

let couplings: CouplingsStore;
const changed = vi.fn<(change: CouplingsChange) => void>();
beforeEach(() => {
  changed.mockClear();
  couplings = new CouplingsStore(changed);
  couplings.learn(LEARNED);
});

it("weighs a source among all sources of its target", () => {
  expect(couplings.weight(0, 1)).toBeCloseTo(0.2, 12);
  expect(couplings.weight(1, 0)).toBeCloseTo(0.25, 12);
  expect(couplings.weightsInto(1).map((weight) => weight.toFixed(6))).toEqual(["0.200000", "0.800000"]);
  expect(couplings.strongestBetween()).toEqual({ source: 1, target: 0 });
});

it("sets one coupling, and is as learned again close to the learned value", () => {
  couplings.set(0, 1, 9);
  expect(JSON.stringify(couplings.alpha)).toBe("[[1,9],[3,1]]");
  const found = [couplings.altered, couplings.isChanged(0, 1), couplings.isChanged(1, 0)];
  expect(found).toEqual([true, true, false]);
  couplings.set(0, 1, 4.01);
  expect([couplings.altered, couplings.alpha]).toEqual([false, LEARNED]);
  expect(changed.mock.calls).toEqual([["set"], ["set"]]);
});

it("resets one coupling, or all", () => {
  couplings.set(0, 0, 7);
  couplings.set(0, 1, 7);
  couplings.reset(0, 0);
  expect(JSON.stringify(couplings.alpha)).toBe("[[1,7],[3,1]]");
  couplings.resetAll();
  expect(couplings.altered).toBe(false);
});

it("gives the visitor's reading back with a reset, unless the visitor has chosen another since", () => {
  couplings.setReading("as-learned");
  couplings.takeAll({ "0.1": 9 }, "re-inferred");
  couplings.takeAll({ "1.0": 9 }, "re-inferred");
  couplings.set(1, 0, 2);
  couplings.resetAll();
  expect([couplings.altered, couplings.reading]).toEqual([false, "as-learned"]);
  couplings.takeAll({ "0.1": 9 }, "re-inferred");
  couplings.setReading("re-inferred");
  couplings.resetAll();
  expect(couplings.reading).toBe("re-inferred");
});

it("keeps no change for another model, and sets nothing in a model without couplings", () => {
  couplings.set(0, 1, 9);
  couplings.learn(LEARNED);
  expect(couplings.altered).toBe(false);
  couplings.learn([]);
  couplings.set(0, 1, 9);
  expect([couplings.altered, couplings.alpha]).toEqual([false, []]);
});
