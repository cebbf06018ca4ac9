// `node scripts/widget.mjs`: the script of vcgpdm.widget, in one file with the wasm and the figure, and the
// licences in a wheel, in crate/python/python/vcgpdm.
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import { build } from "./build.mjs";
import { wheelNotice } from "./licences.mjs";
import { at, filesUnder, main, step, whenChanged } from "./run.mjs";
import { installTools } from "./tools.mjs";

const pkg = at("crate/wasm/pkg");
const folder = at("crate/python/python/vcgpdm");
const entry = at("crate/python/js/widget.js");
const WASM = "virtual:wasm";

/** The wasm as a module, gzipped. */
const inlineWasm = {
  name: "inline-wasm",
  resolveId: (/** @type {string} */ id) => (id === WASM ? `\0${WASM}` : null),
  load(/** @type {string} */ id) {
    if (id !== `\0${WASM}`) return null;
    const packed = gzipSync(readFileSync(join(pkg, "player/vcgpdm_bg.wasm")), { level: 9 });
    return `export default "${packed.toString("base64")}";`;
  },
};

/** Builds the script. The npm package in crate/wasm/pkg must exist. */
export function buildWidget() {
  const inputs = [
    ...filesUnder([join(pkg, "player"), join(pkg, "figure")]),
    ...["package-lock.json", "crate/python/Cargo.lock", "scripts/widget.mjs"].map((file) => at(file)),
    entry,
  ];
  return whenChanged("widget", { inputs, outputs: [join(folder, "widget.js")] }, async () => {
    const vite = createRequire(at("www/package.json")).resolve("vite");
    const { build: bundle } = await import(pathToFileURL(vite).href);
    await bundle({
      configFile: false,
      root: dirname(entry),
      publicDir: false,
      logLevel: "warn",
      plugins: [inlineWasm],
      resolve: {
        alias: {
          "vcgpdm/player": join(pkg, "player/glue.js"),
          "vcgpdm/figure": join(pkg, "figure/figure.js"),
        },
      },
      build: {
        lib: { entry, formats: ["es"], fileName: () => "widget.js" },
        outDir: folder,
        // The folder has the Python sources.
        emptyOutDir: false,
        target: "es2022",
      },
    });
    writeFileSync(join(folder, "THIRD-PARTY.txt"), wheelNotice());
  });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  await main(async () => {
    await installTools();
    await build({ wasmOnly: true });
    await step("widget of the Python package", buildWidget);
  });
}
