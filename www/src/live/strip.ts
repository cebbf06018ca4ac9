// The data of the strip chart: phase differences and distances over time. No DOM.
import type { Mark, TracePoint } from "./live-store";
import { lab } from "../words/lab";

/** A difference of two phases in turns, -0.5 to 0.5. */
export function phaseDifference(a: number, b: number): number {
  return ((((a - b + 0.5) % 1) + 1) % 1) - 0.5;
}

/** A line over frames, in pieces that end where the value jumps between the ends of the scale. */
export type Pieces = { frame: number; value: number }[][];

/** The phase of each part but the first, minus that of the first part, in turns. */
export function phaseLines(trace: readonly TracePoint[]): Pieces[] {
  const parts = trace.at(-1)?.phases.length ?? 0;
  return Array.from({ length: Math.max(0, parts - 1) }, (_, k) => {
    const pieces: Pieces = [];
    let before: number | null = null;
    for (const { frame, phases } of trace) {
      const [first, own] = [phases[0], phases[k + 1]];
      if (first === undefined || own === undefined) continue;
      const value = phaseDifference(own, first);
      if (before === null || Math.abs(value - before) > 0.5) pieces.push([]);
      pieces.at(-1)?.push({ frame, value });
      before = value;
    }
    return pieces;
  });
}

/** The distance of each part from its learned cycle, in radii. */
export function distanceLines(trace: readonly TracePoint[]): Pieces[] {
  const parts = trace.at(-1)?.distances.length ?? 0;
  return Array.from({ length: parts }, (_, part) => [
    trace.flatMap(({ frame, distances }) => {
      const value = distances[part];
      return value === undefined ? [] : [{ frame, value }];
    }),
  ]);
}

/**
 * A sentence about the couplings that are cut now, or about the part that the visitor or a recording moves; null
 * without one.
 */
export function actionText(marks: readonly Mark[], names: readonly string[]): string | null {
  const cuts = marks.flatMap((mark) => (mark.kind === "cut" && mark.to === null ? [mark] : []));
  const name = (part: number) => names[part] ?? "";
  const words = lab().live;
  const [cut] = cuts;
  if (cut) return cuts.length > 1 ? words.cuts(cuts.length) : words.cut(name(cut.source), name(cut.target));
  const mover = marks.findLast((mark) =>
    mark.kind === "push" ? mark.held === true : mark.kind !== "cut" && mark.to === null,
  );
  if (!mover || mover.kind === "cut") return null;
  return mover.kind === "record"
    ? words.recorded(name(mover.part), mover.title)
    : words.driven(name(mover.part));
}
