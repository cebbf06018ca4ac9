// The combinations of the primitives of a library, and their titles. No rendering, no worker.
import type { LibraryInfo } from "../engine/library-protocol";
import { shownPart } from "../words/lab";

/** The data type of a dragged primitive. */
export const DRAG_TYPE = "application/x-vcgpdm-primitive";

/** The indices of the primitives of a part. */
export function primitivesOf({ primitives }: LibraryInfo, part: number): number[] {
  return primitives.flatMap((primitive, index) => (primitive.part === part ? [index] : []));
}

/** At most `most` combinations of one primitive of each part. The last part changes first. */
export function combinationsOf(info: LibraryInfo, most: number): number[][] {
  let all: number[][] = [[]];
  for (const part of info.parts.keys()) {
    const own = primitivesOf(info, part);
    all = all.flatMap((uses) => own.map((primitive) => [...uses, primitive])).slice(0, most);
  }
  return all;
}

/** The number of all combinations. */
export function countOf(info: LibraryInfo): number {
  return info.parts.reduce((product, _, part) => product * primitivesOf(info, part).length, 1);
}

export const isSame = (a: readonly number[], b: readonly number[]): boolean => a.join() === b.join();

/** The recorded movement with these primitives; null without one. */
export function recordedAs({ movements }: LibraryInfo, uses: readonly number[]): string | null {
  return movements.find((movement) => movement.learned && isSame(movement.uses, uses))?.name ?? null;
}

/** "lower: walk, upper: wave" */
export function titleOf({ parts, primitives }: LibraryInfo, uses: readonly number[]): string {
  return parts
    .map(({ name }, part) => `${shownPart(name)}: ${primitives[uses[part] ?? -1]?.name ?? ""}`)
    .join(", ");
}

/** A recorded combination with the primitive, else the first combination with it. */
export function exampleOf(info: LibraryInfo, primitive: number): number[] {
  const recorded = info.movements.find(({ uses, learned }) => learned && uses.includes(primitive));
  if (recorded) return recorded.uses;
  return info.parts.map((_, part) =>
    info.primitives[primitive]?.part === part ? primitive : (primitivesOf(info, part)[0] ?? 0),
  );
}

/** The first combination that was never recorded, else the first. */
export function firstOf(info: LibraryInfo, among: readonly number[][]): number[] {
  return among.find((uses) => recordedAs(info, uses) === null) ?? among[0] ?? [];
}
