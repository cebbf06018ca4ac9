// Random numbers of a riddle. They follow from a seed, so that a whole class votes on the same riddle.

/** The first numbers of a small seed are small. */
const SKIPPED = 16;

/** Gives numbers from 0 to below 1, one with each call (xorshift of 32 bits; the seed is not 0). */
export function randomNumbers(seed: number): () => number {
  let state = seed >>> 0 || 1;
  const next = () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    state >>>= 0;
    return state / 2 ** 32;
  };
  for (let i = 0; i < SKIPPED; i++) next();
  return next;
}
