// The contents of files about the motion on the stage. Loaded at the first use.
import type { Figure, JointInfo, ModelView, Motion, Reading, RolloutResult } from "../engine/protocol";
import { csv } from "../figures/csv";

/** A row for each frame: frame, time in seconds, the latents of all parts, and the weights of all experts. */
export function rolloutCsv({ info }: ModelView, { latents, weights, motion }: RolloutResult): string {
  const { parts, frameTime } = info;
  const widths = parts.map(({ latent }) => latent);
  const names = parts.map(({ name }) => name);
  const pairs = names.flatMap((_, source) => names.map((_, target) => [source, target] as const));
  const header = [
    "frame",
    "time",
    ...names.flatMap((name, part) => Array.from({ length: widths[part] ?? 0 }, (_, q) => `${name}_${q}`)),
    ...pairs.map(([source, target]) => `weight_${names[source]}_${names[target]}`),
  ];
  const shares = pairs.map(([source, target]) => weights[source]?.[target] ?? null);
  const rows = Array.from({ length: motion.frames }, (_, frame) => [
    frame,
    frame * frameTime,
    ...names.flatMap((_, part) => {
      const width = widths[part] ?? 0;
      return [...(latents[part] ?? []).slice(frame * width, (frame + 1) * width)];
    }),
    ...shares,
  ]);
  return csv({ header, rows });
}

/**
 * A row for each frame: frame, time in seconds, and the positions of all joints and ends of limbs, in metres
 * for a body 1.7 m tall, y up.
 */
export function positionsCsv(
  { figure, joints }: { figure: Figure; joints: readonly Pick<JointInfo, "name">[] },
  { positions, frames, nodes, frameTime }: Motion,
): string {
  const names = figure.nodes.map(
    ({ joint, endSite }) => `${joints[joint]?.name ?? joint}${endSite ? "_end" : ""}`,
  );
  const header = [
    "frame",
    "time",
    ...names.flatMap((name) => ["x", "y", "z"].map((axis) => `${name}_${axis}`)),
  ];
  const width = 3 * nodes;
  const rows = Array.from({ length: frames }, (_, frame) => [
    frame,
    frame * frameTime,
    ...positions.subarray(frame * width, (frame + 1) * width),
  ]);
  return csv({ header, rows });
}

/** The file of a motion, and of a motion that begins as another clip the title of that clip. */
interface About {
  version: string;
  file: string;
  clip?: string;
}

const accountOf = ({ version, file }: About, made: object) =>
  `${JSON.stringify({ format: "vcgpdm motion account", version: 1, motion: file, program: `vCGPDM playground ${version}`, ...made }, null, 1)}\n`;

/** The frames of a clip that are kept, counted from 1; of one that was made here, also who made it and how. */
export const clipAccount = (
  { title, first, end }: { title: string; first: number; end: number },
  made: string,
  about: About,
): string =>
  accountOf(about, { clip: { title, first_frame: first + 1, last_frame: end }, ...(made ? { made } : {}) });

/** How the motion on the stage was made, as JSON. With the model's file anyone can make the motion again. */
export function motionAccount({ info, sha256 }: ModelView, { request }: RolloutResult, about: About): string {
  const { provenance, sequences, parts, frameTime } = info;
  const changed = request.alpha !== null;
  const reading: Reading = changed ? request.reading : "as-learned";
  return accountOf(about, {
    model: {
      sha256,
      trained_by: provenance.engine,
      seed: provenance.settings.seed,
      clips: sequences.map(({ name, sha256 }) => ({ name, sha256 })),
    },
    parts: parts.map(({ name }) => name),
    /** alpha[source][target] */
    alpha: request.alpha ?? info.alpha,
    alpha_learned: info.alpha,
    reading,
    start: about.clip
      ? { clip: about.clip }
      : {
          sequence: request.sequence,
          name: sequences[request.sequence]?.name ?? null,
          frame: request.frame ?? 0,
        },
    /** The seed of a sampled motion. */
    ...(request.sample ? { sample: request.sample } : {}),
    frames: request.frames,
    frame_time: frameTime,
  });
}
