// Work that is done once for each display frame.

/** The most seconds between two pictures; after a longer pause the clock does not advance by more. */
export const LONGEST_PICTURE = 0.25;

/**
 * Calls back before each picture with the seconds since the previous one, at most `longest`. Returns a
 * function that stops the calls.
 */
export function eachFrame(work: (seconds: number) => void, longest = LONGEST_PICTURE): () => void {
  let before = performance.now();
  const frame = (now: number) => {
    timer = requestAnimationFrame(frame);
    const seconds = Math.min(longest, (now - before) / 1000);
    before = now;
    work(seconds);
  };
  let timer = requestAnimationFrame(frame);
  return () => cancelAnimationFrame(timer);
}
