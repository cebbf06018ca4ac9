import { beforeEach, describe, expect, it, vi } from "vitest";
import { HeldLab } from "../couplings/lab.fake";
import { bvhText, modelText, MOVES_ON, progress, STANDS_STILL } from "../engine/documents.fake";
import { HeldWorkers } from "../engine/held.fake";
import type { Run } from "./runs";
import { TrainingStore } from "./training-store";

/** Trainings of some milliseconds. */
const SMALL = "iterations=10&latent=1&order=1&dynamics=2&poses=2&fps=5&papers=1&frames=60";

let { workers, settings, stage, clips, notices, model } = new HeldLab();
let training: TrainingStore;

async function begin(fragment = "", width = 2, loaded = (): unknown => clips.loadSamples()): Promise<void> {
  const lab = new HeldLab(`${fragment}&${SMALL}`, new HeldWorkers(width));
  ({ workers, settings, stage, clips, notices, model } = lab);
  workers.bring("walk-1", "walk-2");
  workers.hold("train");
  training = new TrainingStore(lab.store, settings, clips, model, notices);
  await lab.start(modelText(100));
  await loaded();
}
beforeEach(() => begin("seed=5&trainings=1"));

const states = () => training.runs.map(({ state }) => state).join(" ");
const seedOf = ({ model }: Run) => model && JSON.parse(model.text).provenance.settings.seed;
const seedOnStage = () => model.model?.info.provenance.settings.seed;
const worker = (index: number) => workers.held("train")[index] ?? expect.fail(`no training ${index}`);
/** Sends a report, with the best model so far if it is given. Returns whether the page asks for the best model. */
function report(index: number, iteration: number, bound: number, text?: string, more = {}): boolean {
  const found = text === undefined ? null : { text, latents: [], health: MOVES_ON, error: -bound, ...more };
  const step = progress(iteration, bound);
  return worker(index).given[1]({ steps: [step], progress: step, elapsed: iteration, found }) === true;
}
/** The run that the library shows: its motion ends best, then its error is the smallest. */
const value = ({ model }: Run) => 1e9 * (model?.health?.rank ?? 0) - (model?.error ?? Infinity);
const best = () => training.runs.toSorted((a, b) => value(b) - value(a))[0];
const done = { cancelled: false, reason: null };

describe("a training", () => {
  it("trains on the ticked clips with the settings now, and its model is on the stage", async () => {
    const over = training.start();
    await workers.settled();
    expect(states()).toBe("running");
    expect([training.busy, clips.locked, training.learning?.settings.seed]).toEqual([true, true, 5]);
    const [job] = worker(0).given;
    expect(job.clips.map(({ id, source }) => [id, source])).toEqual([
      [1, { sample: "walk-1" }],
      [2, { sample: "walk-2" }],
    ]);
    expect([job.settings.seed, job.settings.latent, job.settings.parts.length]).toEqual([5, 1, 2]);
    worker(0).go();
    await over;
    expect([states(), seedOnStage(), training.chosen?.settings.seed]).toEqual(["done", 5, 5]);
    expect(training.chosen?.steps.at(-1)?.iteration).toBe(10);
    expect(model.model?.info.sequences.map(({ name }) => name.slice(0, 6))).toEqual(["walk-1", "walk-2"]);
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
    expect(workers.asked("train")).toEqual([]);
    await clips.open(new File([bvhText()], "a.bvh"), false);
    await clips.tick("made-walk-1", true);
    expect(training.whyNot()).toMatch(/do not go together/);
  });

  it("says once for all seeds what the visitor should know, unless a clip in the list says it", async () => {
    settings.change({ trainings: 2 });
    const text = bvhText().replace("Frames: 60", "Frames: 61");
    for (const name of ["a.bvh", "b.bvh"]) await clips.open(new File([text], name), name === "a.bvh");
    workers.letGo("train");
    await training.start();
    expect([states(), clips.all.at(-1)?.loaded.info.warnings.length]).toEqual(["done done", 1]);
    const twice = "The clip b has the same content as a, so these frames count twice.";
    expect(notices.all.map(({ text }) => text)).toEqual([twice]);
  });

  it("keeps its best model when it is cancelled", async () => {
    const over = training.start();
    await workers.settled();
    training.cancel();
    expect([training.status, worker(0).given[2].aborted]).toEqual(["cancelling", true]);
    await training.start();
    expect(workers.asked("train")).toHaveLength(1);
    await over;
    expect([states(), seedOnStage(), training.ending.failed]).toEqual(["cancelled", 5, false]);
    expect(training.ending.words).toMatch(/You cancelled; this is the best so far/);
  });

  it("leaves the previous model on the stage when it fails", async () => {
    workers.letGo("train");
    for (const { key } of clips.all) clips.cut(key, 0, 10);
    await training.start();
    expect([states(), seedOnStage(), training.busy]).toEqual(["failed", 100, false]);
    const { words, failed } = training.ending;
    expect([words, failed]).toEqual([expect.stringMatching(/^the clip walk-1 .* has 1 frame;/), true]);
    expect(clips.locked).toBe(false);
  });

  it("shows the model while it learns: the first takes a clip from the stage, later ones do not", async () => {
    const time = vi.spyOn(performance, "now").mockReturnValue(10_000);
    void training.start();
    await workers.settled();
    clips.show("made-walk-1");
    expect(report(0, 1, -90)).toBe(true);
    expect(report(0, 2, -80, modelText(5))).toBe(false);
    await workers.settled();
    expect([seedOnStage(), stage.clip]).toEqual([5, null]);
    clips.show("made-walk-1");
    model.couplings.setReading("re-inferred");
    time.mockReturnValue(10_500);
    expect(report(0, 3, -70)).toBe(false);
    time.mockReturnValue(11_000);
    expect(report(0, 4, -60)).toBe(true);
    report(0, 5, -50, modelText(6));
    await workers.settled();
    expect([seedOnStage(), stage.clip]).toEqual([6, "made-walk-1"]);
    time.mockRestore();
  });

  it("says when the page cannot take up one of its models", async () => {
    const over = training.start();
    await workers.settled();
    report(0, 1, -90, "broken");
    worker(0).end(done);
    await over;
    expect(notices.all[0]?.title).toBe("The model of seed 5 was not taken up");
    expect(seedOnStage()).toBe(100);
  });
});

