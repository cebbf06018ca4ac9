// `npm run effects`: what each coupling does to the body, measured on the model that the page opens with and on models of the sample
// walks, into docs/couplings.md. With clips or folders of them (`npm run effects -- CLIPS`) the same of models of these, on the
// terminal.
import { at, Failure, main, output, run } from "./run.mjs";
import { putTables } from "./tables.mjs";

const CARGO = ["run", "--release", "--quiet", "--package", "vcgpdm", "--example", "effects"];

await main(async () => {
  const clips = process.argv.slice(2);
  if (clips.length > 0) {
    await run("cargo", ...CARGO, "--", ...clips);
    return;
  }
  const tables = output("cargo", ...CARGO);
  if (tables === null) throw new Failure("the couplings could not be measured");
  putTables(at("docs/couplings.md"), tables);
});
