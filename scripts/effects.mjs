// `npm run effects`: what each coupling does to the body, measured on the model that the page opens with and
// on models of the sample walks, into docs/couplings.md. With clips or folders of them (`npm run effects --
// CLIPS`) the same of models of these, on the terminal.
import { at, main, run } from "./run.mjs";
import { example, measured, putTables } from "./tables.mjs";

await main(async () => {
  const clips = process.argv.slice(2);
  if (clips.length > 0) await run("cargo", ...example("effects", ...clips));
  else putTables(at("docs/couplings.md"), measured("effects"));
});
