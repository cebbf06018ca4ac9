import { beforeEach, describe, expect, it, vi } from "vitest";
import { FakeLab } from "../couplings/lab.fake";
import { FakeTrainers, modelText, STANDS_STILL, settled } from "../engine/engine.fake";
import type { Run } from "./runs";
import { TrainingStore } from "./training-store";

let { engine, settings, stage, clips, notices, model } = new FakeLab();
let trainers: FakeTrainers;
let training: TrainingStore;

async function begin(fragment = "", workers = 2, loaded = (): unknown => clips.loadSamples()): Promise<void> {
  const lab = new FakeLab(fragment);
  ({ engine, settings, stage, clips, notices, model } = lab);
  trainers = new FakeTrainers(workers);
  training = new TrainingStore(lab.store, settings, clips, model, notices);
  await lab.start(modelText(100), undefined, trainers);
  await loaded();
}
beforeEach(() => begin("seed=5&trainings=1"));

const states = () => training.runs.map(({ state }) => state).join(" ");
const seedOf = ({ model }: Run) => (JSON.parse(model?.text ?? "{}") as { seed?: number }).seed;
const seedOnStage = () => model.model?.info.provenance.settings.seed;
const worker = (index: number) => {
  const found = trainers.trainings[index];
  if (!found) throw new Error(`no training ${index}`);
  return found;
};
const done = { cancelled: false, reason: null };
const cancelled = { cancelled: true, reason: null };

describe("a training", () => {
  it("trains on the ticked clips with the settings now, and its model is on the stage", async () => {
    const over = training.start();
    await settled();
    expect(states()).toBe("running");
    expect([training.busy, clips.locked, training.learning?.settings.seed]).toEqual([true, true, 5]);
    const { job } = worker(0);
    expect(job.clips.map(({ id, source }) => [id, source])).toEqual([
      [1, { sample: "walk-1" }],
      [2, { sample: "walk-2" }],
    ]);
    expect([job.settings.seed, job.settings.latent, job.settings.parts.length]).toEqual([5, 3, 2]);
    worker(0).report(12, -40, modelText(5));
    worker(0).end(done);
    await over;
    expect([states(), seedOnStage(), training.chosen?.settings.seed]).toEqual(["done", 5, 5]);
    expect(training.chosen?.steps.at(-1)?.iteration).toBe(12);
    expect([training.busy, clips.locked, training.learning]).toEqual([false, false, null]);
  });

  it("waits until all clips that come with the page are there", async () => {
    await begin("seed=5&trainings=1", 2, () => {});
    const seen: [number, string][] = [];
    clips.on(() => void seen.push([clips.ticked.length, training.whyNot()]));
    await clips.loadSamples();
    // One clip arrives before the next: an early press trained on that one alone.
    expect(seen[0]).toEqual([1, "Getting the sample clips ready"]);
    expect(seen.at(-1)).toEqual([2, ""]);
  });

  it("says why it cannot start", async () => {
    for (const { key } of clips.ticked) await clips.tick(key, false);
    expect(training.whyNot()).toMatch(/Tick at least one clip/);
    await training.start();
    expect(trainers.trainings).toHaveLength(0);
    engine.odd.add(3);
    await clips.tick("made-walk-1", true);
    await clips.tick("made-wave-1", true);
    expect(training.whyNot()).toMatch(/do not go together/);
  });

  it("says once for all seeds what the visitor should know, unless a clip in the list says it", async () => {
    await begin("seed=5&trainings=2");
    const [clip] = clips.all;
    if (!clip) throw new Error("no clip");
    clip.loaded.info.warnings.push("the first row is a T-pose");
    void training.start();
    await settled();
    const shown = `${clip.loaded.info.name}: the first row is a T-pose`;
    for (const seed of [0, 1]) worker(seed).begin([shown, "the clip b has the same pose"]);
    expect(notices.all.map(({ text }) => text)).toEqual(["The clip b has the same pose."]);
  });

  it("keeps its best model when it is cancelled", async () => {
    const over = training.start();
    await settled();
    worker(0).report(3, -90);
    training.cancel();
    expect([training.status, worker(0).signal.aborted]).toEqual(["cancelling", true]);
    await training.start();
    expect(trainers.trainings).toHaveLength(1);
    worker(0).report(4, -80, modelText(5));
    worker(0).end(cancelled);
    await over;
    expect([states(), seedOnStage(), training.ending.failed]).toEqual(["cancelled", 5, false]);
    expect(training.ending.words).toMatch(/You cancelled; this is the best so far/);
  });

  it("leaves the previous model on the stage when it fails", async () => {
    const over = training.start();
    await settled();
    worker(0).fail(new Error("the clips are too short"));
    await over;
    expect([states(), seedOnStage(), training.busy]).toEqual(["failed", 100, false]);
    expect(training.ending).toEqual({ words: "the clips are too short", failed: true });
    expect(clips.locked).toBe(false);
  });

  it("shows the model while it learns: the first takes a clip from the stage, later ones do not", async () => {
    const time = vi.spyOn(performance, "now").mockReturnValue(10_000);
    void training.start();
    await settled();
    clips.show("made-walk-1");
    expect(worker(0).report(1, -90)).toBe(true);
    expect(worker(0).report(2, -80, modelText(5))).toBe(false);
    await settled();
    expect([seedOnStage(), stage.clip]).toEqual([5, null]);
    clips.show("made-walk-1");
    model.couplings.setReading("re-inferred");
    time.mockReturnValue(10_500);
    expect(worker(0).report(3, -70)).toBe(false);
    time.mockReturnValue(11_000);
    expect(worker(0).report(4, -60)).toBe(true);
    worker(0).report(5, -50, modelText(6));
    await settled();
    expect([seedOnStage(), stage.clip]).toEqual([6, "made-walk-1"]);
    time.mockRestore();
  });

  it("says when the page cannot take up one of its models", async () => {
    const over = training.start();
    await settled();
    worker(0).report(1, -90, "broken");
    worker(0).end(done);
    await over;
    expect(notices.all[0]?.title).toBe("The model of seed 5 was not taken up");
    expect(seedOnStage()).toBe(100);
  });
});

