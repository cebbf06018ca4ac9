// `npm run splits -- FOLDER ...`: what decides whether parts pay, measured on the clips (.bvh) of each folder and on the sample walks, into
// docs/comparison.md.
import { at, Failure, main, output } from "./run.mjs";
import { putTables } from "./tables.mjs";

await main(async () => {
  const cargo = ["run", "--release", "--quiet", "--package", "vcgpdm", "--example", "splits"];
  const table = output("cargo", ...cargo, "--", ...process.argv.slice(2));
  if (table === null) throw new Failure("the splits could not be compared");
  putTables(at("docs/comparison.md"), table, "splits");
});
