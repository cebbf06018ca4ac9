// Pointing at an inducing point: asks for its pose and the frames it speaks for.
import type { App } from "../app/app";
import { Latest } from "../engine/latest";
import type { InducingPoint, InducingReport } from "../engine/protocol";

const queues = new WeakMap<App, Latest<InducingPoint, InducingReport>>();

function same(a: InducingPoint | null, b: InducingPoint | null): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}

export function pointAt(app: App, point: InducingPoint | null): void {
  if (same(app.pointing, point)) return;
  app.pointing = point;
  if (!point) app.pointed = null;
  app.tell("pointed");
  if (!point || !app.engine) return;
  let queue = queues.get(app);
  if (!queue) {
    queue = new Latest(
      (wanted) => app.engine!.inducing(wanted, app.rolloutRequest()),
      (report, wanted) => {
        if (!same(app.pointing, wanted)) return;
        app.pointed = report;
        app.tell("pointed");
      },
      // The point belonged to a model that was replaced meanwhile.
      () => {},
    );
    queues.set(app, queue);
  }
  queue.request(point);
}
