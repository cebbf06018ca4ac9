// docs/examples/rollout.py, written from the documentation of the file alone, agrees with `vcgpdm rollout`.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, it } from "node:test";
import { environment, install } from "../../scripts/python.mjs";
import { at, Failure, root } from "../../scripts/run.mjs";

const { python, has } = environment("files");
const program = at("target/debug", process.platform === "win32" ? "vcgpdm.exe" : "vcgpdm");
const call = (/** @type {string} */ name, /** @type {string[]} */ ...args) =>
  execFileSync(name, args, { cwd: root, encoding: "utf8", maxBuffer: 1 << 28 });

/** @type {string} */
let folder;
/** @type {string | false} */
let skip = false;
try {
  await install("files", at("tests/files/requirements.txt"));
  if (!has("numpy")) skip = "numpy could not be installed";
} catch (error) {
  if (!(error instanceof Failure)) throw error;
  skip = error.message;
}

describe("docs/examples/rollout.py", { skip }, () => {
  before(() => {
    folder = mkdtempSync(join(tmpdir(), "vcgpdm-rollout-"));
  });
  after(() => rmSync(folder, { recursive: true, force: true }));

  /** How far the script is from the program: latents, and joints as a share of the body's height. */
  function apart(/** @type {string} */ model, /** @type {number} */ frames, /** @type {number} */ sequence) {
    const file = (/** @type {string} */ name) => join(folder, name);
    const asked = ["rollout", model, "--frames", `${frames}`, "--from", `${sequence}`];
    call(program, ...asked, "--out", file("theirs.bvh"), "--latents", file("theirs.csv"));
    const script = at("docs/examples/rollout.py");
    call(python, script, model, `${frames}`, file("latents.csv"), file("places.csv"), `${sequence}`);
    const { height } = JSON.parse(readFileSync(model, "utf8")).pose.stage;
    const files = ["latents.csv", "places.csv", "theirs.csv", "theirs.bvh"].map(file);
    return call(python, at("tests/files/compare.py"), ...files, `${height}`)
      .trim()
      .split(" ")
      .map(Number);
  }

  it("walks as the model that the page opens with", () => {
    const [latents = 1, joints = 1] = apart(at("www/first/model.json"), 200, 1);
    assert.ok(latents < 1e-9, `latents are ${latents} apart`);
    assert.ok(joints < 1e-6, `joints are ${joints} of the height apart`);
  });

  it("knows three parts, another order and a body whose z points up", () => {
    const walk = join(folder, "walk.bvh");
    call(program, "clip", "sample:walk-1", "--out", walk);
    // The same walk with z up: offsets and positions turn, and the root's rotation gets a turn before its
    // own.
    writeFileSync(walk, zUp(readFileSync(walk, "utf8")));
    const model = join(folder, "model.json");
    const settings = [
      "--latent",
      "2",
      "--order",
      "3",
      "--max-iterations",
      "30",
      "--fps",
      "20",
      "--dynamics-ips",
      "6",
    ];
    call(program, "train", walk, "--parts", "legs,trunk,left arm,right arm", ...settings, "--out", model);
    assert.equal(JSON.parse(readFileSync(model, "utf8")).pose.stage.up, "z");
    const [latents = 1, joints = 1] = apart(model, 60, 0);
    assert.ok(latents < 1e-9, `latents are ${latents} apart`);
    assert.ok(joints < 1e-6, `joints are ${joints} of the height apart`);
  });
});

/** A clip with y up as one with z up: the axes are renamed x to y, y to z, z to x. */
function zUp(/** @type {string} */ bvh) {
  const next = { X: "Y", Y: "Z", Z: "X" };
  const turned = bvh.replace(
    /[XYZ](?=position|rotation)/g,
    (axis) => next[/** @type {"X" | "Y" | "Z"} */ (axis)],
  );
  return turned.replace(/OFFSET (\S+) (\S+) (\S+)/g, "OFFSET $3 $1 $2");
}
