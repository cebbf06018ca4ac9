// The walkers of the first chapter: lights of a program's walk, and of a model's prediction of it.
import type { Motion } from "../../engine/protocol";
import type { Body } from "../../scene/columns";
import { decodeFirstMotion } from "../../stage/first-motion.js";

export interface Walker {
  /** On the spot, along z. */
  motion: Motion;
  /** Metres a second. */
  speed: number;
}

/** Two walkers to compare. */
export interface WalkerPair {
  program: Walker;
  model: Walker;
}

export interface Walkers {
  body: Body;
  pairs: WalkerPair[];
}

/** The walkers of the page's file. */
export async function fetchWalkers(): Promise<Walkers> {
  const answer = await fetch(new URL("first/walkers.bin", document.baseURI));
  if (!answer.ok) throw new Error(`the host answered ${answer.status} for the walkers`);
  return readWalkers(await answer.arrayBuffer());
}

export function readWalkers(bytes: ArrayBuffer): Walkers {
  const { figure, joints, parts, positions, frameTime, ranges = [] } = decodeFirstMotion(bytes);
  const nodes = figure.nodes.length;
  let first = 0;
  const walkers = ranges.map(({ frames, speed }) => {
    const end = first + frames * nodes * 3;
    const motion = { positions: positions.slice(first, end), frames, nodes, frameTime };
    first = end;
    return { motion, speed };
  });
  const pairs = walkers.flatMap((program, i) => {
    const model = walkers[i + 1];
    return i % 2 === 0 && model ? [{ program, model }] : [];
  });
  return { body: { figure, joints, parts, lights: figure.nodes.map((_, node) => node) }, pairs };
}

/**
 * How far the lights of the two are apart, on average over lights and frames, metres. Each pose of the model is
 * compared with the pose of the program that is most like it: two tempos are no difference of poses.
 */
export function meanDistance({ program, model }: WalkerPair): number {
  const { positions: a, nodes } = program.motion;
  const { positions: b } = model.motion;
  const size = 3 * nodes;
  let sum = 0;
  for (let pose = 0; pose < b.length; pose += size) {
    let nearest = Number.POSITIVE_INFINITY;
    for (let other = 0; other < a.length; other += size) {
      let apart = 0;
      for (let i = 0; i < size && apart < nearest; i += 3)
        apart += Math.hypot(
          a[other + i]! - b[pose + i]!,
          a[other + i + 1]! - b[pose + i + 1]!,
          a[other + i + 2]! - b[pose + i + 2]!,
        );
      nearest = Math.min(nearest, apart);
    }
    sum += nearest;
  }
  return sum / (b.length / 3);
}
