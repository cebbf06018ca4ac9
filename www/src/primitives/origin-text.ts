// The origin of a primitive as text.
import type { PrimitiveOrigin } from "../engine/library-protocol";
import { primitivesWords } from "../words/primitives";

/** "walk-1, walk-2 and 3 more" */
function list(names: readonly string[]): string {
  const different = [...new Set(names)];
  const first = different.slice(0, 2).join(", ");
  return different.length > 2 ? primitivesWords().origin.more(first, different.length - 2) : first;
}

/** "Learned from walk-1, walk-2; 400 iterations, seed 8." */
export function originText({ clips, iterations, seed, relearned, note }: PrimitiveOrigin): string {
  const words = primitivesWords().origin;
  const from = (some: PrimitiveOrigin["clips"]) => list(some.map(({ name }) => name)) || words.unnamed;
  const how = words.how(iterations, seed);
  const text = relearned
    ? words.relearned(relearned.primitive, from(relearned.clips), words.frames[relearned.frames], how)
    : words.learned(from(clips), how);
  return note ? `${text} ${note}` : text;
}
