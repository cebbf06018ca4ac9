// Clips for the page's tests.
import assert from "node:assert/strict";
import { Clip } from "../../crate/wasm/pkg/node/vcgpdm.js";

/** The file of a visitor's clip; each number gives another movement. */
export function bvh(number = 0) {
  const wave = Clip.samples().filter(({ movement }) => movement !== "walk")[number];
  assert.ok(wave);
  return Clip.sample(wave.id).cut(0, 60).toBvh();
}
