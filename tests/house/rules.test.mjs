// The readers and rules behind imports.test.mjs, on small houses of their own: each rule finds what breaks
// it.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { longFiles } from "./lines.mjs";
import { againstOrder, circles, readRooms, strangeRooms } from "./rooms.mjs";
import * as rust from "./rust.mjs";
import * as typescript from "./typescript.mjs";

const DOCUMENT = `# A house

\`\`\`rooms src
base                the ground
left, right         beside each other
top
work
work uses only base/words
only top/roof names storm
only left, top import glass
only work loads engine  (types may be named everywhere)
nothing names wasm, tsify
\`\`\`
`;
const rooms = readRooms(DOCUMENT, "src");

describe("the order", () => {
  it("is read from its block", () => {
    assert.deepEqual(
      [...rooms.floors],
      [
        ["base", 1],
        ["left", 2],
        ["right", 2],
        ["top", 3],
        ["work", 4],
      ],
    );
    assert.throws(() => readRooms(DOCUMENT, "other"), /no block of the rooms of other/);
    assert.throws(
      () => readRooms(DOCUMENT.replace("top\n", "top uses base\n"), "src"),
      /found "top uses base"/,
    );
  });
  it("names the rooms that are there", () => {
    const files = ["base/words.ts", "left/a.ts", "right/a.ts", "work/a.ts", "cellar.ts"];
    assert.deepEqual(strangeRooms(files, rooms), [
      "cellar: a room that the order does not name",
      "top: in the order, but no such room",
    ]);
  });
  it("lets a room use itself and what stands before, and nothing else", () => {
    const uses = [
      { from: "top/a.ts", to: "base/a.ts" },
      { from: "top/a.ts", to: "top/b.ts" },
      { from: "work/a.ts", to: "base/words.ts" },
      { from: "base/a.ts", to: "top/a.ts" },
      { from: "left/a.ts", to: "right/a.ts" },
      { from: "work/a.ts", to: "base/a.ts" },
      { from: "cellar/a.ts", to: "base/a.ts" },
      { from: "top/a.ts", to: "cellar/a.ts" },
    ];
    const refused = uses.slice(3).map(({ from, to }) => `${from} uses ${to}`);
    assert.deepEqual(againstOrder(uses, rooms), refused);
  });
  it("has no circles, however long", () => {
    const line = [
      { from: "a", to: "b" },
      { from: "b", to: "c" },
      { from: "a", to: "c" },
      { from: "c", to: "c" },
    ];
    assert.deepEqual(circles(line), []);
    assert.deepEqual(circles([...line, { from: "c", to: "d" }, { from: "d", to: "b" }]), [
      "b -> c -> d -> b",
    ]);
  });
});

/** The uses of a small Rust package, as "from > to". */
const rustUses = (/** @type {Record<string, string>} */ sources, tests = false) =>
  rust
    .usesOf(rust.modulesOf(new Map(Object.entries(sources))), { tests })
    .map(({ from, to }) => `${from} > ${to}`);

