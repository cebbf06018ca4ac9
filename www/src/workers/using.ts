// How a worker uses objects of the wasm.
import * as Comlink from "comlink";
import type { RolloutRequest } from "../engine/protocol";

/** Moves the buffers of these arrays to the page instead of copying them: the worker loses them. */
export function transfer<T extends object>(value: T, ...arrays: ArrayBufferView[]): T {
  return Comlink.transfer(
    value,
    arrays.map((array) => array.buffer as ArrayBuffer),
  );
}

interface Freed {
  free(): void;
}

/** Uses an object and frees its memory, after the promise where the use returns one. */
export function using<Value extends Freed, Result>(value: Value, use: (value: Value) => Result): Result {
  let result: Result;
  try {
    result = use(value);
  } catch (problem) {
    value.free();
    throw problem;
  }
  if (result instanceof Promise) return result.finally(() => value.free()) as Result;
  value.free();
  return result;
}

/** The request of the mean rollout. */
export const meanOf = ({ sample: _, ...request }: RolloutRequest): Omit<RolloutRequest, "sample"> => request;
