// Completes the npm package after wasm-bindgen: entries for every kind of importer, the wasm once, errors
// with a name, types that compile without the newest libraries.
import { copyFileSync, mkdirSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { at, Failure, root } from "./run.mjs";

/**
 * Replaces places of a file. Each has to exist.
 * @param {string} file
 * @param {[from: string | RegExp, to: string][]} places
 */
function change(file, ...places) {
  let text = readFileSync(file, "utf8");
  for (const [from, to] of places) {
    const changed = typeof from === "string" ? text.replace(from, () => to) : text.replace(from, to);
    if (changed === text)
      throw new Failure(`${file}: expected ${from}, found none: has wasm-bindgen changed?`);
    text = changed;
  }
  writeFileSync(file, text);
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
function __checkNumbers(found) {
    if (ArrayBuffer.isView(found) || (Array.isArray(found) && found.every((item) => typeof item === "number"))) return;
    const wrong = Array.isArray(found) ? found.find((item) => typeof item !== "number") : found;
    const words = Array.isArray(wrong) ? "a list" : wrong && typeof wrong === "object" ? "an object" : String(wrong);
    throw __error("argument", \`expected a list of numbers, found \${words}\${found === wrong ? "" : " in it"}\`);
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

/** The classes that have no constructor get one that names the functions which make their objects. */
function withConstructors(/** @type {string} */ glue) {
  return glue.replace(/^export class (\w+) \{\n([\s\S]*?)^\}/gm, (whole, name, body) => {
    if (body.includes("constructor(")) return whole;
    const makers = body
      .split(/^(?= {4}\S.*\{$)/m)
      .filter((/** @type {string} */ part) => part.includes(`${name}.__wrap(`))
      .flatMap((/** @type {string} */ part) => /^ {4}static (\w+)/.exec(part)?.[1] ?? [])
      .map((/** @type {string} */ maker) => `${name}.${maker}`);
    const made = makers.length > 0 ? `use ${makers.join(" or ")}` : "other functions make these objects";
    return `export class ${name} {
    constructor() {
        throw __error("argument", "new ${name} makes no object: ${made}");
    }
${body}}`;
  });
}

/** Mends what wasm-bindgen wrote for a target, and adds the declarations of the types. */
function mend(/** @type {string} */ folder, /** @type {boolean} */ reads, /** @type {string} */ declared) {
  const [script, types] = [join(folder, "vcgpdm.js"), join(folder, "vcgpdm.d.ts")];
  change(
    script,
    ["throw new Error(getStringFromWasm0(arg0, arg1));", "throw __thrown(getStringFromWasm0(arg0, arg1));"],
    [/throw new Error\(`expected instance of .*/, "throw __otherClass(klass.name, instance);"],
    [/function passArrayF(32|64)ToWasm0\(arg, malloc\) \{\n/g, "$&    __checkNumbers(arg);\n"],
  );
  if (reads) {
    // A Blob gives its bytes only later. The player reads no files.
    const later = `static read(name, bytes$1) {
        if (typeof Blob === "function" && bytes instanceof Blob)
            return bytes.arrayBuffer().then((bytes) => $3.read(name, bytes$1));
$2`;
    change(script, [/static read\(name, bytes(.*)\) \{\n([\s\S]*?return (\w+)\.__wrap)/g, later]);
    const overload = "$&\n    static read(name: string, file: Blob$1): Promise<$2>;";
    change(types, [/static read\(name: string, bytes: [^,)]*(.*)\): (\w+);/g, overload]);
  }
  const glue = readFileSync(script, "utf8");
  writeFileSync(script, (reads ? withConstructors(glue) : glue) + ERRORS);
  writeFileSync(types, readFileSync(types, "utf8") + DISPOSE + declared);
  rmSync(join(folder, "vcgpdm_bg.wasm.d.ts"));
}

const WEB = `/* @ts-self-types="./vcgpdm.d.ts" */
import { givenWasm } from "./load.js";
import { trainHere, trainIn } from "./train.js";
export { default } from "./load.js";
export * from "./glue.js";

/** Trains in a worker; in this thread where no worker can start. */
export async function train(data, options) {
    if (typeof Worker !== "function") return trainHere(data, options);
    const start = () => new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    return trainIn(start, givenWasm(), data, options);
}
`;

const PLAYER = `/* @ts-self-types="./vcgpdm.d.ts" */
export { default } from "./load.js";
export * from "./glue.js";
`;

const TRAIN_TYPES = `
/** How a training is watched and stopped, and how it ends. */
export interface Watch {
    /** Called after iterations, at most 20 times a second, and at the end. */
    onProgress?: (progress: TrainingProgress) => void;
    /** Stops the training; the promise is rejected with the reason of the signal. */
    signal?: AbortSignal;
}
/**
 * Trains a model on clips or tables to the end, in a worker that comes with the package; where no worker can
 * start (Node, \`vcgpdm/inline\`), in short steps in this thread. Every setting has a default.
 */
export function train(clips: Clip | Clip[], options?: TrainingOptions & Watch): Promise<Model>;
export function train(tables: Table | Table[], options?: TableTrainingOptions & Watch): Promise<Model>;
`;

const INIT_TYPES = `
/**
 * Loads the wasm, once, before any other call: the file of the package, or the argument (an address, bytes, a
 * response). In Node the wasm is loaded by the import, and this does nothing.
 */
export default function init(wasm?: { module_or_path: InitInput | Promise<InitInput> } | InitInput | Promise<InitInput>): Promise<InitOutput>;
`;

const TYPES = `import type { Clip, Model, Table, TableTrainingOptions, TrainingProgress, TrainingOptions } from "../web/glue.js";
import type { InitInput, InitOutput } from "../web/glue.js";
export * from "../web/glue.js";
${INIT_TYPES}${TRAIN_TYPES}`;

const INLINE = `/* @ts-self-types="./vcgpdm.d.ts" */
import load from "../web/glue.js";
import packed from "./wasm.js";
export * from "../web/glue.js";
export { trainHere as train } from "../web/train.js";

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

/** An entry for Node, from the lines that import the script as `start` and all else, and give the bytes. */
const node = (/** @type {string} */ imports, /** @type {string} */ bytes) => `${imports}
const program = start({ module: ${bytes} });

// For programs that run in browsers too: in Node the import has loaded the wasm.
export const initSync = () => program;
export default async function init() {
    return program;
}
`;

// The wasm is in the script, as in the folder inline: bundles for servers have no file next to them.
const NODE = node(
  `import { Buffer } from "node:buffer";
import { gunzipSync } from "node:zlib";
import packed from "../inline/wasm.js";
import { initSync as start } from "../web/glue.js";
export * from "../web/glue.js";
export { trainHere as train } from "../web/train.js";
`,
  'gunzipSync(Buffer.from(packed, "base64"))',
);

const NODE_WITH_FILE = node(
  `import { readFileSync } from "node:fs";
import { initSync as start } from "../web/vcgpdm.js";
export * from "../web/vcgpdm.js";
`,
  'readFileSync(new URL("../web/vcgpdm_bg.wasm", import.meta.url))',
);

// TypeScript takes only an assigned `exports.default` for the default export that the types name.
const COMMONJS = `const whole = require("./vcgpdm.js");
Object.assign(exports, whole, { __esModule: true });
exports.default = whole.default;
`;

/** Writes an entry for Node that loads the wasm of the folder web at the import. */
export function writeNodeEntry(/** @type {string} */ place, text = NODE_WITH_FILE) {
  mkdirSync(join(place, "node"), { recursive: true });
  writeFileSync(join(place, "node", "vcgpdm.js"), text);
  writeFileSync(join(place, "node", "package.json"), '{"type":"module"}\n');
}

/** The built package as Node loads it. @returns {typeof import("vcgpdm")} */
export const builtPackage = () => createRequire(import.meta.url)(at("crate/wasm/pkg/node/vcgpdm.cjs"));

/** The declaration of `init` by wasm-bindgen, which demands an argument, with its comment. */
const OLD_INIT = /\n\/\*\*(?:(?!\*\/)[\s\S])*\*\/\nexport default function [^\n]*\n/;

/** Completes the package in `place`, which has the targets' folders web and player. */
export function completePackage(/** @type {string} */ place, /** @type {string} */ declared) {
  const at = (/** @type {string[]} */ ...path) => join(place, ...path);
  for (const folder of ["web", "player"]) mend(at(folder), folder === "web", declared);

  // An entry names the wasm by its address; the glue does not, because bundlers would look for the file.
  for (const folder of ["web", "player"]) {
    renameSync(at(folder, "vcgpdm.js"), at(folder, "glue.js"));
    change(at(folder, "glue.js"), ['/* @ts-self-types="./vcgpdm.d.ts" */\n', ""]);
    copyFileSync(join(root, "crate/wasm/js/load.js"), at(folder, "load.js"));
  }
  writeFileSync(at("player", "vcgpdm.js"), PLAYER);
  change(at("player", "vcgpdm.d.ts"), [OLD_INIT, INIT_TYPES]);

  renameSync(at("web", "vcgpdm.d.ts"), at("web", "glue.d.ts"));
  writeFileSync(at("web", "vcgpdm.js"), WEB);
  writeFileSync(at("web", "vcgpdm.d.ts"), TYPES);

  mkdirSync(at("inline"), { recursive: true });
  const packed = gzipSync(readFileSync(at("web", "vcgpdm_bg.wasm")), { level: 9 }).toString("base64");
  writeFileSync(at("inline", "wasm.js"), `export default "${packed}";\n`);
  writeFileSync(at("inline", "vcgpdm.js"), INLINE);
  writeFileSync(at("inline", "vcgpdm.d.ts"), TYPES);

  for (const file of ["train.js", "worker.js"])
    copyFileSync(join(root, "crate/wasm/js", file), at("web", file));

  writeNodeEntry(place, NODE);
  writeFileSync(at("node", "vcgpdm.d.ts"), TYPES);
  // Node can require a module; TypeScript wants the types of CommonJS in a file of their own.
  writeFileSync(at("node", "vcgpdm.cjs"), COMMONJS);
  const commonTypes = readFileSync(at("web", "glue.d.ts"), "utf8") + TRAIN_TYPES;
  writeFileSync(at("node", "vcgpdm.d.cts"), commonTypes);

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

const figure = { types: "./figure/figure.d.ts", default: "./figure/figure.js" };

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
    "./figure": {
      node: {
        import: figure,
        require: { types: "./figure/figure.d.cts", default: "./figure/figure.cjs" },
      },
      default: figure,
    },
    "./vcgpdm_bg.wasm": "./web/vcgpdm_bg.wasm",
    "./package.json": "./package.json",
  },
  files: ["web", "inline", "node", "player", "figure", "THIRD-PARTY.txt"],
  sideEffects: ["./web/worker.js"],
};
