// How a worker gives arrays away.
import * as Comlink from "comlink";

/** Sends the buffers of these arrays over instead of copying them: the worker has them no more. */
export function handOver<T extends object>(value: T, ...arrays: ArrayBufferView[]): T {
  return Comlink.transfer(
    value,
    arrays.map((array) => array.buffer as ArrayBuffer),
  );
}
