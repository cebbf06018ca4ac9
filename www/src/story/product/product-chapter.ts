// Two guesses, one step: the experts of the arms and of the legs about the arms, and their product.
import { html, nothing } from "lit";
import { Latest } from "../../engine/latest";
import type { Couplings, RolloutRequest, RolloutResult, PredictionsReport } from "../../engine/protocol";
import { ellipseOf, type Plane } from "../../latents/plane";
import type { Projection } from "../../latents/projection";
import { drawEllipse, fillDot } from "../../latents/shapes";
import { largestDistance } from "../../scene/motion";
import { ALPHA_MAX, ALPHA_MIN } from "../../settings/settings";
import { partColour, partColourNow, theme } from "../../ui/palette";
import { partStyle } from "../../ui/styled";
import type { WordsStore } from "../../words/words";
import type { StoryBody } from "../../app/story-body";
import type { Chapter } from "../chapter";
import { attempt, LatentChapter } from "../latent/latent-chapter";
import { strokeLoop } from "../latent/drawing";
import type { Handle } from "../latent/latent-view";
import "../latent/latent-view";
import { weights } from "../../couplings/weights";
import type { App } from "../../app/app";
import "../../stage/stage-view";

interface Product {
  /** w of each source. */
  weights: number[];
  /** [Q] */
  mean: Float64Array;
  /** alpha^i: the variance of the product of two Gaussians with the variances alpha. */
  variance: number;
}

/** The means of the experts about a part in row `row` of a report, one for each source [Q]. */
export function meansOf(
  report: PredictionsReport,
  part: number,
  row: number,
  dimensions: number,
): Float64Array[] {
  const { experts } = report.parts[part]!;
  return experts.map(({ means }) => means.slice(row * dimensions, (row + 1) * dimensions));
}

/** The product of the guesses `means` with the variances `alphas`. */
export function productOf(means: readonly Float64Array[], alphas: readonly number[]): Product {
  const shares = weights(alphas);
  const mean = means[0]!.map((_, a) =>
    means.reduce((sum, guess, source) => sum + shares[source]! * guess[a]!, 0),
  );
  return { weights: shares, mean, variance: shares[0]! * alphas[0]! };
}

const LEGS = 0;
const ARMS = 1;
/** The plot shows this many times the width of the loop. */
const AROUND = 1.5;
const FRAMES = 300;
/** The factor of alpha for an arrow key. */
const STEP = 1.25;
/** Pixels from a circle to the dot that pulls it, so that the dot follows the pointer for the smallest circle too. */
const OUTSIDE = 12;
/** The direction of each handle from the middle of its circle, in pixels of length 1. */
const DIRECTIONS = [
  [-Math.SQRT1_2, -Math.SQRT1_2],
  [Math.SQRT1_2, Math.SQRT1_2],
] as const;

/** The difference between two rollouts, and between their circles. */
export interface Doubled {
  /** The largest distance between the same joint of both bodies, in millimetres. */
  apart: number;
  /** The deviation of the product under doubled couplings, as a multiple of the one before. */
  wider: number;
}

export class ProductChapter extends LatentChapter<"product"> {
  /** The guesses of the experts: the mean of each source [Q]. */
  #means: Float64Array[] | null = null;
  /** The state before the step [Q]. */
  #before: Float64Array = new Float64Array(0);
  #learned: number[] = [];
  #alphas: number[] = [];
  #doubled: Doubled | null = null;
  readonly #rollouts: Latest<number[], RolloutResult>;

