// `npm run lab -- motions FOLDER`: the movements with which the view Compare models begins. The best of each of four
// kinds of models in the page's results predicts the first trial again, from the clips of this folder, and must be as
// wrong as recorded. The page gets the seconds after the start, beside the recording.
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { encodeFirstMotion } from "../../www/src/stage/first-motion.js";
import { builtPackage } from "../package.mjs";
import { at, Failure } from "../run.mjs";

const KINDS = ["vcgpdm", "vgpdm", "tmp", "dmp-rhythmic"];
const HELD_OUT = 0;
const SECONDS = 3;
/** Every second frame: the page draws what lies between. */
const EVERY = 2;

export async function motions(folder = "") {
  const { Clip, Evaluation, Fold, Results, TrainingSet } = builtPackage();
  const results = Results.fromJson(readFileSync(at("www/public/comparison/walks.results.json"), "utf8"));
  const setting = results.setting();
  const names = readdirSync(resolve(folder)).filter((name) => name.endsWith(".bvh"));
  const set = new TrainingSet();
  const clips = setting.trials.map(({ name }) => {
    if (!names.includes(name)) throw new Failure(`expected ${name} in ${folder}, found ${names.join(", ")}`);
    const clip = Clip.read(name, readFileSync(join(folder, name)));
    set.add(clip);
    return clip;
  });
  const { parts, framesPerSecond } = setting;
  const trainingTrials = clips.length - 1;
  const fold = new Fold(set, { parts, framesPerSecond }, { heldOut: HELD_OUT, trainingTrials });
  const { figure, joints } = /** @type {NonNullable<typeof clips[0]>} */ (clips[0]).info();
  const nodes = figure.nodes.length;
  const frames = Math.floor((SECONDS * framesPerSecond) / EVERY);
  const short = (/** @type {Float32Array} */ all) =>
    Array.from({ length: frames }, (_, frame) => [
      ...all.subarray(frame * EVERY * nodes * 3, (frame * EVERY + 1) * nodes * 3),
    ]).flat();
  const positions = short(fold.actual());
  const shown = KINDS.map((kind) => {
    const [best] = results
      .comparison()
      .models.filter(({ model }) => model === kind)
      .sort((a, b) => a.mse.mean - b.mse.mean);
    const asked = JSON.stringify(best?.candidate);
    const recorded = results
      .finished()
      .find(
        ({ job }) =>
          JSON.stringify(job.candidate) === asked &&
          job.heldOut === HELD_OUT &&
          job.trainingTrials === trainingTrials,
      );
    if (!recorded) throw new Failure(`expected a result of ${kind} for trial ${HELD_OUT + 1}`);
    const training = new Evaluation(fold, recorded.job.candidate, recorded.job.seed);
    while (!training.step().done);
    const prediction = training.prediction();
    const [found, before] = [prediction.outcome(0).score.dtwMse, recorded.outcome?.score.dtwMse];
    console.log(`${kind}: error ${found}, recorded ${before}`);
    if (!(Math.abs(found / (before ?? NaN) - 1) < 0.05))
      throw new Failure("this is not the recorded movement");
    positions.push(...short(prediction.positions()));
    return recorded.id;
  });
  const motion = {
    frames: frames * (1 + shown.length),
    frameTime: EVERY / framesPerSecond,
    figure,
    joints: joints.map(({ name }) => name),
    parts,
    positions: Float32Array.from(positions),
    shown,
  };
  writeFileSync(at("www/public/comparison/walks.motions.bin"), encodeFirstMotion(motion));
}
