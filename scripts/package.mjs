// Completes the npm package after wasm-bindgen: entries for every kind of importer, the wasm once, errors
// with a name, types that compile without the newest libraries.
import { copyFileSync, mkdirSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { Failure } from "./run.mjs";

/** Replaces one place of a file. The place has to exist. */
function change(/** @type {string} */ file, /** @type {string} */ from, /** @type {string} */ to) {
  const text = readFileSync(file, "utf8");
  if (!text.includes(from))
    throw new Failure(`${file}: expected ${from}, found none: has wasm-bindgen changed?`);
  writeFileSync(
    file,
    text.replace(from, () => to),
  );
}

// wasm-bindgen's own errors, for a freed object or an argument of another class, have neither name nor code.
const ERRORS = `
function __error(code, message) {
    return Object.assign(new Error(message), { name: "VcgpdmError", code });
}
function __thrown(message) {
    if (message !== "null pointer passed to rust") return new Error(message);
    return __error("freed", "expected an object in use, found one after its free()");
}
function __otherClass(expected, found) {
    const name = found === null ? "null" : typeof found === "object" ? found.constructor?.name ?? "object" : typeof found;
    return __error("argument", \`expected an instance of \${expected}, found \${name}\`);
}
`;

// Only TypeScript's esnext.disposable declares Symbol.dispose; declared alike in both places it is one symbol.
const DISPOSE = `declare global {
    interface SymbolConstructor {
        readonly dispose: unique symbol;
    }
}
`;

/** Mends what wasm-bindgen wrote for a target. */
function mend(/** @type {string} */ folder) {
  const script = join(folder, "vcgpdm.js");
  change(
    script,
    "throw new Error(getStringFromWasm0(arg0, arg1));",
    "throw __thrown(getStringFromWasm0(arg0, arg1));",
  );
  change(
    script,
    ["throw new Error(`expected instance of $", "{klass.name}`);"].join(""),
    "throw __otherClass(klass.name, instance);",
  );
  writeFileSync(script, readFileSync(script, "utf8") + ERRORS);
  const types = join(folder, "vcgpdm.d.ts");
  writeFileSync(types, readFileSync(types, "utf8") + DISPOSE);
  rmSync(join(folder, "vcgpdm_bg.wasm.d.ts"));
}

const WEB = `/* @ts-self-types="./vcgpdm.d.ts" */
import load from "./glue.js";
export * from "./glue.js";

/** Loads the wasm: the file next to this one, or the argument. */
export default function init(wasm) {
    const source = wasm ?? new URL("vcgpdm_bg.wasm", import.meta.url);
    const named = Object.getPrototypeOf(source) === Object.prototype && "module_or_path" in source;
    return load(named ? source : { module_or_path: source });
}
`;

const TYPES = `import type { InitInput, InitOutput } from "../web/glue.js";
export * from "../web/glue.js";
/**
 * Loads the wasm, once, before any other call: the file of the package, or the argument (an address, bytes, a
 * response). In Node the wasm is loaded by the import, and this does nothing.
 */
export default function init(wasm?: { module_or_path: InitInput | Promise<InitInput> } | InitInput | Promise<InitInput>): Promise<InitOutput>;
`;

const INLINE = `/* @ts-self-types="./vcgpdm.d.ts" */
import load from "../web/glue.js";
import packed from "./wasm.js";
export * from "../web/glue.js";

async function unpacked() {
    const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(stream).arrayBuffer();
}

/** Unpacks and starts the wasm, which is in the script. */
export default async function init(wasm) {
    return load({ module_or_path: wasm ?? (await unpacked()) });
}
`;

const node = (/** @type {string} */ glue) => `import { readFileSync } from "node:fs";
import { initSync as start } from "../web/${glue}";
export * from "../web/${glue}";

const program = start({ module: readFileSync(new URL("../web/vcgpdm_bg.wasm", import.meta.url)) });

// For programs that run in browsers too: in Node the import has loaded the wasm.
export const initSync = () => program;
export default async function init() {
    return program;
}
`;

// TypeScript takes only an assigned `exports.default` for the default export that the types name.
const COMMONJS = `const whole = require("./vcgpdm.js");
Object.assign(exports, whole, { __esModule: true });
exports.default = whole.default;
`;

/** Writes an entry for Node, which loads the wasm at the import. `glue`: the script of the folder web. */
export function writeNodeEntry(/** @type {string} */ place, glue = "vcgpdm.js") {
  mkdirSync(join(place, "node"), { recursive: true });
  writeFileSync(join(place, "node", "vcgpdm.js"), node(glue));
  writeFileSync(join(place, "node", "package.json"), '{"type":"module"}\n');
}

/** Completes the package in \`place\`, which has the targets' folders web and player. */
export function completePackage(/** @type {string} */ place) {
  const at = (/** @type {string[]} */ ...path) => join(place, ...path);
  for (const folder of ["web", "player"]) mend(at(folder));

  // The entry names the wasm by its address; the glue does not, because bundlers would look for the file.
  renameSync(at("web", "vcgpdm.js"), at("web", "glue.js"));
  renameSync(at("web", "vcgpdm.d.ts"), at("web", "glue.d.ts"));
  change(at("web", "glue.js"), '/* @ts-self-types="./vcgpdm.d.ts" */\n', "");
  writeFileSync(at("web", "vcgpdm.js"), WEB);
  writeFileSync(at("web", "vcgpdm.d.ts"), TYPES);

  mkdirSync(at("inline"), { recursive: true });
  const packed = gzipSync(readFileSync(at("web", "vcgpdm_bg.wasm")), { level: 9 }).toString("base64");
  writeFileSync(at("inline", "wasm.js"), `export default "${packed}";\n`);
  writeFileSync(at("inline", "vcgpdm.js"), INLINE);
  writeFileSync(at("inline", "vcgpdm.d.ts"), TYPES);

  writeNodeEntry(place, "glue.js");
  writeFileSync(at("node", "vcgpdm.d.ts"), TYPES);
  // Node can require a module; TypeScript wants the types of CommonJS in a file of their own.
  writeFileSync(at("node", "vcgpdm.cjs"), COMMONJS);
  copyFileSync(at("web", "glue.d.ts"), at("node", "vcgpdm.d.cts"));

  // Importers that do not read "exports" take a folder's own package.json.
  for (const folder of ["player", "inline"]) {
    const entry = { type: "module", main: "./vcgpdm.js", types: "./vcgpdm.d.ts" };
    writeFileSync(at(folder, "package.json"), `${JSON.stringify(entry)}\n`);
  }
}

const entry = (/** @type {string} */ folder) => ({
  types: `./${folder}/vcgpdm.d.ts`,
  default: `./${folder}/vcgpdm.js`,
});

// Node loads a file and not an address: there every entry is the whole package.
const inNode = {
  import: entry("node"),
  require: { types: "./node/vcgpdm.d.cts", default: "./node/vcgpdm.cjs" },
};

/** The fields of package.json that say which importer gets what. */
export const entries = {
  type: "module",
  main: "./node/vcgpdm.cjs",
  module: "./web/vcgpdm.js",
  types: "./node/vcgpdm.d.cts",
  exports: {
    ".": { node: inNode, default: entry("web") },
    "./inline": { node: inNode, default: entry("inline") },
    "./player": { node: inNode, default: entry("player") },
    "./vcgpdm_bg.wasm": "./web/vcgpdm_bg.wasm",
    "./package.json": "./package.json",
  },
  files: ["web", "inline", "node", "player", "THIRD-PARTY.txt"],
  sideEffects: false,
};
