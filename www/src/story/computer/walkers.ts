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

/** How far the lights of the two are apart at the same time, on average over lights and frames, metres. */
export function meanDistance({ program, model }: WalkerPair): number {
  const [a, b] = [program.motion.positions, model.motion.positions];
  let sum = 0;
  for (let i = 0; i < a.length; i += 3)
    sum += Math.hypot(a[i]! - b[i]!, a[i + 1]! - b[i + 1]!, a[i + 2]! - b[i + 2]!);
  return sum / (a.length / 3);
}
