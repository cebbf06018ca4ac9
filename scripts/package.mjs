// What an npm package needs beside what wasm-bindgen makes: entries for every kind of importer, the wasm
// once, errors with a name, types that compile without the newest libraries.
import { readFileSync, renameSync, rmSync, writeFileSync, mkdirSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { Failure } from "./run.mjs";

/** A file with one place changed, which has to be there. */
function change(/** @type {string} */ file, /** @type {string} */ from, /** @type {string} */ to) {
  const text = readFileSync(file, "utf8");
  if (!text.includes(from))
    throw new Failure(`${file}: expected ${from}, found none: has wasm-bindgen changed?`);
  writeFileSync(
    file,
    text.replace(from, () => to),
  );
}

// What Rust throws by a panic, or for a pointer that is gone, had neither name nor code.
const THROWN = `
function __thrown(message) {
    if (message !== "null pointer passed to rust") return new Error(message);
    const error = new Error("expected an object in use, found one after its free()");
    return Object.assign(error, { name: "VcgpdmError", code: "freed" });
}
`;

// Symbol.dispose stands in TypeScript's esnext.disposable only; declared alike in both places it is one.
const DISPOSE = `declare global {
    interface SymbolConstructor {
        readonly dispose: unique symbol;
    }
}
`;

/** What holds for the files of each target. */
function mend(/** @type {string} */ folder) {
  const script = join(folder, "vcgpdm.js");
  change(
    script,
    "throw new Error(getStringFromWasm0(arg0, arg1));",
    "throw __thrown(getStringFromWasm0(arg0, arg1));",
  );
  writeFileSync(script, readFileSync(script, "utf8") + THROWN);
  const types = join(folder, "vcgpdm.d.ts");
  writeFileSync(types, readFileSync(types, "utf8") + DISPOSE);
  rmSync(join(folder, "vcgpdm_bg.wasm.d.ts"));
}

const WEB = `/* @ts-self-types="./vcgpdm.d.ts" */
import load from "./glue.js";
export * from "./glue.js";

/** Loads the wasm: the file beside this one, or what is given. */
export default function init(wasm) {
    const given = wasm ?? new URL("vcgpdm_bg.wasm", import.meta.url);
    const named = Object.getPrototypeOf(given) === Object.prototype && "module_or_path" in given;
    return load(named ? given : { module_or_path: given });
}
`;

const WEB_TYPES = `/**
 * Loads the wasm, once, before anything else is called: the file beside this one, or what is given (an
 * address, bytes, a response).
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

/** Unpacks and starts the wasm that stands in the script. */
export default async function init(wasm) {
    return load({ module_or_path: wasm ?? (await unpacked()) });
}
`;

const NODE = `
// For programs that run in browsers too: in Node the wasm is there already.
exports.initSync = () => {};
exports.default = async () => {};
Object.defineProperty(exports, "__esModule", { value: true });
`;

const NODE_MODULE = `export * from "./vcgpdm.js";
/** For programs that run in browsers too: in Node the wasm is there already. */
export default async function init() {}
`;

const INIT_TYPES = `/** For programs that run in browsers too: in Node the wasm is there already. */
export default function init(wasm?: unknown): Promise<void>;
`;

/** The package in \`place\`, of the targets' folders web, node and player. */
export function completePackage(/** @type {string} */ place) {
  const [web, node, player, inline] = ["web", "node", "player", "inline"].map((folder) =>
    join(place, folder),
  );
  if (!web || !node || !player || !inline) return;
  for (const folder of [web, node, player]) mend(folder);

  // An entry that names the wasm by its address, and what it loads, which does not: bundlers would look for
  // the file.
  renameSync(join(web, "vcgpdm.js"), join(web, "glue.js"));
  const address = "module_or_path = new URL('vcgpdm_bg.wasm', import.meta.url);";
  change(join(web, "glue.js"), address, 'throw new Error("expected the wasm");');
  change(join(web, "glue.js"), '/* @ts-self-types="./vcgpdm.d.ts" */\n', "");
  writeFileSync(join(web, "vcgpdm.js"), WEB);
  const types = readFileSync(join(web, "vcgpdm.d.ts"), "utf8");
  const loader = /\/\*\*\n \* If `module_or_path`[\s\S]*?export default function __wbg_init[^;]*;\n/;
  if (!loader.test(types)) throw new Failure("the types of web/ have no loader: has wasm-bindgen changed?");
  writeFileSync(
    join(web, "vcgpdm.d.ts"),
    types.replace(loader, () => WEB_TYPES),
  );

  const wasm = readFileSync(join(web, "vcgpdm_bg.wasm"));
  mkdirSync(inline, { recursive: true });
  const packed = gzipSync(wasm, { level: 9 }).toString("base64");
  writeFileSync(join(inline, "wasm.js"), `export default "${packed}";\n`);
  writeFileSync(join(inline, "vcgpdm.js"), INLINE);
  writeFileSync(
    join(inline, "vcgpdm.d.ts"),
    'export * from "../web/vcgpdm.js";\nexport { default } from "../web/vcgpdm.js";\n',
  );

  // The wasm of both is the same: it is in the package once.
  if (!wasm.equals(readFileSync(join(node, "vcgpdm_bg.wasm"))))
    throw new Failure("the wasm for Node is another than that for browsers");
  rmSync(join(node, "vcgpdm_bg.wasm"));
  change(join(node, "vcgpdm.js"), "/vcgpdm_bg.wasm`", "/../web/vcgpdm_bg.wasm`");
  writeFileSync(join(node, "vcgpdm.js"), readFileSync(join(node, "vcgpdm.js"), "utf8") + NODE);
  const plain = readFileSync(join(node, "vcgpdm.d.ts"), "utf8");
  writeFileSync(
    join(node, "vcgpdm.d.ts"),
    `${plain}${INIT_TYPES}export function initSync(wasm?: unknown): void;\n`,
  );
  writeFileSync(join(node, "index.mjs"), NODE_MODULE);
  writeFileSync(join(node, "index.d.mts"), `export * from "./vcgpdm.js";\n${INIT_TYPES}`);

  // Importers that do not read "exports" take a folder's own package.json.
  for (const folder of [player, inline]) {
    const entry = { type: "module", main: "./vcgpdm.js", types: "./vcgpdm.d.ts" };
    writeFileSync(join(folder, "package.json"), `${JSON.stringify(entry)}\n`);
  }
}

const entry = (/** @type {string} */ folder) => ({
  types: `./${folder}/vcgpdm.d.ts`,
  default: `./${folder}/vcgpdm.js`,
});

// Node loads a file and not an address: there every entry is the whole package.
const inNode = {
  import: { types: "./node/index.d.mts", default: "./node/index.mjs" },
  require: entry("node"),
};

/** The fields of package.json that say which importer gets what. */
export const entries = {
  type: "module",
  main: "./node/vcgpdm.js",
  module: "./web/vcgpdm.js",
  types: "./node/vcgpdm.d.ts",
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
