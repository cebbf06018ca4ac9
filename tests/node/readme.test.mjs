// Every snippet of the package's README, run as it stands there. A browser runs the worker's (tests/clients)
// and the figure's (tests/e2e/figure.test.mjs).
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { before, describe, it } from "node:test";
import { at } from "../../scripts/run.mjs";
import { installedPackage } from "./package.mjs";

const installed = await installedPackage();
before(async () => {
  const { Clip } = installed.vcgpdm;
  writeFileSync(join(installed.folder, "walk.bvh"), Clip.sample("walk-1").toBvh());
});

const readme = readFileSync(at("crate/wasm/README.md"), "utf8");
const snippets = [...readme.matchAll(/^```(js|ts)\r?\n([\s\S]*?)^```/gm)].map(
  ([, language = "", code = ""]) => ({
    language,
    code,
  }),
);

/** What a snippet is to print, by what tells it from the others. */
const PRINTS = /** @type {[string, RegExp][]} */ ([
  ["new-walk.bvh", /^(\d+ iterations, weighted objective -?\d+ nats\n)+$/],
  ["trainer.notices()", /^(settled|iterations) after \d+ \[\]\n$/],
  ["Model, Results", /^(?=.*model)(?=.*results)VcgpdmError model .*\nVcgpdmError results .*\n$/s],
  ["alpha[0][1] *= 10; // the first", /^vcgpdm frame,time,Hips\.yaw_rate,.*\n[a-z-]+\n(-?\d+\.\d+\n){2}$/],
  ["addTable", /^frame,time,x,y,follower\n0,0,/],
  ["await init();\nconsole", /^252\n$/],
  ["clip.free()", /^freed expected an object in use, found one after its free\(\)\n$/],
  ["using clip", /^252\n$/],
]);

const IN_BROWSERS = /^\/\/ worker\.js|\bfigure\./;

describe("the README of the npm package", () => {
  for (const { language, code } of snippets.filter(({ code }) => !IN_BROWSERS.test(code))) {
    const [mark, printed] = PRINTS.find(([mark]) => code.includes(mark)) ?? [];
    it(`runs: ${mark ?? code.split("\n")[0]}`, () => {
      assert.ok(printed, "a snippet that no test knows");
      const { folder } = installed;
      writeFileSync(join(folder, `example.m${language}`), code);
      if (language === "ts") {
        const compiler = at("node_modules/typescript/bin/tsc");
        const how = [
          "--strict",
          "--target",
          "es2022",
          "--module",
          "nodenext",
          "--lib",
          "esnext,dom",
          "--skipLibCheck",
          "false",
        ];
        execFileSync(process.execPath, [compiler, ...how, "example.mts"], { cwd: folder });
      }
      assert.match(
        execFileSync(process.execPath, ["example.mjs"], { cwd: folder, encoding: "utf8" }),
        printed,
      );
    });
  }

  it("has all of them", () => {
    const inBrowsers = snippets.filter(({ code }) => IN_BROWSERS.test(code));
    const known = snippets.filter(
      (snippet) => !inBrowsers.includes(snippet) && PRINTS.some(([mark]) => snippet.code.includes(mark)),
    );
    assert.deepEqual(
      [known.length, inBrowsers.length, snippets.length],
      [PRINTS.length, 3, PRINTS.length + 3],
    );
  });

  it("leaves a model of two parts and a motion", () => {
    const { folder, vcgpdm } = installed;
    const model = vcgpdm.Model.fromJson(readFileSync(join(folder, "model.json"), "utf8"));
    assert.equal(model.info().parts.length, 2);
    const motion = vcgpdm.Clip.read("new-walk.bvh", readFileSync(join(folder, "new-walk.bvh")));
    assert.equal(motion.info().frames, 300);
  });
});
