// A motion that we write, as three's BVHLoader shows it: on the ground, where the recording has it.
import assert from "node:assert/strict";
import { after, before, it } from "node:test";
import { AnimationMixer, Vector3 } from "three";
import { BVHLoader } from "three/addons/loaders/BVHLoader.js";
import { installPackage } from "./package.mjs";

/** @type {Awaited<ReturnType<typeof installPackage>>} */
let installed;
before(async () => {
  installed = await installPackage();
});
after(() => installed?.remove());

it("the figure stands on the ground", () => {
  const clip = installed.vcgpdm.Clip.sample("walk-1");
  const { height, frameTime } = clip.info();
  const { skeleton, clip: motion } = new BVHLoader().parse(clip.toBvh());
  const [root] = skeleton.bones;
  assert.ok(root);
  const mixer = new AnimationMixer(root);
  mixer.clipAction(motion).play();
  for (const frame of [0, 100, 200]) {
    mixer.setTime(frame * frameTime);
    root.updateMatrixWorld(true);
    const heights = skeleton.bones.map((bone) => bone.getWorldPosition(new Vector3()).y);
    const [lowest, highest] = [Math.min(...heights), Math.max(...heights)];
    assert.ok(Math.abs(lowest) < 0.05 * height, `frame ${frame}: the lowest point is at ${lowest}`);
    assert.ok(
      Math.abs(highest - height) < 0.15 * height,
      `frame ${frame}: the highest point is at ${highest}`,
    );
  }
});
