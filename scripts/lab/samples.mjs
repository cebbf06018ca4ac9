// `npm run lab -- samples FILE.bvh ...`: what sampled rollouts visit of their clip, beside the mean. A model of each
// clip from the first seed; 20 seconds of the mean and of three samples. The table goes to the terminal.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename } from "node:path";
import { at, Failure } from "../run.mjs";

const SECONDS = 20;
const SAMPLES = 3;

export async function samples(/** @type {string[]} */ ...files) {
  /** @type {typeof import("vcgpdm")} */
  const { Clip, train } = createRequire(import.meta.url)(at("crate/wasm/pkg/node/vcgpdm.cjs"));
  if (files.length === 0) throw new Failure("expected BVH files, found none");
  console.log(
    "| clip | the mean | visits, % | turns back, % | samples | visit, % | turn back, % |\n|---|---|---|---|---|---|---|",
  );
  for (const file of files) {
    const model = await train(Clip.read(basename(file), readFileSync(file)), { parts: "lower,upper" });
    const frames = Math.round(SECONDS / model.info().frameTime);
    const found = [model.rollout({ frames }), ...model.sampledRollouts({ frames }, SAMPLES, 1)].map(
      (rollout) => rollout.health(),
    );
    const percent = (/** @type {number} */ share) => `${Math.round(100 * share)}`;
    // The part that visits the fewest poses decides.
    const visited = found.map(({ parts }) => percent(Math.min(...parts.map(({ visited }) => visited ?? 0))));
    const back = found.map(({ pace }) => percent(pace?.turnsBack ?? Number.NaN));
    const [mean, ...drawn] = found.map(({ state }) => state);
    const rest = (/** @type {string[]} */ all) => all.slice(1).join(", ");
    console.log(
      `| ${basename(file, ".bvh")} | ${mean} | ${visited[0]} | ${back[0]} | ${drawn.join(", ")} | ${rest(visited)} | ${rest(back)} |`,
    );
  }
}
