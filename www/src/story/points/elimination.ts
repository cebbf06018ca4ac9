// Which inducing points the walk needs: one after the other is taken away, always the one that costs least.
import type { ModelInfo } from "../../engine/protocol";
import type { KeptPoints, KeptReport } from "../../engine/whole-protocol";

/** The walk with some of the points. */
export interface Trial {
  points: LegPoints;
  count: number;
  bound: number;
  /** Mean distance of the joints from the walk with all points, in metres. */
  error: number;
  stumbles: boolean;
  report: KeptReport;
}

/** The points of the legs: their poses, and the steps by which the legs predict themselves. */
export interface LegPoints {
  poses: readonly number[];
  steps: readonly number[];
}

export const LEGS = 0;

const upTo = (count: number) => Array.from({ length: count }, (_, i) => i);

export function allPoints(info: ModelInfo): LegPoints {
  return { poses: upTo(info.parts[LEGS]!.poseIps), steps: upTo(info.dynamicsIps[LEGS]![LEGS]!) };
}

export const count = ({ poses, steps }: LegPoints): number => poses.length + steps.length;

/** The points that the whole model keeps: of all other maps every point. */
export function keptOf(info: ModelInfo, { poses, steps }: LegPoints): KeptPoints {
  return {
    poses: info.parts.map(({ poseIps }, part) => (part === LEGS ? [...poses] : upTo(poseIps))),
    dynamics: info.dynamicsIps.map((row, source) =>
      row.map((points, target) => (source === LEGS && target === LEGS ? [...steps] : upTo(points))),
    ),
  };
}

export type PointKind = keyof LegPoints;

/** The points without one, or with one more. A map keeps at least one point: null. */
export function toggled(points: LegPoints, kind: PointKind, index: number): LegPoints | null {
  const kept = points[kind];
  const next = kept.includes(index)
    ? kept.filter((point) => point !== index)
    : [...kept, index].sort((a, b) => a - b);
  return next.length === 0 ? null : { ...points, [kind]: next };
}

/** All choices with one point less. */
export function choices(points: LegPoints): LegPoints[] {
  const without = (kind: PointKind) => points[kind].map((index) => toggled(points, kind, index));
  return [...without("poses"), ...without("steps")].filter((choice) => choice !== null);
}

/** The choice whose bound is highest. */
export function bestChoice(all: readonly LegPoints[], bounds: readonly number[]): LegPoints {
  return all[bounds.indexOf(Math.max(...bounds))]!;
}