describe("several trainings", () => {
  beforeEach(() => settings.change({ trainings: 3 }));

  it("run on all workers, and the best goes on the stage", async () => {
    const over = training.start();
    await workers.settled();
    expect(states()).toBe("running running waiting");
    worker(0).go();
    await workers.settled();
    expect(states()).toBe("done running running");
    for (const index of [1, 2]) {
      worker(index).go();
      await workers.settled();
    }
    await over;
    expect(training.runs.map(({ settings }) => settings.seed)).toEqual([5, 6, 7]);
    const seed = seedOnStage();
    expect([training.chosen, seed]).toEqual([best(), best()?.settings.seed]);
    expect(training.ending.words).toMatch(`3 done. The best, seed ${seed}, is on the stage`);
  });

  it("keep finished and best models when they are cancelled", async () => {
    await begin("seed=5&trainings=3", 1);
    const over = training.start();
    await workers.settled();
    worker(0).go();
    await workers.settled();
    training.cancel();
    await over;
    expect(states()).toBe("done cancelled cancelled");
    expect(training.runs.map(({ model, steps }) => [model !== null, steps.at(-1)?.iteration])).toEqual([
      [true, 10],
      [true, 1],
      [false, undefined],
    ]);
    expect(training.runs[2]?.ending).toBe("You cancelled before it began.");
    const seed = seedOnStage();
    expect([training.chosen, seed]).toEqual([best(), best()?.settings.seed]);
    expect(training.ending.words).toMatch(`1 done, 2 cancelled. The best so far, seed ${seed}, is on`);
  });

  it("continue on a new worker when one dies", async () => {
    const over = training.start();
    await workers.settled();
    report(0, 9, 1e6, modelText(5));
    worker(0).die(new Error("the worker that computed it stopped"));
    await workers.settled();
    expect([states(), workers.dismissed]).toEqual(["failed running running", 1]);
    worker(1).go();
    worker(2).end(done);
    await over;
    // A failed run goes on the stage only when there is no other.
    expect([seedOnStage(), states()]).toEqual([6, "failed done done"]);
    expect(training.ending.words).toBe("2 done, 1 failed. The best, seed 6, is on the stage.");
  });

  it("show the run that the visitor has chosen, also when another is better", async () => {
    const over = training.start();
    await workers.settled();
    report(0, 9, -30, modelText(5));
    report(1, 9, -10, modelText(6));
    const [first] = training.runs;
    if (first) void training.choose(first);
    for (const index of [0, 1, 2]) {
      worker(index).go();
      await workers.settled();
    }
    await over;
    expect([seedOnStage(), training.chosen, best() === first]).toEqual([5, first, false]);
    const second = training.runs[1];
    if (second) void training.choose(second);
    await workers.settled();
    expect(seedOnStage()).toBe(6);
  });

  it("with other settings join the session, and can be removed when all are over", async () => {
    settings.change({ trainings: 1, asInPapers: false });
    const over = training.start();
    await workers.settled();
    settings.change({ latent: 2, asInPapers: true });
    await training.start();
    await workers.settled();
    expect([states(), training.asked.length]).toEqual(["running running", 2]);
    expect(worker(0).given[0].settings).toMatchObject({ poseWeight: "balanced" });
    expect(worker(1).given[0].settings).toMatchObject({ poseWeight: 1, ownRollouts: false });
    report(0, 9, 1e9, modelText(5), { health: STANDS_STILL, error: 1e9 });
    worker(0).end(done);
    await workers.settled();
    const [first] = training.runs;
    expect([training.busy, first && training.canRemove(first)]).toEqual([true, false]);
    worker(1).go();
    await over;
    // Objectives of other weights are not compared.
    expect(training.ending.words).toMatch(/^2 done\. The best, seed 5, is on the stage\.$/);
    expect(model.model?.info.provenance.settings.latent).toBe(2);
    training.clear();
    expect([training.runs, training.chosen, training.charted]).toEqual([[], null, null]);
    expect(model.model?.info.provenance.settings.latent).toBe(2);
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
      await workers.settled();
      expect([training.count, workers.asked("train").length]).toEqual([trainings, trainings]);
    }
  });

  it("a model that keeps moving is shown, and the page says why one of a higher objective is not", async () => {
    await begin("seed=5");
    const over = training.start();
    await workers.settled();
    report(0, 9, -10, modelText(5), { health: STANDS_STILL });
    report(1, 9, -30, modelText(6));
    for (const index of [0, 1]) worker(index).end(done);
    await over;
    expect(seedOnStage()).toBe(6);
    expect(training.ending.words).toBe(
      "2 done. The best, seed 6, is on the stage: it keeps moving, while seed 5, whose objective is higher, stands still from 2.4 s on.",
    );
  });

  it("of two models that keep moving, the one whose motion is closer to the clips is shown", async () => {
    await begin("seed=5");
    const over = training.start();
    await workers.settled();
    report(0, 9, -10, modelText(5), { error: 0.04 });
    report(1, 9, -30, modelText(6), { error: 0.03 });
    for (const index of [0, 1]) worker(index).end(done);
    await over;
    expect(seedOnStage()).toBe(6);
    expect(training.ending.words).toBe(
      "2 done. The best, seed 6, is on the stage: its motion is closer to the clips than that of seed 5, whose objective is higher.",
    );
  });
});

