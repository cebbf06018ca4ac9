// The inducing point that the visitor points at: its poses, and its weight in each frame.
import type { ModelStore } from "../couplings/model-store";
import type { EngineStore } from "../engine/engine-store";
import { Latest } from "../engine/latest";
import type { InducingPoint, InducingReport, ModelView } from "../engine/protocol";
import type { Marks, StageStore } from "../stage/stage-store";
import { Store } from "../ui/store";

export class PointingStore extends Store {
  readonly #stage: StageStore;
  #model: ModelView | null = null;
  #point: InducingPoint | null = null;
  #report: InducingReport | null = null;
  readonly #reports: Latest<InducingPoint, InducingReport | null>;

  constructor(engine: EngineStore, model: ModelStore, stage: StageStore) {
    super();
    this.#stage = stage;
    this.#reports = new Latest(
      async (point) => (await engine.engine?.inducing(point, model.rolloutRequest())) ?? null,
      (report, point) => {
        if (samePoint(this.#point, point)) this.#show(report);
      },
      // The point belonged to a model that was replaced.
      () => {},
    );
    model.on(() => {
      if (model.model === this.#model) return;
      this.#model = model.model;
      this.pointAt(null);
    });
  }

  get point(): InducingPoint | null {
    return this.#point;
  }

  /** The poses and weights of the point; null before they have arrived. */
  get report(): InducingReport | null {
    return this.#report;
  }

  pointAt(point: InducingPoint | null): void {
    if (samePoint(this.#point, point)) return;
    this.#point = point;
    if (point) {
      this.#reports.request(point);
      this.changed();
    } else {
      this.#show(null);
    }
  }

  #show(report: InducingReport | null): void {
    this.#report = report;
    this.#stage.mark(report && marksOf(report));
    this.changed();
  }
}

export function samePoint(a: InducingPoint | null, b: InducingPoint | null): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}

/** A dynamics point marks the pose of its input, drawn pale, and the pose that it predicts. */
function marksOf({ point, poses, frames }: InducingReport): Marks {
  const targets =
    point.kind === "pose"
      ? [{ part: point.part, opacity: 1 }]
      : [
          { part: point.source, opacity: 0.5 },
          { part: point.target, opacity: 1 },
        ];
  return {
    poses: poses.flatMap((positions, i) => {
      const target = targets[i];
      return target ? [{ ...target, positions }] : [];
    }),
    part: point.kind === "pose" ? point.part : point.source,
    frames,
  };
}
