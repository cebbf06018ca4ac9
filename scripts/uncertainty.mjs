// `npm run uncertainty`: how far moment matching says what many sampled futures say, measured on the model
// that the page opens with and on models of the sample walks, into docs/uncertainty.md.
import { at, main } from "./run.mjs";
import { measured, putTables } from "./tables.mjs";

await main(async () => putTables(at("docs/uncertainty.md"), measured("uncertainty")));
