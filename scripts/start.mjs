// `npm start`: installs missing tools, builds the site, serves it and prints its address.
// With --dev it starts Vite's development server instead, which follows changes of the page, not of the Rust
// code.
import { build } from "./build.mjs";
import { Failure, main, runModule, step } from "./run.mjs";
import { serve } from "./serve.mjs";
import { dist } from "./site.mjs";
import { installTools } from "./tools.mjs";
import { compileWasm } from "./wasm.mjs";

await main(async () => {
  const dev = process.argv.includes("--dev");
  const port = Number(process.env.PORT ?? 5173);
  if (!Number.isInteger(port) || port < 0 || port > 65535)
    throw new Failure(`PORT must be a number from 0 to 65535, found "${process.env.PORT}"`);
  await installTools({ meanwhile: () => step("Rust to wasm", () => compileWasm({ small: false })) });
  await build({ wasmOnly: dev, small: false, whole: false });
  if (dev) return runModule("vite/bin/vite.js", "www", "--port", String(port));
  const { address } = await serve(dist, { port });
  console.log(`\nThe playground is at ${address}   (Ctrl+C ends it)`);
});
