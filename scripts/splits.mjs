// `npm run splits -- FOLDER ...`: what decides whether parts pay, measured on the clips (.bvh) of each folder
// and on the sample walks, into docs/comparison/splits.md.
import { at, main } from "./run.mjs";
import { measured, writeTables } from "./tables.mjs";

await main(async () =>
  writeTables(at("docs/comparison/splits.md"), {
    title: "When parts pay",
    command: "npm run splits",
    tables: measured("splits", ...process.argv.slice(2)),
  }),
);
