// How a worker computes and still reads messages: step after step, with a pause for messages after each slice.

/** Milliseconds of steps before a report and a pause. */
const SLICE = 100;

/**
 * Takes steps until one answers that it was the last, or until the signal is aborted; answers whether all
 * were taken. `report` is called after each slice. `paused` gets the milliseconds of each pause, which are no
 * part of the computation.
 */
export async function inSlices(
  signal: AbortSignal,
  step: () => boolean,
  report: (done: boolean) => unknown,
  paused: (milliseconds: number) => void = () => {},
): Promise<boolean> {
  let done = false;
  while (!done && !signal.aborted) {
    const start = performance.now();
    do done = step();
    while (!done && performance.now() - start < SLICE);
    await report(done);
    const pause = performance.now();
    await new Promise((resolve) => setTimeout(resolve, 0));
    paused(performance.now() - pause);
  }
  return done;
}
