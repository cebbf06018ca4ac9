// `vcgpdm/figure` of the npm package: a model's body walks on a canvas of any page.
import type { Motion } from "../engine/protocol";
import { type Companion, type FigureMotion, FollowedFigure } from "../scene/followed-figure";
import { eachFrame } from "../ui/browser";
import { Playback } from "./playback";

/** Coupling variances `alpha[source][target]`. */
export type Alpha = readonly (readonly number[])[];

/** The arguments of a rollout. */
export interface FigureRolloutOptions {
  frames: number;
  sequence: number;
  alpha?: number[][];
}

/** What the figure uses of a `Rollout` of this package. */
export interface FigureRollout {
  readonly frames: number;
  positions(): Float32Array;
  free(): void;
}

/** What the figure uses of a `Model` of this package, from any of its entries. */
export interface FigureModel {
  info(): {
    kind: string;
    frameTime: number;
    parts: { name: string; joints: number[] }[];
    joints: { name: string }[] | null;
    figure: { nodes: { joint: number; parent: number | null; endSite: boolean }[] } | null;
    alpha: number[][] | null;
  };
  rollout(options: FigureRolloutOptions): FigureRollout;
  sampledRollouts(options: FigureRolloutOptions, count: number, seed: number): FigureRollout[];
}

export interface FigureOptions {
  /** Seconds of the rollout, which repeats without a jump; absent: 10. */
  seconds?: number;
  /** The training sequence whose start begins the rollout, counted from 0; absent: the first. */
  sequence?: number;
  /** Absent: as learned. */
  alpha?: Alpha | null;
  /** How many sampled rollouts are drawn faintly with the mean rollout; absent: 0. */
  samples?: number;
  /** Whether the picture is dark; absent or null: as the visitor's system asks. */
  dark?: boolean | null;
}

const OPTIONS = ["seconds", "sequence", "alpha", "samples", "dark"];
const SECONDS = 10;

/** An error like those of the package. */
const problem = (code: "argument" | "model", message: string) =>
  Object.assign(new Error(message), { name: "VcgpdmError", code });

/** The body of a model on a canvas. It stands until `play`. A drag turns the camera. */
export class Figure {
  readonly #kind: string;
  readonly #learned: Alpha | null;
  readonly #frameTime: number;
  readonly #body: Omit<FigureMotion, "motion">;
  readonly #options: { frames: number; sequence: number; samples: number };
  readonly #playback = new Playback();
  readonly #picture: FollowedFigure;
  readonly #sight: IntersectionObserver;
  readonly #stop: () => void;
  #alpha: Alpha | null = null;
  #shown: FigureMotion | null = null;
  #companions: Companion[] = [];
  #isSeen = true;

  /**
   * The canvas keeps the size of its style. The model must not be freed before `dispose`. Throws for a model
   * without a body, for options that the model refuses, and where the browser has no WebGL.
   */
  constructor(
    canvas: HTMLCanvasElement,
    private readonly model: FigureModel,
    options: FigureOptions = {},
  ) {
    const unknown = Object.keys(options).find((name) => !OPTIONS.includes(name));
    if (unknown) throw problem("argument", `expected options of ${OPTIONS.join(", ")}, found ${unknown}`);
    const { seconds = SECONDS, sequence = 0, alpha = null, samples = 0, dark = null } = options;
    if (!(seconds > 0)) throw problem("argument", `seconds: expected a number above 0, found ${seconds}`);
    const { kind, frameTime, parts, joints, figure, alpha: learned } = model.info();
    if (!figure || !joints)
      throw problem("model", `expected a model of a body, found a ${kind} of tables, which has no figure`);
    this.#kind = kind;
    this.#learned = learned;
    this.#frameTime = frameTime;
    this.#body = { figure, joints: joints.map(({ name }) => name), parts };
    this.#options = { frames: 1 + Math.max(1, Math.round(seconds / frameTime)), sequence, samples };
    // Before the canvas is used: a refused option leaves nothing behind.
    this.#rollOut(alpha);
    this.#picture = new FollowedFigure(canvas, this.#playback, () => this.#show(), dark);
    this.#picture.scrollsWithPage();
    this.#show();
    this.#sight = new IntersectionObserver((entries) => {
      this.#isSeen = entries.at(-1)?.isIntersecting ?? true;
    });
    this.#sight.observe(canvas);
    this.#stop = eachFrame((seconds) => this.#draw(seconds));
  }

  /** Coupling variances of the motion; null for a kind of model without couplings. */
  get alpha(): Alpha | null {
    return this.#alpha;
  }

  /**
   * Changes the couplings; null: as learned. The motion continues at the same place and time. If the model
   * refuses the couplings, nothing changes.
   */
  set alpha(alpha: Alpha | null) {
    this.#rollOut(alpha);
    this.#show();
  }

  /** Whether the figure moves. */
  get playing(): boolean {
    return this.#playback.playing;
  }

  play(): void {
    this.#playback.play();
  }

  pause(): void {
    if (this.playing) this.#playback.togglePlay();
  }

  /** Seconds since the start of the rollout. */
  get time(): number {
    return this.#playback.seconds;
  }

  set time(seconds: number) {
    this.#playback.seekSeconds(seconds);
    this.#picture.viewport.changed();
  }

  /** Whether the picture is dark; null: as the visitor's system asks. */
  get dark(): boolean | null {
    return this.#picture.viewport.dark;
  }

  set dark(dark: boolean | null) {
    this.#picture.viewport.dark = dark;
  }

  /** Ends the figure and frees its graphics memory. The model stays. */
  dispose(): void {
    this.#stop();
    this.#sight.disconnect();
    this.#picture.dispose();
  }

  /** Rolls the model out under these couplings, and goes on in the new motion. */
  #rollOut(alpha: Alpha | null): void {
    if (alpha && !this.#learned)
      throw problem("model", `expected a model with couplings, a vcgpdm or vgpdm, found ${this.#kind}`);
    const next = alpha ?? this.#learned;
    const { frames, sequence, samples } = this.#options;
    const request = { frames, sequence, ...(next && { alpha: next as number[][] }) };
    const motion = this.#motionOf(this.model.rollout(request));
    const futures = samples > 0 ? this.model.sampledRollouts(request, samples, 0) : [];
    this.#companions = futures.map((rollout, index) => ({
      style: { kind: "future", index },
      motion: this.#motionOf(rollout),
    }));
    // Frozen, because a change of one number would not reach the motion.
    this.#alpha = next && Object.freeze(next.map((row) => Object.freeze([...row])));
    this.#shown = { ...this.#body, motion };
    this.#playback.load(motion, { whole: false, goesOn: true });
  }

  #motionOf(rollout: FigureRollout): Motion {
    const { frames } = rollout;
    const positions = rollout.positions();
    rollout.free();
    return { positions, frames, nodes: this.#body.figure.nodes.length, frameTime: this.#frameTime };
  }

  #show(): void {
    if (!this.#shown) return;
    this.#picture.show(this.#shown);
    this.#picture.accompany(this.#companions);
  }

  /** Moves the clock on and draws. Out of sight, the figure rests. */
  #draw(seconds: number): void {
    if (!this.#isSeen) return;
    this.#playback.advance(seconds);
    if (this.playing) this.#picture.viewport.changed();
    this.#picture.draw(seconds);
  }
}
