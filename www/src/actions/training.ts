// Training: start, follow, cancel.
import type { App } from "../app";
import { partsFor } from "../parts";
import type { TrainingReport, TrainingSettings } from "../protocol";
import { messageOf, showRollout, takeUp } from "./couplings";
import { changeSettings } from "./settings";

/** The settings of the training that the page's controls ask for; null without a ticked clip. */
export function trainingSettings(app: App): TrainingSettings | null {
  const clip = app.tickedClips()[0];
  if (!clip) return null;
  const { latent, dynamicsIps, poseIps, order, framesPerSecond, seed, maxIterations, parts, split } = app.settings;
  return {
    parts: partsFor(clip.loaded.info, parts, split),
    latent, dynamicsIps, poseIps, order, framesPerSecond, seed, maxIterations,
  };
}

/** Why Train cannot be pressed now; empty when it can. */
export function whyNotTrain(app: App): string {
  if (app.engineState === "loading") return "Getting ready";
  if (!app.engine) return "The model cannot run in this browser";
  if (app.tickedClips().length === 0) return "Tick at least one clip to train on";
  return app.clash ? "The ticked clips do not go together; Clips says why" : "";
}

export async function train(app: App): Promise<void> {
  const settings = trainingSettings(app);
  if (!app.engine || !settings || app.busy || whyNotTrain(app)) return;
  const parts = settings.parts.map(({ name }) => name);
  app.training = { status: "running", steps: [], parts, elapsed: 0, ending: "", failed: false };
  app.tell("training");
  const clips = app.tickedClips().map(({ loaded, first, end }) => ({ id: loaded.id, first, end }));
  // The first snapshot takes the stage; after that a clip that is being looked at may keep it.
  let onStage = false;
  const follow = (report: TrainingReport) => {
    if (!app.busy) return;
    app.training.steps.push(...report.steps);
    app.training.elapsed = report.elapsed;
    if (report.snapshot) {
      takeUp(app, report.snapshot, { clip: onStage });
      onStage = true;
    }
    app.tell("training");
  };
  try {
    const outcome = await app.engine.train({ clips, settings, frames: app.settings.frames }, follow);
    Object.assign(app.training, { status: "idle", ending: outcome.reason });
    takeUp(app, outcome.result, { clip: onStage });
  } catch (problem) {
    Object.assign(app.training, { status: "idle", ending: messageOf(problem), failed: true });
    showRollout(app);
  }
  app.tell("training");
}

export function cancelTraining(app: App): void {
  if (app.training.status !== "running") return;
  app.training.status = "cancelling";
  void app.engine?.cancelTraining();
  app.tell("training");
}

export async function newSeed(app: App): Promise<void> {
  if (app.engine) changeSettings(app, { seed: await app.engine.freshSeed() });
}
