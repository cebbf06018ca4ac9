// How far a motion is from a walk, and whether it still is one.
import type { Health, Measures, Motion } from "../../engine/protocol";
import { distances } from "../../scene/motion";

/** A walk swings its feet at least by this share of the whole model's, and at most by its inverse. */
const SWING = 0.6;
/** Its period differs by less than this share. */
const PERIOD = 0.15;
/** Its poses are on average nearer to those of the whole model, in metres. */
const ERROR = 0.08;

/** The frame of a motion as a motion of its own. */
function still({ positions, nodes, frameTime }: Motion, frame: number): Motion {
  return {
    positions: positions.subarray(3 * nodes * frame, 3 * nodes * (frame + 1)),
    frames: 1,
    nodes,
    frameTime,
  };
}

/**
 * The mean distance of the joints from the nearest pose of the lap `first` to `first + frames` of a walk, in the
 * second half of a motion, in metres. Place and heading do not count.
 */
export function walkError(motion: Motion, walk: Motion, lap: { first: number; frames: number }): number {
  const poses = Array.from({ length: lap.frames }, (_, t) => still(walk, lap.first + t));
  const first = Math.floor(motion.frames / 2);
  let sum = 0;
  for (let t = first; t < motion.frames; t++) {
    const pose = still(motion, t);
    sum += Math.min(...poses.map((other) => distances(pose, other)[0]!));
  }
  return sum / (motion.frames - first);
}

/** Whether a motion is no walk any more: it stops, swings otherwise, keeps another pace, or has other poses. */
export function stumbles(
  found: { health: Health; measures: Measures; error: number },
  walk: Measures,
  part: number,
): boolean {
  const [now, then] = [found.measures.parts[part]!, walk.parts[part]!];
  if (found.health.state !== "moves-on" || now.period === null || now.swing === null) return true;
  const swing = now.swing / (then.swing ?? now.swing);
  const period = now.period / (then.period ?? now.period);
  return swing < SWING || swing > 1 / SWING || Math.abs(period - 1) > PERIOD || !(found.error <= ERROR);
}