describe("several trainings", () => {
  beforeEach(() => begin("seed=5&trainings=3"));

  it("run on all workers, and the best goes on the stage", async () => {
    const over = training.start();
    await settled();
    expect(states()).toBe("running running waiting");
    worker(0).report(9, -30, modelText(5));
    worker(0).end(done);
    await settled();
    expect(states()).toBe("done running running");
    worker(1).report(9, -10, modelText(6));
    worker(1).end(done);
    worker(2).report(9, -20, modelText(7));
    worker(2).end(done);
    await over;
    expect(training.runs.map(({ settings }) => settings.seed)).toEqual([5, 6, 7]);
    expect([seedOnStage(), training.chosen?.settings.seed]).toEqual([6, 6]);
    expect(training.ending.words).toBe("3 done. The best, seed 6, is on the stage.");
  });

  it("keep finished and best models when they are cancelled", async () => {
    const over = training.start();
    await settled();
    worker(0).report(9, -30, modelText(5));
    training.cancel();
    worker(0).end(cancelled);
    worker(1).end(done);
    await over;
    expect(states()).toBe("cancelled done cancelled");
    expect(training.runs[2]?.ending).toBe("You cancelled before it began.");
    expect([seedOnStage(), training.ending.words]).toEqual([
      5,
      "1 done, 2 cancelled. The best so far, seed 5, is on the stage.",
    ]);
  });

  it("continue on a new worker when one dies", async () => {
    const over = training.start();
    await settled();
    worker(0).report(9, -1, modelText(5));
    worker(0).die(new Error("the worker that computed it stopped"));
    await settled();
    expect([states(), trainers.dismissed]).toEqual(["failed running running", 1]);
    worker(1).report(9, -20, modelText(6));
    worker(1).end(done);
    worker(2).end(done);
    await over;
    // A failed run goes on the stage only when there is no other.
    expect([seedOnStage(), states()]).toEqual([6, "failed done done"]);
    expect(training.ending.words).toBe("2 done, 1 failed. The best, seed 6, is on the stage.");
  });

  it("show the run that the visitor has chosen, also when another is better", async () => {
    const over = training.start();
    await settled();
    worker(0).report(9, -30, modelText(5));
    worker(1).report(9, -10, modelText(6));
    const [first] = training.runs;
    if (first) void training.choose(first);
    for (const index of [0, 1]) worker(index).end(done);
    await settled();
    worker(2).end(done);
    await over;
    expect([seedOnStage(), training.chosen?.settings.seed]).toEqual([5, 5]);
    const second = training.runs[1];
    if (second) void training.choose(second);
    await settled();
    expect(seedOnStage()).toBe(6);
  });

  it("with other settings join the session, and can be removed when all are over", async () => {
    settings.change({ trainings: 1 });
    const over = training.start();
    await settled();
    settings.change({ latent: 2, asInPapers: true });
    await training.start();
    await settled();
    expect([states(), training.asked.length]).toEqual(["running running", 2]);
    expect(worker(0).job.settings).toMatchObject({ poseWeight: "balanced" });
    expect(worker(1).job.settings).toMatchObject({ poseWeight: 1, ownRollouts: false });
    worker(0).end(done);
    await settled();
    const [first] = training.runs;
    expect([training.busy, first && training.canRemove(first)]).toEqual([true, false]);
    worker(1).report(3, -5, modelText(8));
    worker(1).end(done);
    await over;
    expect([seedOnStage(), worker(1).job.settings.latent]).toEqual([8, 2]);
    training.clear();
    expect([training.runs, training.chosen, training.charted]).toEqual([[], null, null]);
    expect(seedOnStage()).toBe(8);
  });
});

