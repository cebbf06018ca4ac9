// What the strip chart shows, as numbers: phase differences and distances over time. No DOM.
import type { Mark, TracePoint } from "./live-store";

/** A difference of two phases in turns, -0.5 to 0.5. */
export function phaseDifference(a: number, b: number): number {
  return ((((a - b + 0.5) % 1) + 1) % 1) - 0.5;
}

/** A line over frames, in pieces: it ends where the value jumps from one end of the scale to the other. */
export type Pieces = { frame: number; value: number }[][];

/** How far each part's phase is ahead of the first part's, in turns. One line for each part but the first. */
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

/** How far each part is from the learned cycle, in radii. */
export function distanceLines(trace: readonly TracePoint[]): Pieces[] {
  const parts = trace.at(-1)?.distances.length ?? 0;
  return Array.from({ length: parts }, (_, part) => [
    trace.flatMap(({ frame, distances }) => {
      const value = distances[part];
      return value === undefined ? [] : [{ frame, value }];
    }),
  ]);
}

/** What the visitor does, in words. */
export function cutsText(marks: readonly Mark[], names: readonly string[]): string | null {
  const cuts = marks.flatMap((mark) => (mark.kind === "cut" && mark.to === null ? [mark] : []));
  const [cut] = cuts;
  if (!cut) return null;
  const of = (part: number) => names[part] ?? "";
  return cuts.length > 1
    ? `${cuts.length} couplings are cut`
    : `${of(cut.target)} does not hear ${of(cut.source)}`;
}
