// The origin of a primitive as text.
import type { PrimitiveOrigin } from "../engine/library-protocol";

const FRAMES = {
  clips: "clips given here",
  remembered: "what its file kept of them",
  generated: "rollouts of them",
};

/** "walk-1, walk-2 and 3 more" */
function list(names: readonly string[]): string {
  const different = [...new Set(names)];
  const first = different.slice(0, 2).join(", ");
  return different.length > 2 ? `${first} and ${different.length - 2} more` : first;
}

/** "Learned from walk-1, walk-2; 400 iterations, seed 8." */
export function originText({ clips, iterations, seed, relearned, note }: PrimitiveOrigin): string {
  const from = (some: PrimitiveOrigin["clips"]) =>
    list(some.map(({ name }) => name)) || "clips that are not named";
  const how = `${iterations} iterations, seed ${seed}.`;
  const text = relearned
    ? `Learned again, after ${relearned.primitive} of another library, which learned from ${from(relearned.clips)}: from ${FRAMES[relearned.frames]}; ${how}`
    : `Learned from ${from(clips)}; ${how}`;
  return note ? `${text} ${note}` : text;
}
