// How the package loads its wasm. The worker needs this alone: bundlers do not end when a worker imports the
// module that starts it.
import load from "./glue.js";

let given;

/** What `init` was given, for the worker. */
export const givenWasm = () => given;

/** Loads the wasm: the file next to this one, or the argument. */
export default function init(wasm) {
  given = wasm;
  const source = wasm ?? new URL("vcgpdm_bg.wasm", import.meta.url);
  const named = Object.getPrototypeOf(source) === Object.prototype && "module_or_path" in source;
  return load(named ? source : { module_or_path: source });
}
