// The changes of a live motion. No DOM.
import type { LiveChange } from "../engine/protocol";

/** Changes that act on all frames after `after`. */
export interface Made {
  after: number;
  changes: readonly LiveChange[];
}

/** Each of these counts. Of the others, only the newest of a subject counts. */
const COUNTED: readonly string[] = ["push", "pull", "drive", "record", "release"];

function subjectOf(change: LiveChange): string {
  const { kind, part, node, source, target } = change as Partial<Record<string, unknown>>;
  return [kind === "nearest" ? "couplings" : kind, part, node, source, target].join();
}

/** The newest change of each subject, and all that count. */
export function newest(changes: readonly LiveChange[]): LiveChange[] {
  const places = new Map(changes.map((change, place) => [subjectOf(change), place]));
  return changes.filter(
    (change, place) => COUNTED.includes(change.kind) || places.get(subjectOf(change)) === place,
  );
}
