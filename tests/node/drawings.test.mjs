// Thirty drawings of many kinds: a model of each goes on with it for twenty seconds.
import assert from "node:assert/strict";
import { it } from "node:test";
import { runnerImport } from "vite";
import { at } from "../../scripts/run.mjs";
import { installedPackage } from "./package.mjs";

const installed = await installedPackage();

const load = async (/** @type {string} */ name) =>
  /** @type {any} */ ((await runnerImport(at(`www/src/drawing/${name}.ts`), { configFile: false })).module);

const LEAST = 27;

/** The seeds of the thirty hands: the settings were chosen on the first, and judged on the others. */
for (const seed of [0, 100])
  it(`${LEAST} of 30 drawings go on, hands of seed ${seed}`, async () => {
    const { Table, Trainer, TrainingSet } = installed.vcgpdm;
    const [{ drawingOf, ROWS_A_SECOND }, { goesOn }, { HANDS, strokesOf }, { DRAWING_SETTINGS }] =
      await Promise.all(["hand", "goes-on", "drawings.fake", "drawing-settings"].map(load));
    const stopped = [];
    for (const hand of HANDS) {
      const { rows, lap } = drawingOf([strokesOf({ ...hand, seed: hand.seed + seed })]);
      const set = new TrainingSet();
      set.addTable(Table.of("drawing", ["x", "y"], new Float64Array(rows.flat()), 1 / ROWS_A_SECOND));
      const parts = [{ name: "hand", columns: ["x", "y"] }];
      const trainer = new Trainer(set, { ...DRAWING_SETTINGS, parts });
      while (!trainer.step().done);
      const values = trainer
        .model()
        .rollout({ frames: 20 * ROWS_A_SECOND })
        .values();
      const path = Array.from({ length: values.length / 2 }, (_, i) => [values[2 * i], values[2 * i + 1]]);
      if (!goesOn(rows, path, lap).goesOn) stopped.push(`${hand.shape}, ${hand.laps} times`);
    }
    assert.ok(30 - stopped.length >= LEAST, stopped.join("; "));
  });
