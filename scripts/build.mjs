// `npm run build`: builds a static site in www/dist from a clean clone. With --wasm-only it stops after the
// npm package crate/wasm/pkg.
import { fileURLToPath } from "node:url";
import { buildFigure } from "./figure.mjs";
import { writeFirst } from "./first.mjs";
import { main, step } from "./run.mjs";
import { buildSite, weigh } from "./site.mjs";
import { installTools } from "./tools.mjs";
import { buildWasm, compileWasm } from "./wasm.mjs";

/**
 * Without `small` the wasm is larger and ready sooner. The page needs neither the types nor the figure of the npm
 * package: `npm start` leaves them out.
 */
export async function build({ wasmOnly = false, small = true, whole = true } = {}) {
  await step("npm package vcgpdm (wasm)", () => buildWasm({ small, types: whole }));
  if (whole) await step("npm package vcgpdm (figure)", buildFigure);
  if (wasmOnly) return;
  await step("first model and motion", writeFirst);
  await step("page", buildSite);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  await main(async () => {
    await installTools({ meanwhile: () => step("Rust to wasm", compileWasm) });
    const wasmOnly = process.argv.includes("--wasm-only");
    await build({ wasmOnly });
    if (!wasmOnly) await step("sizes", weigh);
  });
}
