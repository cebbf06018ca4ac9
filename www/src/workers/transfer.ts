// How a worker sends arrays.
import * as Comlink from "comlink";

/** Moves the buffers of these arrays to the page instead of copying them: the worker loses them. */
export function transfer<T extends object>(value: T, ...arrays: ArrayBufferView[]): T {
  return Comlink.transfer(
    value,
    arrays.map((array) => array.buffer as ArrayBuffer),
  );
}
