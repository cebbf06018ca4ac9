// Which primitives of a library can be put together, and what that is called. No rendering, no worker.
import type { LibraryInfo } from "../engine/library-protocol";

/** The numbers of the primitives of a part. */
export function primitivesOf({ primitives }: LibraryInfo, part: number): number[] {
  return primitives.flatMap((primitive, index) => (primitive.part === part ? [index] : []));
}

/** One primitive of each part, in every way; the last part changes first. At most so many. */
export function combinationsOf(info: LibraryInfo, most: number): number[][] {
  let all: number[][] = [[]];
  for (const part of info.parts.keys()) {
    const own = primitivesOf(info, part);
    all = all.flatMap((uses) => own.map((primitive) => [...uses, primitive])).slice(0, most);
  }
  return all;
}

/** How many combinations there are. */
export function countOf(info: LibraryInfo): number {
  return info.parts.reduce((product, _, part) => product * primitivesOf(info, part).length, 1);
}

export const isSame = (a: readonly number[], b: readonly number[]): boolean => a.join() === b.join();

/** The movement that was recorded with these primitives; null: it was never recorded. */
export function recordedAs({ movements }: LibraryInfo, uses: readonly number[]): string | null {
  return movements.find((movement) => movement.learned && isSame(movement.uses, uses))?.name ?? null;
}

/** "lower: walk, upper: wave" */
export function titleOf({ parts, primitives }: LibraryInfo, uses: readonly number[]): string {
  return parts.map(({ name }, part) => `${name}: ${primitives[uses[part] ?? -1]?.name ?? ""}`).join(", ");
}

/** A recorded combination in which the primitive stands, or the first that has it. */
export function exampleOf(info: LibraryInfo, primitive: number): number[] {
  const recorded = info.movements.find(({ uses, learned }) => learned && uses.includes(primitive));
  if (recorded) return recorded.uses;
  return info.parts.map((_, part) =>
    info.primitives[primitive]?.part === part ? primitive : (primitivesOf(info, part)[0] ?? 0),
  );
}

/** The combination to begin with: one that was never recorded, if there is one. */
export function firstOf(info: LibraryInfo, among: readonly number[][]): number[] {
  return among.find((uses) => recordedAs(info, uses) === null) ?? among[0] ?? [];
}
