// Two fingers or two keys as the feet: each press is a step of a foot, and the phase of the legs goes on to where that
// foot lands. No DOM.
import type { LiveBody } from "../engine/protocol";
import type { LiveTrack } from "../scene/live-track";
import { feetOf, floorOf } from "../scene/stance";
import type { TracePoint } from "./live-store";

/** 0: the left foot; 1: the right one. */
export type Foot = 0 | 1;

/** The legs of a live motion: their part, the phase at which each foot lands, and turns a second by themselves. */
export interface Gait {
  part: number;
  lands: readonly [number, number];
  pace: number;
}

/** The model walks at most this much faster than it learned. */
const FASTEST = 2;
/** A step takes at most these seconds. */
const SLOWEST = 1.5;
/** A landing that is nearer than this, in turns, has just been. */
const BEEN = 0.15;
/** Seconds in which the pace of the legs follows the presses. */
const SMOOTH = 0.06;

const turned = (turns: number) => ((turns % 1) + 1) % 1;

/** The part that carries the root and both feet, and the nodes of their tips; null: no part does. */
export function legsOf({ figure, parts }: LiveBody, { motion }: LiveTrack) {
  const part = parts.findIndex(({ joints }) => joints.includes(0));
  const ends = feetOf(motion, floorOf(motion)).filter((node) =>
    figure.nodes.every(({ parent }) => parent !== node),
  );
  const isOfLegs = (node: number) => parts[part]?.joints.includes(figure.nodes[node]?.joint ?? -1);
  return ends.length >= 2 && ends.every(isOfLegs) ? { part, ends } : null;
}

/**
 * The gait in the stored frames of a live motion. A foot lands where it is farthest in front of the root, in the
 * direction of the toes. Null: there is no whole cycle yet, or no part has both legs.
 */
export function gaitOf(body: LiveBody, track: LiveTrack, trace: readonly TracePoint[]): Gait | null {
  const legs = legsOf(body, track);
  if (!legs) return null;
  const { part, ends } = legs;
  const { figure } = body;
  const { motion } = track;
  const width = 3 * motion.nodes;
  const seen = trace.filter(({ frame, phases }) => frame >= track.first && phases.length > 0);
  const first = seen[0]?.phases[part];
  if (first === undefined) return null;
  // Turns since the first frame.
  let turns = 0;
  const steps = seen.map(({ frame, phases }, k) => {
    const by = turned((phases[part] ?? 0) - (seen[k - 1]?.phases[part] ?? first) + 0.5) - 0.5;
    turns += by;
    const pose = motion.positions.subarray((frame - track.first) * width, (frame - track.first + 1) * width);
    const from = (node: number, to: number) => [
      pose[3 * to]! - pose[3 * node]!,
      pose[3 * to + 2]! - pose[3 * node + 2]!,
    ];
    const toes = ends.map((node) => from(figure.nodes[node]?.parent ?? node, node));
    const [x, z] = [0, 1].map((axis) => toes.reduce((sum, toe) => sum + toe[axis]!, 0)) as [number, number];
    const ahead = ends.map((node) => {
      const [dx, dz] = from(0, node) as [number, number];
      return { front: dx * x + dz * z, left: dx * z - dz * x };
    });
    return { phase: phases[part] ?? 0, ahead };
  });
  if (turns < 1) return null;
  const sides = ends.map((_, k) => steps.reduce((sum, { ahead }) => sum + ahead[k]!.left, 0));
  const [left, right] = [sides.indexOf(Math.max(...sides)), sides.indexOf(Math.min(...sides))];
  const lands = [left, right].map(
    (k) => steps.reduce((best, step) => (step.ahead[k]!.front > best.ahead[k]!.front ? step : best)).phase,
  ) as [number, number];
  return { part, lands, pace: turns / (seen.length * motion.frameTime) };
}

/** What presses ask for: a step that the model knows, a second step of the same foot, or steps that are too fast. */
export type Asked = "step" | "same" | "fast";

/** The phase of the legs under the presses. Times are in seconds, phases in turns. */
export class Feet {
  #phase: number;
  /** The phase of the landing that the last press asked for. */
  #target: number;
  /** Turns a second, wanted and now. */
  #wanted = 0;
  #now = 0;
  #last: { foot: Foot; time: number } | null = null;
  /** How long the step after a press of each foot took last time. */
  readonly #took: (number | null)[] = [null, null];

  constructor(
    private readonly gait: Gait,
    phase: number,
  ) {
    this.#phase = phase;
    this.#target = phase;
  }

  /** The legs go on to where the foot lands, in the time that this step took before. */
  press(foot: Foot, time: number): Asked {
    const { lands, pace } = this.gait;
    const last = this.#last;
    this.#last = { foot, time };
    const between = last ? time - last.time : null;
    if (last) this.#took[last.foot] = between;
    let way = turned(lands[foot] - this.#target);
    if (way < BEEN) way += 1;
    // Steps that wait for more than a turn are dropped.
    if (this.#target - this.#phase < 1) this.#target += way;
    const seconds = Math.min(SLOWEST, this.#took[foot] ?? between ?? 0.5 / pace);
    const asked = (this.#target - this.#phase) / Math.max(seconds, 1e-3);
    this.#wanted = Math.min(asked, FASTEST * pace);
    if (last?.foot === foot) return "same";
    return between !== null && 0.5 / between > FASTEST * pace ? "fast" : "step";
  }

  /** The turns of the next seconds. */
  advance(seconds: number): number {
    const left = this.#target - this.#phase;
    this.#now += (this.#wanted - this.#now) * Math.min(1, seconds / SMOOTH);
    const turns = Math.min(left, this.#now * seconds);
    if (turns >= left) [this.#wanted, this.#now] = [0, 0];
    this.#phase += turns;
    return turns;
  }
}
