// The runner of `cargo test` for wasm32: runs the tests in a wasm file in Node. `wasm-pack test --node` does the same
// with the runner of wasm-bindgen, which takes minutes to compile.
import { writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { Failure, main, run } from "./run.mjs";
import { BINDGEN } from "./wasm.mjs";

await main(async () => {
  const [file = ""] = process.argv.slice(2);
  const folder = file.replace(/\.wasm$/, ".tests");
  await run("cargo", "run", "--quiet", ...BINDGEN, "--", "--tests", file, folder);
  writeFileSync(join(folder, "package.json"), '{"type":"commonjs"}\n');
  // The names are those that wasm-bindgen-test asks for.
  Object.assign(globalThis, {
    __wbg_test_invoke: (/** @type {() => void} */ test) => test(),
    __wbgtest_og_console_log: console.log,
  });
  const wasm = createRequire(import.meta.url)(join(folder, "vcgpdm.js"));
  const tests = Object.keys(wasm.__wasm).filter((name) => name.startsWith("__wbgt_"));
  const context = new wasm.WasmBindgenTestContext(false);
  const passed = await context.run(tests.map((name) => wasm.__wasm[name]));
  if (!passed || tests.length === 0) throw new Failure(`${file}: expected tests that pass`);
});
