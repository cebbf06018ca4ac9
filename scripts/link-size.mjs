// `npm run link-size -- [MODEL.json]`: the characters of a link with this model in it, and how many of them each
// part of the model takes: the difference to a link without these fields. Without a file: the model of the page.
import { readFileSync } from "node:fs";
import { parseArgs } from "node:util";
import { runnerImport } from "vite";
import { at, main } from "./run.mjs";

/** The fields of each part of a vCGPDM. */
const PARTS = {
  "sums, to infer experts again": ["sum_psi2", "sum_psi1_mu", "other_precision", "other_b"],
  "poses at inducing points": ["v_mean"],
  "covariances of inducing outputs": ["u_covariance", "v_covariance"],
  "inducing points, and the next states": ["z", "r", "u_mean"],
  "skeleton, pose and column means": ["skeleton", "positions", "first", "column_means"],
};

await main(async () => {
  const { positionals } = parseArgs({ allowPositionals: true });
  const document = JSON.parse(readFileSync(positionals[0] ?? at("www/first/model.json"), "utf8"));
  /** @type {{ module: { packed(document: string): Promise<string> } }} */
  const { module } = await runnerImport(at("www/src/links/packed-model.ts"), { configFile: false });
  const length = async (/** @type {readonly string[]} */ without) => {
    const text = JSON.stringify(document, (name, value) => (without.includes(name) ? undefined : value));
    return (await module.packed(text)).length;
  };
  const whole = await length([]);
  let rest = whole;
  const line = (/** @type {string} */ what, /** @type {number} */ characters) =>
    console.log(`${what.padEnd(40)}${characters.toLocaleString("en").padStart(8)}`);
  for (const [what, fields] of Object.entries(PARTS)) {
    const characters = whole - (await length(fields));
    rest -= characters;
    line(what, characters);
  }
  line("everything else", rest);
  line("the packed model", whole);
});
