// Clips for the page's tests.
import assert from "node:assert/strict";
import { Clip } from "../../crate/wasm/pkg/node/vcgpdm.js";

/** A clip as a visitor may bring it; another number, another movement. */
export function bvh(number = 0) {
  const wave = Clip.samples().filter(({ movement }) => movement !== "walk")[number];
  assert.ok(wave);
  return Clip.sample(wave.id).cut(0, 60).toBvh();
}
