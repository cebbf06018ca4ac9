// What a trap of the wasm means for a visitor. A trap ends the program in the middle of its work, so what its
// memory holds cannot be trusted any more.

/** Bytes of wasm memory above which a trap is most likely a failed allocation. The limit is 4 GiB. */
const MUCH = 2 ** 30;

const NAME = "RuntimeError";

/** Out of stack and out of memory come as a RangeError, or as an InternalError in Firefox. */
function endsProgram(problem: Error): boolean {
  if (problem.name === NAME) return true;
  const range = problem.name === "RangeError" || problem.name === "InternalError";
  return range && /call stack|recursion|memory|buffer|typed array/i.test(problem.message);
}

/** In a worker: a trap in words for the visitor; other errors stay as they are. `bytes`: of the wasm's memory. */
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
