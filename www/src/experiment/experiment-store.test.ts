import { beforeEach, describe, expect, it } from "vitest";
import { FakeProgram, settled } from "../engine/whole-workers.fake";
import type { TrainingReport } from "../engine/protocol";
import type { SyntheticTruth, TrainedExperiment } from "../engine/whole-protocol";
import { initialSettings, type Settings } from "../settings/settings";
import { Store } from "../ui/store";
import { ExperimentStore } from "./experiment-store";
import { endingOf } from "./findings-tables";

class FakeSettings extends Store {
  values: Settings = initialSettings();
  change(change: Partial<Settings>): void {
    this.values = { ...this.values, ...change };
    this.changed();
  }
}

let program: FakeProgram;
let settings: FakeSettings;
let experiments: ExperimentStore;
beforeEach(() => {
  [program, settings] = [new FakeProgram(), new FakeSettings()];
  experiments = new ExperimentStore(settings, program);
});

const truth = (frames: number) => ({ frames }) as SyntheticTruth;
const report = (iteration: number) =>
  ({
    progress: { iteration, fraction: 0.1 },
    elapsed: 1,
    found: {},
  }) as unknown as TrainingReport<TrainedExperiment>;
const seeds = (...numbers: number[]) => numbers.map((seed) => ({ seed, driving: true, points: 10 as const }));
const states = () => experiments.runs.map(({ seed, state }) => `${seed} ${state}`);
const finished = { cancelled: false, reason: null };

describe("the data", () => {
  it("are drawn when the visitor chooses another experiment, and only then", async () => {
    const stop = experiments.follow();
    await settled();
    expect(program.draws.map(({ request }) => request)).toEqual(seeds(0));
    program.draws[0]?.end(truth(300));
    await settled();
    expect(experiments.truth?.frames).toBe(300);
    settings.change({ plot: "3d" });
    await settled();
    expect(program.draws).toHaveLength(1);
    settings.change({ driving: false });
    expect(experiments.truth).toBeNull();
    await settled();
    expect(program.draws[1]?.request).toEqual({ seed: 0, driving: false, points: 10 });
    stop();
    settings.change({ drawn: 7 });
    await settled();
    expect(program.draws).toHaveLength(2);
  });

  it("of a riddle are drawn in place of the chosen ones, and no setting names them", async () => {
    experiments.follow();
    await settled();
    program.draws[0]?.end(truth(300));
    await settled();
    experiments.setRiddle({ seed: 5, driving: false, points: 10 });
    await settled();
    expect(program.draws[1]?.request).toEqual({ seed: 5, driving: false, points: 10 });
    expect([settings.values.drawn, settings.values.driving]).toEqual([0, true]);
    expect([experiments.isRiddle, experiments.experiment]).toEqual([
      true,
      { seed: 5, driving: false, points: 10 },
    ]);
    program.draws[1]?.end(truth(300));
    await settled();
    experiments.setRiddle(null);
    await settled();
    expect([experiments.isRiddle, program.draws[2]?.request]).toEqual([false, seeds(0)[0]]);
  });

  it("of an older experiment never replace those of a newer one", async () => {
    experiments.follow();
    await settled();
    settings.change({ drawn: 1 });
    settings.change({ drawn: 2 });
    await settled();
    program.draws[0]?.end(truth(100));
    await settled();
    expect(experiments.truth).toBeNull();
    expect(program.draws.map(({ request }) => request.seed)).toEqual([0, 2]);
    program.draws[1]?.end(truth(200));
    await settled();
    expect(experiments.truth?.frames).toBe(200);
  });

  it("can be drawn again after a failure", async () => {
    program.unreachable = "offline";
    experiments.follow();
    await settled();
    expect(experiments.problem).toBe("offline");
    program.unreachable = "";
    experiments.draw();
    await settled();
    program.draws[0]?.end(truth(300));
    await settled();
    expect([experiments.problem, experiments.truth?.frames]).toEqual(["", 300]);
  });
});

describe("a training", () => {
  it("reports its findings, and is not done twice", async () => {
    const over = experiments.train(seeds(0));
    await settled();
    expect(experiments.status).toBe("running");
    program.trainings[0]?.report(report(12));
    expect(experiments.shown).toMatchObject({ state: "running", iteration: 12 });
    program.trainings[0]?.end(finished);
    await over;
    expect([experiments.busy, states()]).toEqual([false, ["0 done"]]);
    await experiments.train(seeds(0));
    expect(program.trainings).toHaveLength(1);
    expect(experiments.open(seeds(0, 1))).toEqual(seeds(1));
  });

  it("keeps its best model when it is cancelled; trainings that had not begun leave the list", async () => {
    const over = experiments.train(seeds(0, 1, 2, 3));
    await settled();
    expect(states()).toEqual(["0 running", "1 running", "2 waiting", "3 waiting"]);
    program.trainings[0]?.report(report(5));
    experiments.cancel();
    expect(experiments.status).toBe("cancelling");
    await over;
    expect(states()).toEqual(["0 cancelled", "1 cancelled"]);
    expect(experiments.runs[0]?.iteration).toBe(5);
    expect(experiments.runs.map(endingOf)[0]).toBe("You cancelled; this is the best so far.");
    expect(experiments.open(seeds(0))).toEqual(seeds(0));
  });

  it("does not end the others when it fails, and can be repeated", async () => {
    const over = experiments.train(seeds(0, 1));
    await settled();
    program.trainings[0]?.fail(new Error("out of memory"));
    program.trainings[1]?.end(finished);
    await over;
    expect(states()).toEqual(["0 failed", "1 done"]);
    expect(experiments.shown?.ending).toBe("out of memory");
    const again = experiments.train(seeds(0, 1));
    await settled();
    expect(program.trainings).toHaveLength(3);
    program.trainings[2]?.end(finished);
    await again;
    expect(states()).toEqual(["1 done", "0 done"]);
  });

  it("continues when a worker dies", async () => {
    const over = experiments.train(seeds(0, 1, 2));
    await settled();
    program.trainings[0]?.die(new Error("the worker stopped"));
    await settled();
    program.trainings[1]?.end(finished);
    program.trainings[2]?.end(finished);
    await over;
    expect(states()).toEqual(["0 failed", "1 done", "2 done"]);
  });
});
