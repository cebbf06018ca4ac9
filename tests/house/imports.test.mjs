// The order of the house: which room may use which, as ARCHITECTURE.md draws it. Both are held together here.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { extname, relative, sep } from "node:path";
import { describe, it } from "node:test";
import { at, filesUnder } from "../../scripts/run.mjs";
import { longFiles } from "./lines.mjs";
import { againstOrder, circles, readRooms, strangeRooms } from "./rooms.mjs";
import * as rust from "./rust.mjs";
import * as typescript from "./typescript.mjs";

const document = readFileSync(at("ARCHITECTURE.md"), "utf8");
const LINES = 400;

/** The text of all files of these kinds in a folder, by their paths below it. */
function read(/** @type {string} */ folder, /** @type {string[]} */ endings) {
  const without = ["node_modules", "dist", "pkg", "target", "public"];
  const files = filesUnder([at(folder)], [...without, ...(folder === "tests" ? ["golden"] : [])]);
  const chosen = files.filter((file) => endings.includes(extname(file)));
  assert.ok(chosen.length > 0, `${folder} holds ${endings.join(", ")}`);
  return new Map(
    chosen.map((file) => [relative(at(folder), file).split(sep).join("/"), readFileSync(file, "utf8")]),
  );
}

for (const name of ["vcgpdm", "lab"]) {
  describe(`the package ${name} in Rust`, () => {
    const rooms = readRooms(document, `crate/${name}/src`);
    const sources = read(`crate/${name}/src`, [".rs"]);
    const modules = rust.modulesOf(sources);
    const inside = [...sources.keys()].filter((file) => file !== "lib.rs");

    it("has the rooms of the order", () => assert.deepEqual(strangeRooms(inside, rooms), []));
    it("uses only what stands before, in its tests too", () => {
      const uses = rust.usesOf(modules, { tests: true });
      assert.ok(uses.length > sources.size, "uses are found");
      assert.deepEqual(
        againstOrder(
          uses.filter(({ from }) => from !== "lib.rs"),
          rooms,
        ),
        [],
      );
    });
    it("names neither the web nor another's packages", () => {
      assert.deepEqual(rust.forbiddenNames(sources, rooms.rules), []);
      const manifest = readFileSync(at(`crate/${name}/Cargo.toml`), "utf8")
        .replace(/#.*/g, "")
        .replaceAll("-", "_");
      const nobodys = rooms.rules.filter(({ places }) => places.length === 0);
      assert.ok(nobodys.length > 0);
      assert.deepEqual(rust.forbiddenNames(new Map([["Cargo.toml", manifest]]), nobodys), []);
    });
  });
}

describe("the packages in Rust", () => {
  const rooms = readRooms(document, "crate");
  const manifests = read("crate", [".toml"]);

  it("use only what stands before", () => {
    assert.deepEqual(strangeRooms([...manifests.keys()], rooms), []);
    const uses = [...manifests].flatMap(([from, text]) =>
      [...text.matchAll(/path = "\.\.\/([\w-]+)"/g)].map(([, to = ""]) => ({ from, to: `${to}/Cargo.toml` })),
    );
    assert.ok(uses.length > 0);
    assert.deepEqual(againstOrder(uses, rooms), []);
  });
  for (const name of rooms.floors.keys()) {
    it(`have no circles and one style of modules: ${name}`, () => {
      const sources = read(`crate/${name}/src`, [".rs"]);
      assert.deepEqual(circles(rust.usesOf(rust.modulesOf(sources), { tests: false })), []);
      assert.deepEqual(rust.mixedModules([...sources.keys()]), []);
    });
  }
});

describe("the page in TypeScript", () => {
  const rooms = readRooms(document, "www/src");
  const sources = read("www/src", [".ts", ".js", ".css"]);
  const imports = [...sources].flatMap(([file, text]) => typescript.importsOf(file, text));
  const uses = typescript.usesOf(imports, new Set(sources.keys()));

  it("has the rooms of the order", () => assert.deepEqual(strangeRooms([...sources.keys()], rooms), []));
  it("imports only what stands before", () => {
    assert.ok(uses.length > sources.size, "imports are found");
    assert.deepEqual(againstOrder(uses, rooms), []);
  });
  it("has no circles", () => assert.deepEqual(circles(uses), []));
  it("imports packages where they belong", () => {
    assert.deepEqual(typescript.forbiddenPackages(imports, rooms.rules), []);
  });
});

describe("a file", () => {
  it(`has at most ${LINES} lines of code`, () => {
    for (const folder of ["crate", "www", "scripts", "tests"])
      assert.deepEqual(longFiles(read(folder, [".rs", ".ts", ".js", ".mjs", ".css"]), LINES), []);
  });
});
