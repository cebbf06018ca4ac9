import { beforeEach, expect, it } from "vitest";
import { progress } from "../engine/engine.fake";
import type { ModularityOutcome } from "../engine/library-protocol";
import type { SampleInfo } from "../engine/protocol";
import { FakeProgram, settled } from "../engine/whole-workers.fake";
import { Store } from "../ui/store";
import { FoldStore } from "./fold-store";

class FakeEngine extends Store {
  samples: SampleInfo[] = [];
  have(...ids: string[]): void {
    this.samples = ids.map((id) => ({ id, title: `title of ${id}`, movement: "walk" }));
    this.changed();
  }
}
const came = (dtwMse: number): ModularityOutcome => ({
  ...{ movement: "walk", bound: 1, storedNumbers: 5, frames: 9 },
  score: { dtwMse, mse: 1, variance: 1 },
});

let program: FakeProgram;
let engine: FakeEngine;
let fold: FoldStore;
beforeEach(() => {
  [program, engine] = [new FakeProgram(), new FakeEngine()];
  fold = new FoldStore(program, engine);
  engine.have("w1", "w2");
});
const end = async (which: number, found: ModularityOutcome | null) => {
  const training = program.libraries.folds[which];
  training?.report({ steps: [], progress: { ...progress(3), fraction: 1 }, elapsed: 2, found });
  training?.end({ cancelled: found === null, reason: found ? "settled" : null });
  await settled();
};

it("trains a library and a model alone at the same time, and has the errors of both", async () => {
  expect(fold.trial?.id).toBe("w1");
  fold.choose("w2");
  void fold.holdOut();
  await settled();
  expect(program.libraries.folds.map(({ job }) => job)).toEqual([
    { sample: "w2", alone: false },
    { sample: "w2", alone: true },
  ]);
  program.libraries.folds[0]?.report({
    steps: [],
    progress: { ...progress(3), fraction: 0.5 },
    elapsed: 2,
    found: null,
  });
  expect([fold.library.fraction, fold.alone.fraction]).toEqual([0.5, 0]);
  void fold.holdOut();
  await end(1, came(0.002));
  expect([fold.busy, fold.outcome]).toEqual([true, null]);
  await end(0, came(0.001));
  expect(fold.busy).toBe(false);
  expect(fold.outcome).toMatchObject({
    trial: { id: "w2" },
    quick: false,
    library: { score: { dtwMse: 0.001 } },
    alone: { score: { dtwMse: 0.002 } },
  });
  expect(program.libraries.folds).toHaveLength(2);
});

it("has fewer iterations in a quick fold, and no errors after a cancel", async () => {
  fold.setQuick(true);
  const done = fold.holdOut();
  await settled();
  expect(program.libraries.folds[0]?.job.maxIterations).toBeLessThan(100);
  fold.cancel();
  expect(fold.stopping).toBe(true);
  await done;
  expect([fold.busy, fold.outcome]).toEqual([false, null]);
});

it("waits for its trials", async () => {
  engine.have();
  await fold.holdOut();
  expect([fold.trial, program.libraries.folds.length]).toEqual([null, 0]);
});
