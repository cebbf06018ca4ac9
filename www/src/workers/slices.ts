// How a worker's training makes room for messages: slice after slice.

/** Milliseconds of training before a report, and before messages (a cancel) get their turn. */
export const SLICE = 100;

/** Lets waiting messages in. */
export function breathe(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, 0));
}
