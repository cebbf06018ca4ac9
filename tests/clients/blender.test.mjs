// Blender reads our files, and docs/examples/to_bvh.py converts other formats into files that we read.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, it } from "node:test";
import { environment, install } from "../../scripts/python.mjs";
import { at, Failure } from "../../scripts/run.mjs";

/** @type {typeof import("vcgpdm")} */
const { Clip } = createRequire(import.meta.url)(at("crate/wasm/pkg/node/vcgpdm.js"));
const { python, has } = environment("blender");

/** @type {string | false} */
let skip = false;
try {
  await install("blender", at("tests/clients/blender.txt"));
  if (!has("bpy")) skip = "bpy was installed, but cannot be loaded here";
} catch (error) {
  if (!(error instanceof Failure)) throw error;
  skip = error.message;
}

/** @type {string} */
let folder;
const file = (/** @type {string} */ name) => join(folder, name);
const blender = (/** @type {string[]} */ ...args) =>
  execFileSync(python, args, { cwd: folder, encoding: "utf8", stdio: "pipe", maxBuffer: 1 << 26 });

/** Positions of the named joints, in metres for a body 1.7 m tall, y up [frame][joint][3]. */
function placesOf(/** @type {import("vcgpdm").Clip} */ clip, /** @type {string[]} */ names) {
  const { joints, figure, frames } = clip.info();
  const positions = clip.positions();
  const nodes = names.map((name) =>
    figure.nodes.findIndex(({ joint, endSite }) => !endSite && joints[joint]?.name === name),
  );
  assert.ok(!nodes.includes(-1), `the clip has ${names.join(", ")}`);
  return Array.from({ length: frames }, (_, frame) =>
    nodes.map((node) => [...positions.slice(3 * (frame * figure.nodes.length + node)).subarray(0, 3)]),
  );
}

const distance = (/** @type {number[]} */ a, /** @type {number[]} */ b) =>
  Math.hypot(...a.map((value, axis) => value - (b[axis] ?? 0)));

/** How far all pairs of joints are from each other: the same however the body is moved and turned. */
const pairs = (/** @type {number[][]} */ places) =>
  places.flatMap((place, i) => places.slice(i + 1).map((other) => distance(place, other)));

describe("Blender", { skip }, () => {
  before(() => {
    folder = mkdtempSync(join(tmpdir(), "vcgpdm-blender-"));
    writeFileSync(file("walk.bvh"), Clip.sample("walk-1").cut(0, 130).toBvh());
  });
  after(() => rmSync(folder, { recursive: true, force: true }));

  it("shows our BVH with every joint where it is, and standing on the ground", () => {
    blender(at("tests/clients/blender.py"), file("walk.bvh"), file("places.json"));
    const shown = JSON.parse(readFileSync(file("places.json"), "utf8"));
    const clip = Clip.read("walk.bvh", readFileSync(file("walk.bvh")));
    const { height, joints } = clip.info();
    const names = joints.map(({ name }) => name);
    const ours = placesOf(clip, names);
    assert.equal(shown.length, ours.length);
    // Blender's z points up, and its y backwards.
    const theirs = shown.map((/** @type {Record<string, number[]>} */ bones) =>
      names.map((name) => {
        const [x = 0, y = 0, z = 0] = bones[name] ?? [];
        return [x, z, -y].map((value) => (1.7 * value) / height);
      }),
    );
    const shift = theirs[0][0].map(
      (/** @type {number} */ value, /** @type {number} */ axis) => value - (ours[0]?.[0]?.[axis] ?? 0),
    );
    assert.ok(Math.abs(shift[1]) < 0.02, `the body stands ${shift[1]} m too high`);
    ours.forEach((joints, frame) =>
      joints.forEach((place, joint) => {
        const moved = place.map((value, axis) => value + shift[axis]);
        const apart = distance(moved, theirs[frame][joint]);
        assert.ok(apart < 1e-4, `frame ${frame}, ${names[joint]}: ${apart} m away`);
      }),
    );
  });

  it("keeps the way of hips below a root that stands still, through FBX", () => {
    const text = readFileSync(file("walk.bvh"), "utf8");
    const [hierarchy = "", motion = ""] = text.split("MOTION\n");
    const body = hierarchy.replace("HIERARCHY\nROOT ", "JOINT ");
    const channels = "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation";
    const [frames = "", time = "", ...rows] = motion.trimEnd().split("\n");
    const below = rows.map((row) => `0 0 0 0 0 0 ${row}`).join("\n");
    const root = `HIERARCHY\nROOT Reference\n{\nOFFSET 0 0 0\n${channels}\n${body}}\n`;
    writeFileSync(file("still.bvh"), `${root}MOTION\n${frames}\n${time}\n${below}\n`);
    blender(at("tests/clients/blender.py"), file("still.bvh"), file("still.fbx"));
    blender(at("docs/examples/to_bvh.py"), "--", file("still.fbx"), file("still-again.bvh"));
    const way = (/** @type {string} */ name) => {
      const clip = Clip.read(name, readFileSync(file(name)));
      const [hips = []] = placesOf(clip, ["Hips"]).map(([place = []]) => place);
      const last = placesOf(clip, ["Hips"]).at(-1)?.[0] ?? [];
      return distance(hips, last);
    };
    const [ours, theirs] = [way("walk.bvh"), way("still-again.bvh")];
    assert.ok(ours > 1 && Math.abs(theirs / ours - 1) < 0.1, `${theirs} m of ${ours} m`);
  });

  for (const format of ["fbx", "glb"]) {
    it(`turns a motion in ${format} into BVH that moves as it did`, () => {
      blender(at("tests/clients/blender.py"), file("walk.bvh"), file(`walk.${format}`));
      blender(at("docs/examples/to_bvh.py"), "--", file(`walk.${format}`), file(`${format}.bvh`));
      const before = Clip.read("walk.bvh", readFileSync(file("walk.bvh")));
      const after = Clip.read("after.bvh", readFileSync(file(`${format}.bvh`)));
      const [was, is] = [before.info(), after.info()];
      const names = was.joints
        .map(({ name }) => name)
        .filter((name) => is.joints.some((joint) => joint.name === name));
      assert.ok(names.length >= was.joints.length - 1, `${names.length} of ${was.joints.length} joints`);
      assert.ok(Math.abs(is.frames * is.frameTime - was.frames * was.frameTime) < 0.1, "as long as it was");
      const [ours, theirs] = [placesOf(before, names), placesOf(after, names)];
      for (const seconds of [0, 0.5, 1, 2]) {
        const a = pairs(ours[Math.round(seconds / was.frameTime)] ?? []);
        const b = pairs(theirs[Math.round(seconds / is.frameTime)] ?? []);
        // Without the ends of the limbs the height is found otherwise.
        const scale = a.reduce((sum, length) => sum + length) / b.reduce((sum, length) => sum + length);
        a.forEach((length, i) => {
          const apart = Math.abs(length - scale * (b[i] ?? 0));
          assert.ok(apart < 0.01, `${seconds} s: a pair of joints is ${apart} m farther apart or nearer`);
        });
      }
    });
  }
});
