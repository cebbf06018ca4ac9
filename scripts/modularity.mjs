// `npm run modularity`: a library that shares its walking primitive beside a model of each movement, on the sample trials, into
// docs/modularity.md and docs/modularity.svg.
import { at, Failure, main, output } from "./run.mjs";
import { putTables } from "./tables.mjs";

await main(async () => {
  const example = ["--package", "vcgpdm", "--example", "modularity", "--", at("docs/modularity.svg")];
  const tables = output("cargo", "run", "--release", "--quiet", ...example);
  if (tables === null) throw new Failure("the modularity test could not be run");
  putTables(at("docs/modularity.md"), tables);
});
