// Sliders: other couplings, another reading, another start; and the rollouts they ask for.
import type { App } from "../app/app";
import { messageOf } from "../ui/format";
import { Latest } from "../engine/latest";
import type { OpenedModel, Reading, RolloutRequest, RolloutResult } from "../engine/protocol";
import { changeSettings } from "../settings/change";

const queues = new WeakMap<App, Latest<RolloutRequest, RolloutResult>>();

/** A measure in the browser's performance timeline: from the change of a coupling to the new motion. */
export const REDRAW_MEASURE = "coupling-redraw";

function queueOf(app: App): Latest<RolloutRequest, RolloutResult> {
  let queue = queues.get(app);
  if (!queue) {
    queue = new Latest(
      (request) => app.engine!.rollout(request),
      (result) => applyRollout(app, result),
      (problem) => app.notify({ kind: "error", title: "This rollout failed", text: messageOf(problem), at: null }),
    );
    queues.set(app, queue);
  }
  return queue;
}

function applyRollout(app: App, result: RolloutResult): void {
  if (result.revision !== app.model?.revision) return;
  app.rollout = result;
  if (!result.request.alpha) app.learned = result;
  showRollout(app);
  if (performance.getEntriesByName("coupling-change").length > 0) {
    performance.measure(REDRAW_MEASURE, "coupling-change");
    performance.clearMarks("coupling-change");
  }
}

/** Shows the rollout, unless a clip is being looked at. */
export function showRollout(app: App, evenOverClip = false): void {
  const { model, rollout } = app;
  if (!model || !rollout) return;
  if (app.shown?.kind === "clip" && !evenOverClip) return app.tell("rollout");
  const { info } = model;
  app.show({
    kind: "model",
    figure: info.figure,
    joints: info.joints.map(({ name }) => name),
    parts: info.parts,
    motion: rollout.motion,
  });
  app.tell("rollout");
}

/** Rolls out under the settings now; older requests that still wait are dropped. */
export function rollOut(app: App): void {
  if (!app.engine || !app.model) return;
  queueOf(app).request(app.rolloutRequest());
  app.tell("rollout");
}

export function setCoupling(app: App, source: number, target: number, alpha: number): void {
  if (!app.model) return;
  const learned = app.model.info.alpha[source]?.[target];
  const changed = { ...app.settings.alpha };
  // Within half a percent of the learned value is back at it.
  if (learned !== undefined && Math.abs(Math.log(alpha / learned)) < 0.005) delete changed[`${source}.${target}`];
  else changed[`${source}.${target}`] = alpha;
  performance.clearMarks("coupling-change");
  performance.mark("coupling-change");
  changeSettings(app, { alpha: changed });
  if (app.shown?.kind === "clip") showRollout(app, true);
  rollOut(app);
}

export function resetCoupling(app: App, source: number, target: number): void {
  const changed = { ...app.settings.alpha };
  delete changed[`${source}.${target}`];
  changeSettings(app, { alpha: changed });
  rollOut(app);
}

export function resetCouplings(app: App): void {
  changeSettings(app, { alpha: {} });
  rollOut(app);
}

export function setReading(app: App, reading: Reading): void {
  changeSettings(app, { reading });
  rollOut(app);
}

/** Starts the rollouts from another training sequence. */
export async function setStart(app: App, start: number): Promise<void> {
  changeSettings(app, { start });
  if (!app.engine || !app.model) return;
  // The ghost starts there too.
  const revision = app.model.revision;
  const learned = await app.engine.rollout({ ...app.rolloutRequest(), alpha: null, reading: "as learned" });
  if (revision === app.model?.revision) app.learned = learned;
  rollOut(app);
}

/** Takes up a model that the worker has opened or trained. A clip that is being looked at stays on the stage when asked to. */
export function takeUp(
  app: App,
  { model, rollout }: OpenedModel,
  keep: { couplings?: boolean; clip?: boolean } = {},
): void {
  queueOf(app).drop();
  app.model = model;
  app.learned = rollout;
  app.rollout = rollout;
  app.pointing = null;
  app.pointed = null;
  const parts = model.info.parts.length;
  const fits = Object.keys(app.settings.alpha).every((pair) => pair.split(".").every((part) => Number(part) < parts));
  if (!keep.couplings || !fits) changeSettings(app, { alpha: {} });
  if (app.settings.start >= model.info.sequences.length) changeSettings(app, { start: 0 });
  app.tell("model", "pointed");
  showRollout(app, !keep.clip);
  if (app.altered || app.settings.start > 0) void setStart(app, app.settings.start);
}
