// How a worker uses values of the wasm program.

/** Uses a value and gives its memory back. */
export function using<Value extends { free(): void }, Result>(
  value: Value,
  use: (value: Value) => Result,
): Result {
  try {
    return use(value);
  } finally {
    value.free();
  }
}
