// `npm run lab -- NAME ...`: the measurements behind the documents. Their tables go into docs or to the terminal.
import { comparison } from "./lab/comparison.mjs";
import { completing } from "./lab/completing.mjs";
import { modularity } from "./lab/modularity.mjs";
import { study } from "./lab/study.mjs";
import { measured, printTables, putTables, writeTables } from "./lab/tables.mjs";
import { at, Failure, main } from "./run.mjs";

/** @type {Record<string, (...words: string[]) => Promise<void> | void>} */
const MEASUREMENTS = {
  comparison,
  completing,
  modularity,
  study,
  /** Of models of these clips or folders on the terminal; without them, of the project's models into docs. */
  effects: (...clips) =>
    clips.length > 0
      ? printTables("effects", ...clips)
      : putTables(at("docs/couplings.md"), measured("effects")),
  objectives: (...folders) => printTables("objectives", ...folders),
  "own-rollouts": (...words) => printTables("own-rollouts", ...words),
  scaling: () => printTables("scaling"),
  seeds: (...words) => printTables("seeds", ...words),
  splits: (...folders) =>
    writeTables(at("docs/comparison/splits.md"), {
      title: "When parts pay",
      command: "npm run lab -- splits",
      tables: measured("splits", ...folders),
    }),
  recognition: (...folders) => printTables("recognition", ...folders),
  synthetic: (...words) => printTables("synthetic", ...words),
  uncertainty: () => putTables(at("docs/uncertainty.md"), measured("uncertainty")),
};

await main(async () => {
  const [name = "", ...words] = process.argv.slice(2);
  const measurement = MEASUREMENTS[name];
  if (!measurement)
    throw new Failure(`expected one of ${Object.keys(MEASUREMENTS).join(", ")}; found ${name || "no name"}`);
  await measurement(...words);
});
