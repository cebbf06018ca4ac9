// A motion that we write, as three's BVHLoader shows it: on the ground, where the recording has it.
import assert from "node:assert/strict";
import { it } from "node:test";
import { AnimationMixer, Vector3 } from "three";
import { BVHLoader } from "three/addons/loaders/BVHLoader.js";
import { builtPackage } from "../../scripts/package.mjs";

const vcgpdm = builtPackage();

it("the figure stands on the ground", () => {
  const clip = vcgpdm.Clip.sample("walk-1");
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

it("joints with a prefix move once their names are plain", async () => {
  const { Clip, train } = vcgpdm;
  const sample = Clip.sample("walk-1").cut(0, 60).toBvh();
  const clip = Clip.read("mixamo.bvh", sample.replace(/(ROOT|JOINT) /g, "$1 mixamorig:"));
  const short = { latent: 1, dynamicsIps: 3, poseIps: 3, order: 1, framesPerSecond: 15, maxIterations: 1 };
  const model = await train(clip, { ...short, parts: "lower,upper" });
  const completion = model.complete(clip, { given: ["lower"] });
  /** The largest turn of a bone in the first second. */
  const turn = (/** @type {string} */ text) => {
    const { skeleton, clip: motion } = new BVHLoader().parse(text);
    const [root] = skeleton.bones;
    assert.ok(root);
    const rest = skeleton.bones.map((bone) => bone.quaternion.clone());
    const mixer = new AnimationMixer(root);
    mixer.clipAction(motion).play();
    mixer.setTime(0.5);
    return Math.max(...skeleton.bones.map((bone, k) => bone.quaternion.angleTo(rest[k] ?? bone.quaternion)));
  };
  for (const motion of [clip, model.rollout({ frames: 30 }), completion]) {
    assert.match(motion.toBvh(), /ROOT mixamorig:Hips\n/);
    const plain = motion.toBvh({ plainNames: true });
    assert.match(plain, /ROOT Hips\n/);
    assert.doesNotMatch(plain, /:Hips/);
    assert.ok(turn(plain) > 0.1);
  }
});
