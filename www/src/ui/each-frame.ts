// What is done once a display frame.

/**
 * Seconds that a picture takes at most: after a longer pause of the browser the clock does not go on by more.
 */
export const LONGEST_PICTURE = 0.25;

/**
 * Calls back before each picture with the seconds since the one before, at most `longest`; answers how to
 * stop that.
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
