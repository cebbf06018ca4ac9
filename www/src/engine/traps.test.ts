import { expect, it } from "vitest";
import { explained, isTrap } from "./traps";

const named = (name: string, message: string) => Object.assign(new Error(message), { name });

it("says that the memory is used up where the wasm has much of it", () => {
  const problem = explained(new WebAssembly.RuntimeError("unreachable"), 4.29e9);
  expect(isTrap(problem)).toBe(true);
  expect(problem).toMatchObject({
    message:
      "the program stopped (unreachable): its memory of 4.3 GB is used up. Fewer frames, inducing points or clips need less",
  });
});

it("does not know the reason of a trap where the wasm has little memory", () => {
  const problem = explained(named("RangeError", "Maximum call stack size exceeded"), 1e6);
  expect(isTrap(problem)).toBe(true);
  expect(problem).toMatchObject({
    message: "the program stopped (Maximum call stack size exceeded), perhaps for want of memory",
  });
});

it("leaves other errors as they are", () => {
  for (const error of [named("VcgpdmError", "expected a model"), named("RangeError", "Invalid date")]) {
    expect(explained(error, 4e9)).toBe(error);
    expect(isTrap(error)).toBe(false);
  }
});
