// The packages of the Rust workspace that are compiled for this machine.
import { run } from "./run.mjs";

/** Without the wasm package, which is for wasm32 alone, and bindgen: they have steps of their own. */
export const NATIVE = ["--workspace", "--exclude", "vcgpdm-wasm", "--exclude", "bindgen"];

/** What `cargo test` compiles: no examples, which clippy has checked already. */
export const TESTS = ["--lib", "--bins", "--tests"];

/** Compiles the Rust tests without running them, and the program `vcgpdm`. */
export const compileTests = () => run("cargo", "test", ...NATIVE, ...TESTS, "--no-run");
