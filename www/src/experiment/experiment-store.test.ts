import { beforeEach, describe, expect, it, vi } from "vitest";
import { HeldWorkers } from "../engine/held.fake";
import { initialSettings, type Settings } from "../settings/settings";
import { Store } from "../ui/store";
import { ExperimentStore } from "./experiment-store";
import type { ExperimentRun } from "./experiments";
import { endingOf } from "./findings-tables";

class FakeSettings extends Store {
  values: Settings = initialSettings();
  change(change: Partial<Settings>): void {
    this.values = { ...this.values, ...change };
    this.changed();
  }
}

let workers: HeldWorkers;
let settings: FakeSettings;
let experiments: ExperimentStore;
/** The training on screen after its last report. */
let during: Partial<ExperimentRun>;
beforeEach(() => {
  [workers, settings] = [new HeldWorkers(), new FakeSettings()];
  workers.hold("drawExperiment", "trainExperiment");
  // Trainings end after their first step.
  workers.answer("trainExperiment", async (real, experiment, report, { aborted }) => {
    const outcome = await real(experiment, report, AbortSignal.abort());
    during = { ...experiments.shown };
    return { ...outcome, cancelled: aborted };
  });
  experiments = new ExperimentStore(settings, workers);
});

const draws = () => workers.held("drawExperiment");
const drawn = () => draws().map(({ given: [experiment] }) => experiment);
const trainings = () => workers.held("trainExperiment");
const seeds = (...numbers: number[]) => numbers.map((seed) => ({ seed, driving: true, points: 10 as const }));
const states = () => experiments.runs.map(({ seed, state }) => `${seed} ${state}`);

describe("the data", () => {
  it("are drawn when the visitor chooses another experiment, and only then", async () => {
    const stop = experiments.follow();
    await workers.settled();
    expect(drawn()).toEqual(seeds(0));
    const told = vi.fn();
    experiments.on(told);
    draws()[0]?.go();
    await workers.settled();
    expect([experiments.truth?.frames, told.mock.calls.length]).toEqual([300, 1]);
    settings.change({ plot: "3d" });
    await workers.settled();
    expect(draws()).toHaveLength(1);
    settings.change({ driving: false });
    expect(experiments.truth).toBeNull();
    await workers.settled();
    expect(drawn()[1]).toEqual({ seed: 0, driving: false, points: 10 });
    stop();
    settings.change({ drawn: 7 });
    await workers.settled();
    expect(draws()).toHaveLength(2);
  });

  it("of a riddle are drawn in place of the chosen ones, and no setting names them", async () => {
    experiments.follow();
    await workers.settled();
    draws()[0]?.go();
    await workers.settled();
    experiments.setRiddle({ seed: 5, driving: false, points: 10 });
    await workers.settled();
    expect(drawn()[1]).toEqual({ seed: 5, driving: false, points: 10 });
    expect([settings.values.drawn, settings.values.driving]).toEqual([0, true]);
    expect([experiments.isRiddle, experiments.experiment]).toEqual([
      true,
      { seed: 5, driving: false, points: 10 },
    ]);
    draws()[1]?.go();
    await workers.settled();
    experiments.setRiddle(null);
    await workers.settled();
    expect([experiments.isRiddle, drawn()[2]]).toEqual([false, seeds(0)[0]]);
  });

  it("of an older experiment never replace those of a newer one", async () => {
    experiments.follow();
    await workers.settled();
    settings.change({ drawn: 1 });
    settings.change({ drawn: 2 });
    await workers.settled();
    draws()[0]?.go();
    await workers.settled();
    expect(experiments.truth).toBeNull();
    expect(drawn().map(({ seed }) => seed)).toEqual([0, 2]);
    draws()[1]?.go();
    await workers.settled();
    workers.letGo("drawExperiment");
    const [newest] = seeds(2);
    expect(experiments.truth).toEqual(await workers.desk.run((worker) => worker.drawExperiment(newest!)));
  });

  it("can be drawn again after a failure", async () => {
    workers.unreachable = "offline";
    experiments.follow();
    await workers.settled();
    expect(experiments.problem).toBe("offline");
    workers.unreachable = "";
    experiments.draw();
    await workers.settled();
    draws()[0]?.go();
    await workers.settled();
    expect([experiments.problem, experiments.truth?.frames]).toEqual(["", 300]);
  });
});

describe("a training", () => {
  it("reports its findings, and is not done twice", async () => {
    const over = experiments.train(seeds(0));
    await workers.settled();
    expect(experiments.status).toBe("running");
    trainings()[0]?.go();
    await over;
    expect(during).toMatchObject({ state: "running", iteration: 1, findings: experiments.shown?.findings });
    expect(experiments.shown?.findings?.verdict.forth).toBeGreaterThan(0);
    expect([experiments.busy, states()]).toEqual([false, ["0 done"]]);
    await experiments.train(seeds(0));
    expect(trainings()).toHaveLength(1);
    expect(experiments.open(seeds(0, 1))).toEqual(seeds(1));
  });

  it("keeps its best model when it is cancelled; trainings that had not begun leave the list", async () => {
    const over = experiments.train(seeds(0, 1, 2, 3));
    await workers.settled();
    expect(states()).toEqual(["0 running", "1 running", "2 waiting", "3 waiting"]);
    experiments.cancel();
    expect(experiments.status).toBe("cancelling");
    await over;
    expect(states()).toEqual(["0 cancelled", "1 cancelled"]);
    expect(experiments.runs[0]?.iteration).toBe(1);
    expect(experiments.runs.map(endingOf)[0]).toBe("You cancelled; this is the best so far.");
    expect(experiments.open(seeds(0))).toEqual(seeds(0));
  });

  it("does not end the others when it fails, and can be repeated", async () => {
    const over = experiments.train(seeds(0, 1));
    await workers.settled();
    trainings()[0]?.fail(new Error("out of memory"));
    trainings()[1]?.go();
    await over;
    expect(states()).toEqual(["0 failed", "1 done"]);
    expect(experiments.shown?.ending).toBe("out of memory");
    const again = experiments.train(seeds(0, 1));
    await workers.settled();
    expect(trainings()).toHaveLength(3);
    trainings()[2]?.go();
    await again;
    expect(states()).toEqual(["1 done", "0 done"]);
  });

  it("continues when a worker dies", async () => {
    const over = experiments.train(seeds(0, 1, 2));
    await workers.settled();
    trainings()[0]?.die(new Error("the worker stopped"));
    await workers.settled();
    trainings()[1]?.go();
    trainings()[2]?.go();
    await over;
    expect(states()).toEqual(["0 failed", "1 done", "2 done"]);
  });
});
