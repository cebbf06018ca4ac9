// What a visitor does with the trainings of this visit: look at one, remove one, clear all.
import type { App, Training } from "../app/app";
import { messageOf } from "../ui/format";
import { bestRun, isOver, type Run } from "./runs";
import { takeUp } from "../couplings/rollouts";

/** Milliseconds between two models of trainings under way on the stage. */
const EVERY = 1000;

interface Staging {
  /** What is being taken up now; the next waits for it, so that worker and page always hold the same model. */
  turn: Promise<void>;
  asked: number;
  /** The model of a run that was taken up last, during which training, and when. */
  model: Run["model"];
  during: Training | null;
  at: number;
}

const stagings = new WeakMap<App, Staging>();

function stagingOf(app: App): Staging {
  let staging = stagings.get(app);
  if (!staging) {
    staging = { turn: Promise.resolve(), asked: 0, model: null, during: null, at: -Infinity };
    stagings.set(app, staging);
  }
  return staging;
}

/** Takes the newest model of a run up on the stage; of several asked for in quick succession only the last. */
export function stageRun(app: App, run: Run, keep: Parameters<typeof takeUp>[2] = {}): Promise<void> {
  const staging = stagingOf(app);
  const { model } = run;
  const asked = ++staging.asked;
  app.chosen = run;
  app.tell("training");
  staging.during = app.training;
  staging.at = Infinity;
  staging.turn = staging.turn
    .then(async () => {
      if (asked !== staging.asked || !model || !app.engine) return;
      try {
        const opened = await app.engine.openModel(model.text, app.settings.frames);
        opened.model.trainingLatents = model.latents;
        takeUp(app, opened, keep);
        staging.model = model;
      } catch (problem) {
        app.notify({
          kind: "error",
          title: `The model of seed ${run.settings.seed} was not taken up`,
          text: messageOf(problem),
          at: null,
        });
      }
    })
    .finally(() => {
      if (asked === staging.asked) staging.at = performance.now();
    });
  return staging.turn;
}

/**
 * Keeps the stage with the best run under way, or the one that the visitor chose, about once a second.
 * Answers whether this run is to send a newer model.
 */
export function followRun(app: App, run: Run): boolean {
  const staging = stagingOf(app);
  const { training } = app;
  if (!app.busy || performance.now() - staging.at < EVERY) return false;
  const leader = training.picked ? app.chosen : bestRun(training.runs);
  if (!leader || leader.model === null || leader.model === staging.model) return leader === run;
  void stageRun(app, leader, keeping(app));
  return false;
}

/** After the first model of a training, a clip that is looked at may keep the stage, and the visitor's couplings hold. */
export function keeping(app: App): { clip: boolean; couplings: boolean } {
  const later = stagingOf(app).during === app.training;
  return { clip: later, couplings: later };
}

/** The visitor wants to see this run, whatever the others do. */
export function chooseRun(app: App, run: Run): void {
  app.training.picked = app.busy;
  if (run.model) return void stageRun(app, run);
  app.chosen = run;
  app.tell("training");
}

/** Whether nothing needs the run any more: the best of a training is chosen among all of its runs. */
export function canRemove(app: App, run: Run): boolean {
  return isOver(run) && !(app.busy && app.training.runs.includes(run));
}

export function removeRun(app: App, run: Run): void {
  if (!canRemove(app, run)) return;
  app.runs = app.runs.filter((other) => other !== run);
  if (app.chosen === run) {
    app.chosen = null;
    app.training.picked = false;
  }
  app.tell("training");
}

/** Removes all runs that can be. */
export function clearRuns(app: App): void {
  app.runs.forEach((run) => removeRun(app, run));
}