describe("a run that stopped before its bound had settled", () => {
  const iterations = ({ steps }: Run) => [...new Set(steps.map(({ iteration }) => iteration))];
  const upTo = (last: number) => Array.from({ length: last }, (_, place) => place + 1);

  /** A run that used its iterations, or that the visitor cancelled at the first. */
  async function stopped(cancelled = false): Promise<Run> {
    const over = training.start();
    await workers.settled();
    if (cancelled) training.cancel();
    else worker(0).go();
    await over;
    return training.runs[0] ?? expect.fail("no run");
  }

  it("continues in the same worker for as many iterations again, and its course continues", async () => {
    const run = await stopped();
    expect([training.canContinue(run), iterations(run)]).toEqual([true, upTo(10)]);
    const { elapsed } = run;
    workers.hold("goOn");
    workers.answer("goOn", (real, more, report, signal) =>
      real(more, (sent) => report({ ...sent, elapsed: 900 }), signal),
    );
    const over = training.continue(run);
    await workers.settled();
    expect([states(), clips.locked, training.canContinue(run)]).toEqual(["running", true, false]);
    const [again = expect.fail()] = workers.held("goOn");
    expect([again.given[0], again.worker]).toEqual([10, worker(0).worker]);
    again.go();
    await over;
    expect([states(), training.canContinue(run), iterations(run)]).toEqual(["done", true, upTo(20)]);
    expect(model.model?.info.provenance.iterations).toBe(20);
    expect([run.elapsed, run.settings.maxIterations, workers.hired]).toEqual([elapsed + 900, 20, 1]);
  });

  it("can be cancelled and continued to its own end, until its bound has settled", async () => {
    const run = await stopped(true);
    workers.hold("goOn");
    const over = training.continue(run);
    await workers.settled();
    expect([workers.asked("goOn")[0]?.[0], run.settings.maxIterations]).toEqual([0, 10]);
    training.cancel();
    await over;
    expect([states(), training.canContinue(run), iterations(run)]).toEqual(["cancelled", true, upTo(2)]);
    workers.letGo("goOn");
    workers.answer("goOn", async (real, ...given) => ({ ...(await real(...given)), reason: "settled" }));
    await training.continue(run);
    expect([states(), training.canContinue(run), iterations(run)]).toEqual(["done", false, upTo(10)]);
  });

  it("is trained again up to where it stopped when its worker does another training", async () => {
    const run = await stopped(true);
    const { model: first, elapsed } = run;
    const other = training.start();
    await workers.settled();
    expect([worker(1).worker, workers.hired]).toEqual([0, 1]);
    worker(1).go();
    await other;
    const over = training.continue(run);
    await workers.settled();
    expect([worker(2).given[0].settings.maxIterations, run.catchingUp]).toEqual([10, true]);
    report(2, 0, -50, modelText(8));
    expect([run.steps.length, run.catchingUp, run.elapsed, run.model]).toEqual([1, true, elapsed, first]);
    worker(2).go();
    await over;
    // Both come out the same as a training that was never stopped.
    const bounds = ({ steps }: Run) => steps.map(({ iteration, bound }) => [iteration, bound]);
    expect(bounds(run)).toEqual(bounds(training.runs[1]!));
    expect([seedOf(run), run.model?.text]).toEqual([5, training.runs[1]?.model?.text]);
    expect([run.elapsed >= elapsed, run.catchingUp]).toEqual([true, false]);
  });

  it("has the same model after more iterations, from its own worker or trained again", async () => {
    workers.letGo("train");
    workers.answer("goOn", (real, more, report, signal) =>
      real(more, (sent) => report({ ...sent, elapsed: 900 }), signal),
    );
    const models: unknown[] = [];
    for (const keeps of [true, false]) {
      await training.start();
      const run = training.runs.at(-1)!;
      // Another training takes the worker of the first.
      if (!keeps) await training.start();
      const { elapsed } = run;
      await training.continue(run);
      expect([iterations(run), run.settings.maxIterations]).toEqual([upTo(20), 20]);
      expect(run.elapsed).toBeGreaterThanOrEqual(keeps ? 900 : elapsed);
      models.push(run.model?.text);
    }
    expect([models[1] === models[0], workers.asked("goOn").length]).toEqual([true, 1]);
    expect(workers.asked("train").map(([{ settings, more }]) => [settings.maxIterations, more])).toEqual([
      [10, 0],
      [10, 0],
      [10, 0],
      [10, 10],
    ]);
  });

  it("loses nothing when it is cancelled while it is trained again", async () => {
    const run = await stopped();
    await training.continue(run);
    const other = training.start();
    await workers.settled();
    worker(1).go();
    await other;
    const again = training.continue(run);
    await workers.settled();
    training.cancel();
    await again;
    expect([run.state, iterations(run)]).toEqual(["cancelled", upTo(20)]);
    workers.letGo("train");
    await training.continue(run);
    expect([run.state, iterations(run), run.settings.maxIterations]).toEqual(["done", upTo(30), 30]);
    expect(JSON.parse(run.model!.text).provenance.iterations).toBe(30);
  });

  it("cannot continue when it has been removed", async () => {
    const run = await stopped();
    training.remove(run);
    expect(training.canContinue(run)).toBe(false);
  });

  it("cannot continue when its bound has settled", async () => {
    workers.answer("train", async (real, ...given) => ({ ...(await real(...given)), reason: "settled" }));
    const run = await stopped();
    expect(training.canContinue(run)).toBe(false);
    await training.continue(run);
    expect(workers.asked("train")).toHaveLength(1);
  });
});

