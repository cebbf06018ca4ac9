// The README's example for Node, run as it stands there.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, it } from "node:test";
import { at } from "../../scripts/run.mjs";
import { installPackage } from "./package.mjs";

/** @type {Awaited<ReturnType<typeof installPackage>>} */
let installed;
before(async () => {
  installed = await installPackage();
});
after(() => installed?.remove());

it("the README's example trains a model and writes a motion", () => {
  const blocks = [...readFileSync(at("README.md"), "utf8").matchAll(/^```js\r?\n([\s\S]*?)^```/gm)].map(
    ([, code]) => code ?? "",
  );
  const [example, ...more] = blocks.filter((code) => code.includes('from "vcgpdm"'));
  assert.ok(example, "README.md has a block of JavaScript that imports vcgpdm");
  assert.deepEqual(more, [], "and only one");

  const { folder, vcgpdm } = installed;
  const walk = vcgpdm.Clip.samples().find(({ movement }) => movement === "walk");
  assert.ok(walk);
  writeFileSync(join(folder, "walk.bvh"), vcgpdm.Clip.sample(walk.id).toBvh());
  writeFileSync(join(folder, "example.js"), example);
  const printed = execFileSync(process.execPath, ["example.js"], { cwd: folder, encoding: "utf8" });
  assert.match(printed, /bound -?\d/);

  const model = vcgpdm.Model.fromJson(readFileSync(join(folder, "model.json"), "utf8"));
  assert.equal(model.info().parts.length, 2);
  const motion = vcgpdm.Clip.read("new-walk.bvh", readFileSync(join(folder, "new-walk.bvh")));
  assert.equal(motion.info().frames, 300);
});