describe("by default", () => {
  it("the page trains from as many seeds as there are cores, at most four", async () => {
    for (const [cores, trainings] of [
      [1, 1],
      [3, 3],
      [12, 4],
    ] as const) {
      await begin("seed=5", cores);
      void training.start();
      await settled();
      expect([training.count, trainers.trainings.length]).toEqual([trainings, trainings]);
    }
  });

  it("a model that keeps moving is shown, and the page says why one of a higher bound is not", async () => {
    await begin("seed=5", 2);
    const over = training.start();
    await settled();
    worker(0).report(9, -10, modelText(5), STANDS_STILL);
    worker(1).report(9, -30, modelText(6));
    for (const index of [0, 1]) worker(index).end(done);
    await over;
    expect(seedOnStage()).toBe(6);
    expect(training.ending.words).toBe(
      "2 done. The best, seed 6, is on the stage: it keeps moving, while seed 5, whose objective is higher, stands still from 2.4 s on.",
    );
  });

  it("of two models that keep moving, the one whose motion is closer to the clips is shown", async () => {
    await begin("seed=5", 2);
    const over = training.start();
    await settled();
    worker(0).report(9, -10, modelText(5), undefined, 0.04);
    worker(1).report(9, -30, modelText(6), undefined, 0.03);
    for (const index of [0, 1]) worker(index).end(done);
    await over;
    expect(seedOnStage()).toBe(6);
    expect(training.ending.words).toBe(
      "2 done. The best, seed 6, is on the stage: its motion is closer to the clips than that of seed 5, whose objective is higher.",
    );
  });
});

