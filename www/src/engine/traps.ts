// Explains a trap of the wasm to the visitor. A trap stops the program in the middle of its work, so the
// contents of its memory are no longer reliable.

/** Bytes of wasm memory above which a trap is most likely a failed allocation. The limit is 4 GiB. */
const MUCH = 2 ** 30;

const NAME = "RuntimeError";

/** An exhausted stack or memory causes a RangeError, or an InternalError in Firefox. */
function endsProgram(problem: Error): boolean {
  if (problem.name === NAME) return true;
  const range = problem.name === "RangeError" || problem.name === "InternalError";
  return range && /call stack|recursion|memory|buffer|typed array/i.test(problem.message);
}

/**
 * In a worker: turns a trap into an error with a message for the visitor. Other errors stay unchanged.
 * `bytes` is the size of the wasm memory.
 */
export function explained(problem: unknown, bytes: number): unknown {
  if (!(problem instanceof Error) || !endsProgram(problem)) return problem;
  const stopped = `the program stopped (${problem.message})`;
  const error = new Error(
    bytes >= MUCH
      ? `${stopped}: its memory of ${(bytes / 1e9).toFixed(1)} GB is used up. Fewer frames, inducing points or clips need less`
      : `${stopped}, perhaps for want of memory`,
  );
  error.name = NAME;
  return error;
}

/** On the page: whether a call failed because the program of its worker stopped. */
export const isTrap = (problem: unknown): problem is Error =>
  problem instanceof Error && problem.name === NAME;
