// Clips for the page's tests.
import assert from "node:assert/strict";
import { Clip } from "../../crate/wasm/pkg/node/vcgpdm.js";

/** A clip as a visitor may bring it. */
export function bvh() {
  const wave = Clip.samples().find(({ movement }) => movement !== "walk");
  assert.ok(wave);
  return Clip.sample(wave.id).cut(0, 60).toBvh();
}