describe("a run that stopped before its bound had settled", () => {
  const used = { cancelled: false, reason: "iterations" as const };
  const settledDown = { cancelled: false, reason: "settled" as const };
  beforeEach(() => begin("seed=5&trainings=1&iterations=600"));

  async function stopped(outcome: typeof used | typeof cancelled | typeof settledDown) {
    const over = training.start();
    await settled();
    worker(0).report(600, -40, modelText(5));
    worker(0).end(outcome);
    await over;
    const [run] = training.runs;
    if (!run) throw new Error("no run");
    return run;
  }

  it("continues in the same worker for as many iterations again, and its course continues", async () => {
    const run = await stopped(used);
    expect(training.canContinue(run)).toBe(true);
    const over = training.continue(run);
    await settled();
    expect([states(), clips.locked, training.canContinue(run)]).toEqual(["running", true, false]);
    expect([worker(1).more, worker(1).worker, worker(1).job]).toEqual([600, worker(0).worker, worker(0).job]);
    worker(1).report(900, -20, modelText(7));
    worker(1).end(used);
    await over;
    expect([states(), seedOnStage(), training.canContinue(run)]).toEqual(["done", 7, true]);
    expect(run.steps.map(({ iteration }) => iteration)).toEqual([600, 900]);
    expect([run.elapsed, run.settings.maxIterations, trainers.hired]).toEqual([1500, 1200, 1]);
  });

  it("can be cancelled and continued to its own end, until its bound has settled", async () => {
    const run = await stopped(cancelled);
    const over = training.continue(run);
    await settled();
    expect([worker(1).more, run.settings.maxIterations]).toEqual([0, 600]);
    training.cancel();
    worker(1).end(cancelled);
    await over;
    expect([states(), training.canContinue(run)]).toEqual(["cancelled", true]);
    const last = training.continue(run);
    await settled();
    worker(2).end(settledDown);
    await last;
    expect([states(), training.canContinue(run)]).toEqual(["done", false]);
  });

  it("is trained again up to where it stopped when its worker does another training", async () => {
    const run = await stopped(cancelled);
    void training.start();
    await settled();
    expect([worker(1).worker, trainers.hired]).toEqual([0, 1]);
    worker(1).end(used);
    await settled();
    const over = training.continue(run);
    await settled();
    expect([worker(2).more, worker(2).job.settings.maxIterations, run.catchingUp]).toEqual([null, 600, true]);
    worker(2).report(300, -50, modelText(8));
    expect([run.steps.length, run.catchingUp, run.elapsed, seedOf(run)]).toEqual([1, true, 600, 5]);
    worker(2).report(600, -40);
    expect([run.steps.length, run.catchingUp]).toEqual([1, false]);
    worker(2).report(900, -20, modelText(9));
    worker(2).end(settledDown);
    await over;
    expect(run.steps.map(({ iteration }) => iteration)).toEqual([600, 900]);
    expect([seedOf(run), run.elapsed, training.canContinue(run)]).toEqual([9, 900, false]);
  });

  it("cannot continue when it has been removed", async () => {
    const run = await stopped(used);
    training.remove(run);
    expect(training.canContinue(run)).toBe(false);
  });

  it("cannot continue when its bound has settled", async () => {
    const run = await stopped(settledDown);
    expect(training.canContinue(run)).toBe(false);
    await training.continue(run);
    expect(trainers.trainings).toHaveLength(1);
  });
});

describe("a model that does not keep moving", () => {
  it("can be trained again with more points, up to the most", async () => {
    const over = training.start();
    await settled();
    worker(0).report(9, -10, modelText(5), STANDS_STILL);
    worker(0).end(done);
    await over;
    for (const points of [20, 30, 40]) {
      const run = training.runs.at(-1);
      if (!run) throw new Error("no run");
      const again = training.trainWithMorePoints(run);
      await settled();
      const { job, end } = worker(trainers.trainings.length - 1);
      const found = [job.settings.dynamicsIps, job.settings.poseIps, job.settings.seed];
      expect(found).toEqual([points, points, 5]);
      end(done);
      await again;
    }
    const last = training.runs.at(-1);
    expect(last && training.morePoints(last)).toBeNull();
  });

  it("can be trained again from the next seeds", async () => {
    await begin("seed=5&trainings=2");
    const over = training.start();
    await settled();
    for (const index of [0, 1]) worker(index).end(done);
    await over;
    void training.trainOtherSeeds();
    await settled();
    expect(trainers.trainings.slice(2).map(({ job }) => job.settings.seed)).toEqual([7, 8]);
  });
});

it("takes a new seed from the engine", async () => {
  await training.newSeed();
  expect(settings.values.seed).toBe(77);
});
