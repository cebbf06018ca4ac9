// `npm run lab -- NAME ...`: the measurements behind the documents. Their tables go into docs or to the terminal.
import { comparison } from "./lab/comparison.mjs";
import { drawings } from "./lab/drawings.mjs";
import { motions } from "./lab/motions.mjs";
import { samples } from "./lab/samples.mjs";
import { study } from "./lab/study.mjs";
import { measured, printTables, putTables } from "./lab/tables.mjs";
import { at, Failure, main } from "./run.mjs";

/** @type {Record<string, (...words: string[]) => Promise<void> | void>} */
const MEASUREMENTS = {
  comparison,
  /** A library that shares its walking primitive beside a model of each movement, on made trials. */
  modularity: () => putTables(at("docs/modularity.md"), measured("modularity", at("docs/modularity.svg"))),
  drawings,
  motions,
  samples,
  study,
  scaling: (...words) => printTables("scaling", ...words),
  seeds: (...words) => printTables("seeds", ...words),
  synthetic: (...words) => printTables("synthetic", ...words),
};

await main(async () => {
  const [name = "", ...words] = process.argv.slice(2);
  const measurement = MEASUREMENTS[name];
  if (!measurement)
    throw new Failure(`expected one of ${Object.keys(MEASUREMENTS).join(", ")}; found ${name || "no name"}`);
  await measurement(...words);
});
