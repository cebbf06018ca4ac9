// How a worker answers the page. No DOM.
import * as Comlink from "comlink";
import "../engine/transfers";
import { explained } from "../engine/traps";

type Call = (...given: unknown[]) => unknown;

let memory: WebAssembly.Memory | null = null;

/** Starts the wasm. */
export async function start(
  init: (options: { module_or_path: WebAssembly.Module }) => Promise<{ memory: WebAssembly.Memory }>,
  wasm: WebAssembly.Module,
): Promise<void> {
  const [program] = await Promise.all([init({ module_or_path: wasm }), showLife()]);
  memory = program.memory;
}

/** Offers these calls to the page. A trap is thrown as a sentence for the visitor. */
export function serve(calls: object): void {
  const answer =
    (call: Call) =>
    async (...given: unknown[]) => {
      try {
        return await call(...given);
      } catch (problem) {
        throw explained(problem, memory?.buffer.byteLength ?? 0);
      }
    };
  Comlink.expose(Object.fromEntries(Object.entries(calls).map(([name, call]) => [name, answer(call)])));
}

/** Resolves when this worker holds the lock of its name, which it does until it dies: see engine/running.ts. */
function showLife(): Promise<void> {
  const { locks } = navigator;
  if (!locks) return Promise.resolve();
  return new Promise((held, failed) => {
    const forLife = () => new Promise<never>(() => held());
    locks.request(self.name, forLife).catch(failed);
  });
}
