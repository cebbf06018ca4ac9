// The packages of the Rust workspace that are compiled for this machine.
import { run } from "./run.mjs";

/**
 * Without bindgen, a tool. Commands with the same packages and features compile the library once: the tests, the
 * program that prints the types of the npm package, clippy.
 */
export const NATIVE = ["--workspace", "--exclude", "bindgen", "--features", "vcgpdm-wasm/types"];

/** What `cargo test` compiles: no examples, which clippy has checked already. */
export const TESTS = ["--lib", "--bins", "--tests"];

/** Compiles the Rust tests without running them, and the program `vcgpdm`. */
export const compileTests = () => run("cargo", "test", ...NATIVE, ...TESTS, "--no-run");

/** Compiles the library, and the program that prints the types of the npm package. */
export const compileLibrary = () => run("cargo", "build", "--locked", ...NATIVE, "--example", "types");
