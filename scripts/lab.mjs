// `npm run lab -- NAME ...`: the measurements behind the documents. Each writes its tables into docs.
import { comparison } from "./lab/comparison.mjs";
import { modularity } from "./lab/modularity.mjs";
import { study } from "./lab/study.mjs";
import { measured, printTables, putTables, writeTables } from "./lab/tables.mjs";
import { at, Failure, main } from "./run.mjs";

/** @type {Record<string, (...words: string[]) => Promise<void> | void>} */
const MEASUREMENTS = {
  comparison,
  modularity,
  study,
  /** With clips or folders of them: of models of these, on the terminal. */
  effects: (...clips) =>
    clips.length > 0
      ? printTables("effects", ...clips)
      : putTables(at("docs/couplings.md"), measured("effects")),
  splits: (...folders) =>
    writeTables(at("docs/comparison/splits.md"), {
      title: "When parts pay",
      command: "npm run lab -- splits",
      tables: measured("splits", ...folders),
    }),
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
