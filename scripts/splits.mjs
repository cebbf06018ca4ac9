// `npm run splits -- FOLDER ...`: what decides whether parts pay, measured on the clips (.bvh) of each folder
// and on the sample walks, into docs/comparison.md.
import { at, main } from "./run.mjs";
import { measured, putTables } from "./tables.mjs";

await main(async () =>
  putTables(at("docs/comparison.md"), measured("splits", ...process.argv.slice(2)), "splits"),
);