describe("a model that does not keep moving", () => {
  it("can be trained again with more points, up to the most", async () => {
    const over = training.start();
    await workers.settled();
    report(0, 9, -10, modelText(5), { health: STANDS_STILL });
    worker(0).end(done);
    await over;
    for (const points of [20, 30, 40]) {
      const run = training.runs.at(-1);
      if (!run) throw new Error("no run");
      const again = training.trainWithMorePoints(run);
      await workers.settled();
      const { given, end } = worker(workers.asked("train").length - 1);
      const { dynamicsIps, poseIps, seed } = given[0].settings;
      expect([dynamicsIps, poseIps, seed]).toEqual([points, points, 5]);
      end(done);
      await again;
    }
    const last = training.runs.at(-1);
    expect(last && training.morePoints(last)).toBeNull();
  });

  it("can be trained again from the next seeds", async () => {
    settings.change({ trainings: 2 });
    const over = training.start();
    await workers.settled();
    for (const index of [0, 1]) worker(index).end(done);
    await over;
    void training.trainOtherSeeds();
    await workers.settled();
    expect(workers.asked("train").map(([job]) => job.settings.seed)).toEqual([5, 6, 7, 8]);
  });
});

it("takes a new seed from the engine", async () => {
  await training.newSeed();
  expect(settings.values.seed).not.toBe(5);
});
