// The last seconds of a motion without an end, with its latents.
import type { Motion } from "../engine/protocol";
import { HERE, type Placement, placeOnto, poseAt, turnedBack } from "./motion";

export class LiveTrack {
  /** The number of the first stored frame, counted from the start. */
  first = 0;
  readonly #motion: Motion;
  readonly #pose: Float32Array;
  /** The latent path of each part, then the columns, and their dimensions. */
  readonly #latents: readonly { values: Float64Array; width: number }[];
  /** The latent path of each part: row k is frame `first` + k. Rows after the newest frame are scratch. */
  readonly paths: readonly Float64Array[];
  /** The frame of the recording that moves a part, in each stored frame; null without one. */
  #recorded: (number | null)[] = [];
  #placement: Placement = HERE;

  /**
   * Keeps the last `kept` frames, and a little more; `widths`: the latent dimensions of each part, then the number of
   * columns.
   */
  constructor(
    { nodes, frameTime }: Pick<Motion, "nodes" | "frameTime">,
    private readonly kept: number,
    widths: readonly number[] = [],
  ) {
    this.#motion = { positions: new Float32Array(2 * kept * nodes * 3), frames: 0, nodes, frameTime };
    this.#pose = new Float32Array(nodes * 3);
    this.#latents = widths.map((width) => ({ values: new Float64Array(2 * kept * width), width }));
    this.paths = this.#latents.map(({ values }) => values);
  }

  /** The stored frames. The object stays the same while frames arrive. */
  get motion(): Motion {
    return this.#motion;
  }

  /** The number of the newest frame; `first` - 1 without frames. */
  get last(): number {
    return this.first + this.#motion.frames - 1;
  }

  /** The latent path of a part in the stored frames [frames x Q]. */
  latents(part: number): Float64Array | null {
    const path = this.#latents[part];
    return path ? path.values.subarray(0, this.#motion.frames * path.width) : null;
  }

  /** The last path from one frame to another, both included: the columns of the motion; null: not all are stored. */
  columns(from: number, to: number): Float64Array | null {
    const path = this.#latents.at(-1);
    if (!path || from < this.first || to > this.last) return null;
    return path.values.slice((from - this.first) * path.width, (to - this.first + 1) * path.width);
  }

  /** A frame as it arrived [nodes x 3]; null if it is not stored. */
  frame(number: number): Float32Array | null {
    if (number < this.first || number > this.last) return null;
    const width = this.#motion.nodes * 3;
    return this.#motion.positions.subarray((number - this.first) * width, (number - this.first + 1) * width);
  }

  /** Drops the frames after this one. */
  cutAfter(number: number): void {
    const dropped = Math.max(0, this.last - Math.max(number, this.first - 1));
    this.#motion.frames -= dropped;
    this.#recorded.length = this.#motion.frames;
  }

  /** The frame of the recording at a frame, which need not be whole; null without a recording. */
  recordedAt(frame: number): number | null {
    const from = this.#recorded[Math.floor(frame) - this.first] ?? null;
    return from === null ? null : from + (frame % 1);
  }

  /** `recorded`: the frame of the recording that moves a part, in each of the frames. */
  append(
    { positions, frames, nodes }: Motion,
    latents: readonly Float64Array[] = [],
    recorded: readonly (number | null)[] = Array(frames).fill(null),
  ): void {
    const motion = this.#motion;
    if (motion.frames + frames > 2 * this.kept) this.#forget(motion.frames - this.kept);
    motion.positions.set(positions, motion.frames * nodes * 3);
    this.#latents.forEach(({ values, width }, part) =>
      values.set(latents[part] ?? [], motion.frames * width),
    );
    this.#recorded.push(...recorded);
    motion.frames += frames;
  }

  /** Places the motion so that its oldest frame lies on a pose of the same figure. */
  alignWith(pose: Float32Array): void {
    this.#placement = placeOnto(poseAt(this.#motion, 0, HERE, this.#pose), pose);
  }

  /** The pose at a frame, counted from the start, which need not be whole. */
  at(frame: number): Float32Array {
    return poseAt(this.#motion, frame - this.first, this.#placement, this.#pose);
  }

  /** A displacement on the stage in the axes of the motion before its placement. */
  turnedBack(by: readonly [number, number, number]): [number, number, number] {
    return turnedBack(this.#placement, by);
  }

  #forget(frames: number): void {
    const motion = this.#motion;
    motion.positions.copyWithin(0, frames * motion.nodes * 3, motion.frames * motion.nodes * 3);
    for (const { values, width } of this.#latents)
      values.copyWithin(0, frames * width, motion.frames * width);
    this.#recorded.splice(0, frames);
    motion.frames -= frames;
    this.first += frames;
  }
}
