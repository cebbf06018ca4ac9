// `npm run build`: from a clean clone to a static site in www/dist. With --wasm-only it stops at the npm
// package crate/wasm/pkg.
import { fileURLToPath } from "node:url";
import { writeFirst } from "./first.mjs";
import { main, step } from "./run.mjs";
import { buildSite, weigh } from "./site.mjs";
import { installTools } from "./tools.mjs";
import { buildWasm } from "./wasm.mjs";

export async function build({ wasmOnly = false } = {}) {
  await step("npm package vcgpdm (wasm)", buildWasm);
  if (wasmOnly) return;
  await step("first model and motion", writeFirst);
  await step("page", buildSite);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  await main(async () => {
    await installTools();
    const wasmOnly = process.argv.includes("--wasm-only");
    await build({ wasmOnly });
    if (!wasmOnly) await step("sizes", weigh);
  });
}
