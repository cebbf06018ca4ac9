// Training: start, follow, cancel.
import type { App } from "../app/app";
import { messageOf } from "../ui/format";
import { partsFor } from "../clips/parts";
import type { Report, TrainingSettings } from "../engine/protocol";
import { bestRun, type Run, seedsFrom } from "./runs";
import { showRollout } from "../couplings/rollouts";
import { followRun, keeping, stageRun } from "./staging";
import { changeSettings } from "../settings/change";

/** The settings of the training that the page's controls ask for; null without a ticked clip. */
export function trainingSettings(app: App): TrainingSettings | null {
  const clip = app.tickedClips()[0];
  if (!clip) return null;
  const { latent, dynamicsIps, poseIps, order, framesPerSecond, seed, maxIterations, parts, split } = app.settings;
  return {
    parts: partsFor(clip.loaded.info, parts, split),
    latent,
    dynamicsIps,
    poseIps,
    order,
    framesPerSecond,
    seed,
    maxIterations,
  };
}

/** Why Train cannot be pressed now; empty when it can. */
export function whyNotTrain(app: App): string {
  if (app.engineState === "loading") return "Getting ready";
  if (!app.engine) return "The model cannot run in this browser";
  if (app.tickedClips().length === 0) return "Tick at least one clip to train on";
  return app.clash ? "The ticked clips do not go together; Clips says why" : "";
}

let lastRun = 0;

function runsFor(app: App, settings: TrainingSettings): Run[] {
  const clips = app
    .tickedClips()
    .map(({ loaded, title, source, first, end }) => ({ id: loaded.id, title, source, first, end }));
  return seedsFrom(settings.seed, app.settings.trainings).map((seed) => ({
    id: ++lastRun,
    settings: { ...settings, seed },
    clips,
    state: "waiting",
    steps: [],
    elapsed: 0,
    ending: "",
    model: null,
  }));
}

/** Carries one run out on a worker of the pool. Its failure is its own. */
async function carryOut(app: App, run: Run, signal: AbortSignal): Promise<void> {
  const report: Report = ({ steps, elapsed, model }) => {
    if (run.state !== "running") return false;
    run.steps.push(...steps);
    run.elapsed = elapsed;
    if (model) run.model = model;
    app.tellSoon("training");
    return followRun(app, run);
  };
  try {
    const outcome = await app.pool!.run((worker) => {
      run.state = "running";
      app.tell("training");
      return worker.train({ clips: run.clips, settings: run.settings }, report, signal);
    }, signal);
    run.state = outcome.cancelled ? "cancelled" : "done";
    run.ending = outcome.reason;
  } catch (problem) {
    const stopped = problem === signal.reason;
    run.state = stopped ? "cancelled" : "failed";
    run.ending = stopped ? "You cancelled before it began." : messageOf(problem);
  }
  app.tell("training");
}

/** Trains from as many seeds as the settings ask for, and takes the best up. While others train, these are added to them. */
export async function train(app: App): Promise<void> {
  const settings = trainingSettings(app);
  if (!app.pool || !settings || app.training.status === "cancelling" || whyNotTrain(app)) return;
  const asked = runsFor(app, settings);
  app.runs = [...app.runs, ...asked];
  const begins = !app.busy;
  if (begins) {
    app.training = {
      status: "running",
      runs: [],
      stop: new AbortController(),
      work: [],
      picked: false,
      ending: "",
      failed: false,
    };
    app.chosen = asked[0]!;
  }
  const { runs, stop, work } = app.training;
  runs.push(...asked);
  app.tell("training");
  work.push(...asked.map((run) => carryOut(app, run, stop.signal)));
  if (!begins) return; // Whoever began awaits these too.
  for (let awaited = 0; awaited < work.length; ) {
    awaited = work.length;
    await Promise.all(work);
  }
  const kept = runs.filter(({ model }) => model !== null);
  const best = bestRun(kept.filter(({ state }) => state !== "failed")) ?? bestRun(kept);
  const { picked } = app.training;
  if (best && !picked) await stageRun(app, best, keeping(app));
  if (!best) showRollout(app);
  Object.assign(app.training, { status: "idle", ...ending(runs, picked ? null : best) });
  app.tell("training");
}

/** What became of the runs, in words. */
function ending(runs: readonly Run[], best: Run | null): { ending: string; failed: boolean } {
  const failed = runs.filter(({ state }) => state === "failed");
  if (failed.length === runs.length) return { ending: failed[0]!.ending, failed: true };
  if (runs.length === 1) return { ending: runs[0]!.ending, failed: false };
  const count = (state: Run["state"]) => runs.filter((run) => run.state === state).length;
  const counts = (["done", "cancelled", "failed"] as const)
    .filter((state) => count(state) > 0)
    .map((state) => `${count(state)} ${state}`);
  const shown = best ? ` The best so far, seed ${best.settings.seed}, is on the stage.` : "";
  return {
    ending: `${counts.join(", ")}.${count("cancelled") > 0 ? shown : shown.replace(" so far", "")}`,
    failed: false,
  };
}

/** Stops all runs. Each that has begun keeps its best so far. */
export function cancelTraining(app: App): void {
  if (app.training.status !== "running") return;
  app.training.status = "cancelling";
  app.training.stop.abort();
  app.tell("training");
}

export async function newSeed(app: App): Promise<void> {
  if (app.engine) changeSettings(app, { seed: await app.engine.freshSeed() });
}
