// Thirty drawings of many kinds: a model of each goes on with it for twenty seconds.
import assert from "node:assert/strict";
import { it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { drawingModule, learner } from "../../scripts/lab/drawings.mjs";

const vcgpdm = builtPackage();

const LEAST = 27;

/** The seeds of the thirty hands: the settings were chosen on the first, and judged on the others. */
for (const seed of [0, 100])
  it(`${LEAST} of 30 drawings go on, hands of seed ${seed}`, async () => {
    const [learn, { HANDS, strokesOf }] = await Promise.all([
      learner(vcgpdm),
      drawingModule("drawings.fake"),
    ]);
    const stopped = HANDS.filter(
      (/** @type {any} */ hand) => !learn(strokesOf({ ...hand, seed: hand.seed + seed }))?.goesOn,
    );
    assert.ok(30 - stopped.length >= LEAST, JSON.stringify(stopped));
  });
