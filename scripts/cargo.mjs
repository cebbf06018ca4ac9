// What of the Rust workspace is compiled for this machine.
import { run } from "./run.mjs";

/** Without the wasm package, which is for wasm32 alone, and bindgen: they have steps of their own. */
export const NATIVE = ["--workspace", "--exclude", "vcgpdm-wasm", "--exclude", "bindgen"];

/** The Rust tests, compiled without being run; and with them the program `vcgpdm`. */
export const compileTests = () => run("cargo", "test", ...NATIVE, "--all-features", "--no-run");
