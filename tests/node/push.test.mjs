// What the story says of a push: the walk of the first model comes back to its loop.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { at } from "../../scripts/run.mjs";
import { coupledInfo } from "./package.mjs";

const vcgpdm = builtPackage();

/** Frames of a pull, and metres in each of them. */
const PULL = 10;
const METRES = 0.08;

it("a pulled hand or foot takes a part off its loop, and four seconds later the walk is back", async () => {
  const model = vcgpdm.Model.fromJson(readFileSync(at("www/public/first/model.json"), "utf8"));
  const info = coupledInfo(model);
  const rollout = model.rollout({ frames: 300, sequence: 0, alpha: null, reading: "as-learned" });
  const nodeOf = (/** @type {string} */ name) =>
    info.figure.nodes.findIndex(({ joint, endSite }) => !endSite && info.joints[joint]?.name === name);
  for (const [part, name] of /** @type {const} */ ([
    [1, "RightHand"],
    [1, "LeftHand"],
    [0, "RightFoot"],
  ]))
    for (const start of [150, 158, 166, 174])
      for (const direction of [
        [0, METRES, 0],
        [METRES, 0, 0],
        [0, 0, -METRES],
      ]) {
        const live = new vcgpdm.Endless(rollout, start);
        const [x = 0, y = 0, z = 0] = direction;
        let farthest = 0;
        for (let frame = 0; frame < PULL; frame++) {
          live.pull(nodeOf(name), x, y, z);
          farthest = Math.max(farthest, live.advance(1).distances()[part] ?? 0);
        }
        const back = live.advance(150).distances().subarray(-60);
        assert.ok(farthest > 0.25, `${name} from frame ${start}, ${direction}: ${farthest} off`);
        assert.ok(
          Math.max(...back) < 0.12,
          `${name} from frame ${start}, ${direction}: ${Math.max(...back)}`,
        );
      }
});

it("arms follow driven legs at half to twice the learned pace, forward and back, and stop when they stop", async (test) => {
  const model = vcgpdm.Model.fromJson(readFileSync(at("www/public/first/model.json"), "utf8"));
  const rollout = model.rollout({ frames: 300, sequence: 0, alpha: null, reading: "as-learned" });
  const wrapped = (/** @type {number} */ turns) => turns - Math.round(turns);
  // The learned step takes 34 frames.
  for (const perTurn of [68, 45, 34, 25, 17, -68, -34, Number.POSITIVE_INFINITY]) {
    const live = new vcgpdm.Endless(rollout, 250);
    let [arms, before] = [0, live.advance(1).phases()[1] ?? Number.NaN];
    for (let frame = 0; frame < 300; frame++) {
      live.drive(0, 1 / perTurn);
      const now = live.advance(1).phases()[1] ?? Number.NaN;
      arms += wrapped(now - before);
      before = now;
    }
    // They need a moment to catch up, at twice the pace up to one turn.
    const legs = 300 / perTurn;
    const words = `in 10 s the legs turn ${legs.toFixed(1)} times, the arms ${arms.toFixed(1)} times`;
    test.diagnostic(words);
    assert.ok(Math.abs(arms - legs) < 1.2, words);
  }
  const live = new vcgpdm.Endless(rollout, 250);
  assert.throws(() => live.drive(2, 0), /expected a part from 0 to 1, found 2/);
  assert.throws(() => live.drive(0, 99), /expected from -10 to 10 turns, found 99/);
  live.release(1);
});

it("a recording moves the legs, the arms follow, and a hand follows a place until it is released", async () => {
  const model = vcgpdm.Model.fromJson(readFileSync(at("www/public/first/model.json"), "utf8"));
  const info = coupledInfo(model);
  const rollout = model.rollout({ frames: 300, sequence: 0, alpha: null, reading: "as-learned" });
  const walk = vcgpdm.Clip.read("walk.bvh", new TextEncoder().encode(rollout.toBvh()));
  const { name = "" } = info.parts[0] ?? {};
  const latents = model.complete(walk, { given: [name] }).latents(0);

  const live = new vcgpdm.Endless(rollout, 150);
  assert.ok(
    live
      .advance(3)
      .recorded()
      .every((frame) => frame === -1),
  );
  live.record(0, latents);
  live.advance(60);
  const moved = live.advance(30);
  const frames = [...moved.recorded()];
  const first = frames[0] ?? Number.NaN;
  assert.deepEqual(
    frames,
    Array.from({ length: 60 }, (_, k) => (k % 2 === 0 ? first + k / 2 : -1)),
  );
  const phases = moved.phases();
  for (let frame = 0; frame < 30; frame++) {
    const apart = (phases[2 * frame] ?? Number.NaN) - (phases[2 * frame + 1] ?? Number.NaN);
    assert.ok(Math.abs(apart - Math.round(apart)) < 0.1, `frame ${frame}: ${apart}`);
  }
  assert.throws(() => live.record(0, new Float64Array(7)), /expected latents of a recording .*found 1 x 7/);
  assert.throws(() => live.record(5, latents), /expected a part from 0 to 1, found 5/);
  live.release(0);

  const hand = info.figure.nodes.findIndex(
    ({ joint, endSite }) => !endSite && info.joints[joint]?.name === "RightHand",
  );
  const nodes = info.figure.nodes.length;
  const place = (/** @type {Float32Array} */ positions, /** @type {number} */ frame) =>
    [0, 1, 2].map((axis) => {
      const at = (/** @type {number} */ node) => positions[3 * (frame * nodes + node) + axis] ?? Number.NaN;
      return at(hand) - at(0);
    });
  const wanted = place(live.advance(10).positions(), 0);
  const [x = 0, y = 0, z = 0] = wanted;
  live.reach(hand, x, y, z);
  const reached = place(live.advance(40).positions(), 39);
  const away = Math.hypot(...reached.map((now, axis) => now - (wanted[axis] ?? Number.NaN)));
  assert.ok(away < 0.03, `${away} m`);
  assert.throws(() => live.reach(hand, Number.NaN, 0, 0), /expected a place of three finite numbers/);
  live.release(1);
  assert.ok((live.advance(150).distances().at(-1) ?? 1) < 0.2, "the arms are home");
});