  constructor(words: WordsStore, body: StoryBody) {
    super(words, "product", body);
    this.#rollouts = new Latest(
      (alphas) => this.#roll(alphas),
      (rollout) => this.isHere && this.pose.play(rollout.motion),
      (problem) => attempt(body, Promise.reject(problem)),
    );
    this.awaitLoop(ARMS, AROUND);
  }

  get projection(): Projection | null {
    return this.#means && (this.loop?.projection ?? null);
  }

  get moves(): boolean {
    return false;
  }

  /** The product under the couplings now; null before the model. */
  get product(): Product | null {
    return this.#means && productOf(this.#means, this.#alphas);
  }

  get handles(): readonly Handle[] {
    if (!this.#means) return [];
    return [LEGS, ARMS].map((source) => ({
      id: `alpha-${source}`,
      label: this.words.radius[source === LEGS ? "legs" : "arms"](this.#alphas[source]!.toPrecision(2)),
      place: (plane) => this.#edge(plane, source),
      drag: (plane, x, y) => this.#pull(plane, source, x, y),
      nudge: (right, down) => this.#set(source, this.#alphas[source]! * STEP ** (right - down)),
    }));
  }

  #request(alphas: readonly number[] | null): RolloutRequest {
    const learned = this.body.model.couplings.learned;
    const alpha: Couplings | null =
      alphas &&
      learned.map((row, source) => row.map((value, target) => (target === ARMS ? alphas[source]! : value)));
    return { frames: FRAMES, sequence: 0, alpha, reading: "as-learned" };
  }

  #roll(alphas: readonly number[] | null): Promise<RolloutResult> {
    const { engine } = this.body.engine;
    if (!engine) throw new Error("There is no model yet.");
    return engine.rollout(this.#request(alphas));
  }

  /** The experts in the frame of the lap where they disagree most. */
  protected async begin(): Promise<void> {
    const { engine } = this.body.engine;
    const { learned, couplings } = this.body.model;
    if (!engine || !learned || !this.loop) return;
    const report = await engine.predictions(this.#request(null));
    const { lap, projection } = this.loop;
    const q = projection.dimensions;
    this.#learned = couplings.learned.map((row) => row[ARMS]!);
    this.#alphas = [...this.#learned];
    const first = lap.first - report.firstFrame;
    const rows = Array.from({ length: lap.frames }, (_, t) => first + t);
    const all = rows.map((row) => meansOf(report, ARMS, row, q));
    const apart = all.map((means) => this.#apart(means, projection));
    const best = apart.indexOf(Math.max(...apart));
    this.#means = all[best]!;
    const path = learned.latents[ARMS]!;
    const frame = lap.first + best - 1;
    this.#before = path.slice(frame * q, (frame + 1) * q);
    this.changed();
  }

  /** The distance between both means in the plane of the plot. */
  #apart(means: readonly Float64Array[], { axes, dimensions: q }: Projection): number {
    const along = (axis: number) =>
      means[0]!.reduce((sum, value, a) => sum + axes[axis * q + a]! * (value - means[1]![a]!), 0);
    return Math.hypot(along(0), along(1));
  }

  /** The circle of a source has the variance alpha: what is multiplied. */
  #circleOf(plane: Plane, source: number) {
    return this.#circle(plane, this.#means![source]!, this.#alphas[source]!);
  }

  #circle(plane: Plane, mean: Float64Array, variance: number) {
    return ellipseOf(plane.place(mean, 0), plane.roundSpread(variance));
  }

  /** The place of the handle of a source, next to its circle. */
  #edge(plane: Plane, source: number): [number, number] {
    const { x, y, major } = this.#circleOf(plane, source);
    const [right, down] = DIRECTIONS[source]!;
    return [x + (major + OUTSIDE) * right, y + (major + OUTSIDE) * down];
  }

  #pull(plane: Plane, source: number, x: number, y: number): void {
    const unit = this.#circle(plane, this.#means![source]!, 1);
    const radius = Math.max(0, Math.hypot(x - unit.x, y - unit.y) - OUTSIDE) / unit.major;
    this.#set(source, radius * radius);
  }

  #set(source: number, alpha: number): void {
    const within = Math.min(ALPHA_MAX, Math.max(ALPHA_MIN, alpha));
    this.#setAll(this.#alphas.with(source, within));
  }

  #setAll(alphas: readonly number[]): void {
    this.#alphas = [...alphas];
    this.#rollouts.request([...this.#alphas]);
    this.changed();
  }

  override guess() {
    return this.hasGuessed || !this.#means ? null : this.words.guess;
  }

  override guessed(choice: string): void {
    super.guessed(choice);
    this.#setAll(this.#learned.map((alpha) => 2 * alpha));
    attempt(this.body, this.#compare());
  }

  async #compare(): Promise<void> {
    if (!this.#means) return;
    const twice = this.#learned.map((alpha) => 2 * alpha);
    const [before, after] = await Promise.all([this.#roll(this.#learned), this.#roll(twice)]);
    const wider = Math.sqrt(
      productOf(this.#means, twice).variance / productOf(this.#means, this.#learned).variance,
    );
    if (this.isHere) this.body.stage.setGhost(before.motion);
    this.#doubled = { apart: 1000 * largestDistance(before.motion, after.motion), wider };
    this.changed();
  }

  paint(draw: CanvasRenderingContext2D, plane: Plane): void {
    const { ink, quiet } = theme();
    const product = this.product!;
    draw.strokeStyle = partColourNow(ARMS);
    draw.globalAlpha = 0.25;
    draw.lineWidth = 3;
    strokeLoop(draw, plane, this.loop!.lap);
    const [nowX, nowY] = plane.place(this.#before, 0);
    const result = this.#circle(plane, product.mean, product.variance);
    for (const source of [LEGS, ARMS]) {
      const circle = this.#circleOf(plane, source);
      draw.fillStyle = draw.strokeStyle = partColourNow(source);
      draw.lineWidth = 3;
      drawEllipse(draw, circle, 0.14);
      draw.lineWidth = 1.5;
      draw.beginPath();
      draw.moveTo(circle.x, circle.y);
      draw.lineTo(result.x, result.y);
      draw.stroke();
      fillDot(draw, circle.x, circle.y, 5);
      const [x, y] = this.#edge(plane, source);
      fillDot(draw, x, y, 9);
      draw.strokeStyle = theme().ground;
      draw.lineWidth = 2.5;
      draw.stroke();
    }
    draw.strokeStyle = draw.fillStyle = ink;
    draw.lineWidth = 3;
    drawEllipse(draw, result, 0.2);
    fillDot(draw, result.x, result.y, 5);
    draw.strokeStyle = draw.fillStyle = quiet;
    draw.lineWidth = 2;
    draw.beginPath();
    draw.moveTo(nowX, nowY);
    draw.lineTo(result.x, result.y);
    draw.stroke();
    fillDot(draw, nowX, nowY, 6);
  }

  stage() {
    return this.pair(this.words.plane, this.#weights());
  }

  control() {
    if (!this.hasGuessed) return html`<p class="story-hint quiet">${this.words.hint}</p>`;
    const { learned, twice } = this.words;
    return html`<div class="story-row">
      <button class="story-button" data-testid="learned" @click=${() => this.#setAll(this.#learned)}>${learned}</button>
      <button class="story-button" data-testid="twice" @click=${() => this.#setAll(this.#alphas.map((alpha) => 2 * alpha))}>${twice}</button>
      </div>`;
  }

  /** Alpha and weight of both sources. */
  #weights() {
    const { product } = this;
    if (!product) return nothing;
    const { sources, row } = this.words;
    const line = (source: number, name: string) =>
      html`<li class="row tight" style=${partStyle(partColour(source))}><i class="swatch"></i>${row(
        name,
        this.#alphas[source]!.toPrecision(2),
        (100 * product.weights[source]!).toFixed(0),
      )}</li>`;
    return html`<ul class="story-pair-note passive quiet" data-testid="weights">
      ${line(ARMS, sources.arms)}${line(LEGS, sources.legs)}</ul>`;
  }

  reveal() {
    if (!this.hasGuessed || !this.#doubled) return null;
    const { apart, wider } = this.#doubled;
    return html`<p data-testid="doubled">${this.words.doubled(apart === 0 ? "0" : apart.toFixed(3), wider.toFixed(2))}</p>`;
  }

  equation() {
    return this.equations(["weights"], this.words.equation);
  }

  override lab() {
    const altered = this.#alphas.some((alpha, source) => alpha !== this.#learned[source]);
    if (!altered) return {};
    const alpha = Object.fromEntries(this.#alphas.map((value, source) => [`${source}.${ARMS}`, value]));
    return { alpha, reading: "as-learned" as const, model: this.body.model.id };
  }

  override leave(): void {
    this.#rollouts.drop();
    this.body.stage.setGhost(null);
    this.#alphas = [...this.#learned];
    this.#doubled = null;
    super.leave();
  }
}

export async function openChapter(app: App): Promise<Chapter> {
  return new ProductChapter(app.words, app.story);
}