describe("Rust", () => {
  const gp = { "gp/mod.rs": "mod kernel;\npub use kernel::Kernel;\n", "gp/kernel.rs": "pub struct Kernel;" };

  it("uses the file in which a name stands, by whatever way it is handed on", () => {
    assert.deepEqual(rustUses({ ...gp, "a.rs": "use crate::gp::Kernel;" }), ["a.rs > gp/kernel.rs"]);
    assert.deepEqual(rustUses({ ...gp, "a.rs": "use crate::{gp::{self, Kernel as K}};" }), [
      "a.rs > gp/mod.rs",
      "a.rs > gp/kernel.rs",
    ]);
    assert.deepEqual(rustUses({ ...gp, "a.rs": "fn f() { crate::gp::Kernel::new() }" }), [
      "a.rs > gp/kernel.rs",
    ]);
    assert.deepEqual(rustUses({ ...gp, "gp/a.rs": "use super::Kernel;" }), ["gp/a.rs > gp/kernel.rs"]);
    assert.deepEqual(rustUses({ ...gp, "gp/a.rs": "use super::*;" }), ["gp/a.rs > gp/mod.rs"]);
  });
  it("does not count handing on, unless the name is used there or comes from elsewhere", () => {
    assert.deepEqual(rustUses(gp), []);
    assert.deepEqual(rustUses({ ...gp, "gp/mod.rs": `${gp["gp/mod.rs"]}fn f(k: Kernel) {}` }), [
      "gp/mod.rs > gp/kernel.rs",
    ]);
    assert.deepEqual(rustUses({ ...gp, "gp/mod.rs": "mod kernel;\nfn f() { kernel::Kernel; }" }), [
      "gp/mod.rs > gp/kernel.rs",
    ]);
    assert.deepEqual(rustUses({ ...gp, "a/mod.rs": "pub use crate::gp::Kernel;" }), [
      "a/mod.rs > gp/kernel.rs",
    ]);
  });
  it("does not count comments, texts, other packages", () => {
    const code = `// use crate::gp;\n/* crate::gp */ const A: &str = "crate::gp \\" crate::gp"; const B: char = '"';
      use std::gp; use vcgpdm::gp::Kernel; const C: &str = r#"" crate::gp"#; fn f<'a>(x: &'a str) {}`;
    assert.deepEqual(rustUses({ ...gp, "a.rs": code }), []);
    assert.deepEqual(rustUses({ ...gp, "a.rs": `${code} use crate::gp;` }), ["a.rs > gp/mod.rs"]);
  });
  it("counts what tests use where that is asked for", () => {
    const sources = {
      ...gp,
      "a.rs":
        "fn f() {}\n#[cfg(test)]\nmod tests {\n use super::*; use crate::gp::Kernel; fn g() { if f {} }\n}\n",
      "b/mod.rs": "#[cfg(test)]\nmod tests;",
      "b/tests.rs": "use super::*;\nuse crate::gp;",
    };
    assert.deepEqual(rustUses(sources), []);
    assert.deepEqual(rustUses(sources, true), [
      "a.rs > gp/kernel.rs",
      "b/tests.rs > b/mod.rs",
      "b/tests.rs > gp/mod.rs",
    ]);
  });
  it("names packages only where they may be named", () => {
    const refused = (/** @type {Record<string, string>} */ sources) =>
      rust.forbiddenNames(
        new Map(Object.entries(sources)),
        rooms.rules.filter(({ verb }) => verb === "name"),
      );
    assert.deepEqual(refused({ "top/roof.rs": "use storm::Wind; // for wasm" }), []);
    assert.deepEqual(refused({ "top/wall.rs": "use storm::Wind;" }), ["top/wall.rs names storm"]);
    assert.deepEqual(
      refused({ "base/a.rs": '#[cfg(target_arch = "wasm32")]\n#[derive(Tsify)]\nstruct A;' }),
      ["base/a.rs names wasm", "base/a.rs names tsify"],
    );
  });
  it("has one style of modules", () => {
    assert.deepEqual(rust.mixedModules(["gp/mod.rs", "gp/psi.rs", "gps.rs"]), []);
    assert.deepEqual(rust.mixedModules(["gp.rs", "gp/psi.rs"]), ["gp.rs stands beside a folder of its name"]);
  });
});

describe("TypeScript", () => {
  const read = (/** @type {string} */ text) =>
    typescript
      .importsOf("top/a.ts", text)
      .map(({ source, typesOnly }) => `${source}${typesOnly ? " (types)" : ""}`);

  it("reads every form of import", () => {
    const text = `
import "./a.css";
import * as all from "./all";
import one, { type Two } from "./one";
import {
  type Three,
  type Four,
} from "./three";
import type { Five } from "./five";
export { six } from "./six";
export * from "./seven";
export const eight = "./eight";
const nine = await import("./nine");
type Ten = typeof import("./ten");
type Eleven = import("./eleven").Eleven;
 * @param {import("./twelve").Twelve} twelve
`;
    assert.deepEqual(read(text), [
      ...["./a.css", "./all", "./one", "./three (types)", "./five (types)", "./six", "./seven", "./nine"],
      ...["./ten (types)", "./eleven (types)", "./twelve (types)"],
    ]);
  });
  it("finds the file that an import names, types too", () => {
    const imports = typescript.importsOf(
      "top/a.ts",
      'import type { B } from "../base/b";\nimport "./a.css?inline";\n',
    );
    assert.deepEqual(typescript.usesOf(imports, new Set(["base/b.ts", "top/a.css"])), [
      { from: "top/a.ts", to: "base/b.ts" },
      { from: "top/a.ts", to: "top/a.css" },
    ]);
    assert.throws(
      () => typescript.usesOf(imports, new Set(["top/a.css"])),
      /imports \.\.\/base\/b, which is not there/,
    );
  });
  it("imports packages only where they belong", () => {
    const refused = (/** @type {string} */ file, /** @type {string} */ text) =>
      typescript.forbiddenPackages(
        typescript.importsOf(file, text),
        rooms.rules.filter(({ verb }) => verb !== "name"),
      );
    assert.deepEqual(
      refused("left/a.ts", 'import { Pane } from "glass";\nimport type { E } from "engine/small";'),
      [],
    );
    assert.deepEqual(refused("base/a.ts", 'import type { Pane } from "glass/panes";'), [
      "base/a.ts imports glass/panes",
    ]);
    assert.deepEqual(refused("top/a.ts", 'import { start } from "engine";'), ["top/a.ts imports engine"]);
    assert.deepEqual(refused("work/a.ts", 'import { start } from "engine";'), []);
  });
});

describe("the length of a file", () => {
  it("counts lines of code, not comments and empty lines", () => {
    const text = "/** Why.\n * And more.\n */\nlet a = 1;\n\n// two\n*a = 2;\n";
    assert.deepEqual(longFiles(new Map([["a.rs", text]]), 2), []);
    assert.deepEqual(longFiles(new Map([["a.rs", text]]), 1), ["a.rs: 2 lines"]);
  });
});
