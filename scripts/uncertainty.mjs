// `npm run uncertainty`: how far moment matching says what many sampled futures say, measured on the model that the page opens with and
// on models of the sample walks, into docs/uncertainty.md.
import { at, Failure, main, output } from "./run.mjs";
import { putTables } from "./tables.mjs";

await main(async () => {
  const tables = output("cargo", "run", "--release", "--quiet", "--package", "vcgpdm", "--example", "uncertainty");
  if (tables === null) throw new Failure("the uncertainty could not be measured");
  putTables(at("docs/uncertainty.md"), tables);
});
