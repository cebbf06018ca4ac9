// `npm run lab -- study`: the study that comes with the page, from the walks that the program makes itself, and the
// check of the analysis against the numbers of the paper in docs/perception.md. Finished trainings are kept
// in target/study. Since the study was made, trainings have changed: a new one has other movements and another hash,
// and recorded answers do not fit it.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname } from "node:path";
import { at, Failure, output, run } from "../run.mjs";
import { samples } from "./subjects.mjs";
import { putTables } from "./tables.mjs";

const program = at("target/release/vcgpdm");
const results = at("target/study/walks.results.json");
const shown = at("www/public/study/walks.study.json");
/** More than a visitor should wait for who only wants to try it. */
const LARGEST = 400_000;

const walks = samples("walk", 6);
const [trials, unseen] = [walks.slice(0, 4), walks.slice(4)];

/**
 * All models, each with several sizes where it has one; 400 iterations are enough for short walks that are
 * all alike.
 */
const SWEEPS = [
  ["--models", "tmp,dmp-discrete", "--primitives", "1,2,4,8", "--bases", "3,10,25,80"],
  ["--models", "vcgpdm,vgpdm", "--ips", "3,12", "--pose-ips", "4,12", "--max-iterations", "400"],
  ["--models", "map-gpdm,map-cgpdm", "--max-iterations", "400"],
];
/**
 * Movements that anybody sees to be wrong, marked by hand: with three basis functions the figure glides with
 * hardly a step.
 */
const FAILED = ["dmp-discrete-3-trial-1", "dmp-discrete-3-trial-2"];

const INSTRUCTIONS = `In every trial a cross appears first: please look at it. Then two figures move side by side. One is the walker of this project, a \
computer program that walks by published curves of people's gait: it stands for the natural movement here, because the project comes without \
recordings. The other was made by a model that learned from that walker.

When they have ended, say on which side you saw the more natural movement: press the left or the right arrow key, or tap on that side. There is no \
time limit, but answer with your first impression. If you cannot tell, guess.`;

export async function study() {
  await run("cargo", "build", "--release", "--package", "vcgpdm-cli");
  for (const path of [results, shown]) mkdirSync(dirname(path), { recursive: true });
  for (const options of SWEEPS)
    await run(
      program,
      "evaluate",
      ...trials,
      "--parts",
      "lower,upper",
      "--folds",
      "1,2",
      ...options,
      "--out",
      results,
    );
  const title = "Walks made by this project: which is more natural?";
  const made = ["--unseen", ...unseen, "--title", title, "--failed", FAILED.join(","), "--out", shown];
  await run(program, "study", results, ...trials, ...made);
  const study = JSON.parse(readFileSync(shown, "utf8"));
  study.texts.instructions = INSTRUCTIONS;
  const draft = at("target/study/walks.study.json");
  writeFileSync(draft, JSON.stringify(study));
  // Read and written by the program: whatever is wrong with the text is found here.
  await run(program, "study", draft, "--out", shown);
  const bytes = readFileSync(shown).length;
  if (bytes > LARGEST) throw new Failure(`the study has ${bytes} bytes, more than ${LARGEST}`);
  const paper = output(program, "perception", "--paper");
  if (paper === null) throw new Failure("the check against the paper could not be made");
  putTables(at("docs/perception.md"), paper);
}
