// For tests: a library of the legs and arms of a made walk and of a made wave, learned in two iterations.
import { HeldWorkers } from "../engine/held.fake";
import type { LearningJob } from "../engine/library-protocol";
import type { TrainingClip } from "../engine/protocol";

/** A second of a made clip; `id`: another number for each. */
const madeClip = (id: number, sample: string): TrainingClip => ({
  ...{ id, source: { sample }, first: 0, end: 60 },
});

const workers = new HeldWorkers();
/** The description of a clip that the project makes: its joints and parts, among others. */
export const { info: madeInfo } = await workers.started().clips.readClip({ sample: "walk-1" });
const { parts } = madeInfo.presets.find(({ id }) => id === "lower-upper")!;

const JOB: LearningJob = {
  clips: [madeClip(1, "walk-1"), madeClip(2, "walk-wave-1")],
  movements: ["walk", "wave"].map((name) => ({ name, sequences: 1 })),
  shared: [false, false],
  settings: {
    ...{ parts, latent: 2, dynamicsIps: 4, poseIps: 4, order: 2, framesPerSecond: 30, seed: 0 },
    maxIterations: 2,
  },
};

let learned = "";
const report = ({ found }: { found: string | null }) => {
  learned = found ?? learned;
};
await workers.pool.run((worker) => worker.learnLibrary(JOB, report, new AbortController().signal));
/** Its last primitive alone, the wave of the arms. */
const arms = await workers.library.run(async (worker) => {
  await worker.openLibrary(learned);
  return worker.primitivesText([3]);
});

interface Document {
  primitives: { name: string; experts: { u_mean: number[][] }[] }[];
  parts: { beta: number }[];
  provenance: { settings: { seed: number } };
}

/** The library, for each seed another document. */
export function libraryText(seed: number): string {
  const document = JSON.parse(learned) as Document;
  document.provenance.settings.seed = seed;
  return JSON.stringify(document);
}

/** A file with only a primitive of the arms; `noise`: of their pose maps, in units of those of the library. */
export function armsText(name: string, noise = 1): string {
  const document = JSON.parse(arms) as Document;
  const [wave] = document.primitives;
  wave!.name = name;
  wave!.experts[0]!.u_mean[0]![0]! += 0.1;
  document.parts[1]!.beta *= noise;
  return JSON.stringify(document);
}
