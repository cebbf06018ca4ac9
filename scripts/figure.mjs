// `vcgpdm/figure` in crate/wasm/pkg/figure: the stage of the page for a canvas of any page, in one file.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { at, Failure, filesUnder, runModule, whenChanged } from "./run.mjs";

const pkg = at("crate/wasm/pkg/figure");
const declared = at(".tools/figure");

export function buildFigure() {
  const sources = ["figure.config.ts", "tsconfig.figure.json", "tsconfig.json", "src"];
  const inputs = filesUnder([
    ...sources.map((name) => at("www", name)),
    at("package-lock.json"),
    at("scripts/figure.mjs"),
    at("crate/wasm/pkg/web/glue.d.ts"),
  ]);
  const outputs = [join(pkg, "figure.js"), join(pkg, "figure.cjs")];
  return whenChanged("figure", { inputs, outputs }, async () => {
    const config = ["--config", at("www/figure.config.ts"), "--logLevel", "warn"];
    await runModule("vite/bin/vite.js", "build", at("www"), ...config);
    await runModule("typescript/bin/tsc", "-p", at("www/tsconfig.figure.json"), "--outDir", declared);
    const types = readFileSync(join(declared, "stage/model-figure.d.ts"), "utf8");
    if (/^import /m.test(types))
      throw new Failure(
        "www/src/stage/model-figure.ts: expected public types of its own, found imported ones",
      );
    const entry = { type: "module", main: "./figure.js", types: "./figure.d.ts" };
    writeFileSync(join(pkg, "figure.d.ts"), types);
    writeFileSync(join(pkg, "figure.d.cts"), types);
    writeFileSync(join(pkg, "figure.cjs"), 'exports.Figure = require("./figure.js").Figure;\n');
    writeFileSync(join(pkg, "package.json"), `${JSON.stringify(entry)}\n`);
  });
}
