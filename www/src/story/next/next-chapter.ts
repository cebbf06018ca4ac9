// What next? A Gaussian process guesses a step; the visitor guesses ten; futures show who was right.
import { html, nothing } from "lit";
import type { PredictionsReport, RolloutRequest, RolloutResult } from "../../engine/protocol";
import { ellipseOf, type Plane } from "../../latents/plane";
import type { Projection } from "../../latents/projection";
import { arrowHead, traceEllipse } from "../../latents/shapes";
import { partColourNow, theme } from "../../ui/palette";
import { prefersReducedMotion } from "../../ui/reduced-motion";
import { Store } from "../../ui/store";
import type { WordsStore } from "../../words/words";
import type { StoryBody } from "../body";
import type { Chapter } from "../chapter";
import { attempt } from "../latent/attempt";
import { equation } from "../latent/equation";
import type { Handle, LatentScene } from "../latent/latent-view";
import { PoseStage } from "../latent/pose-stage";
import { axesAt } from "../latent/certainty-map";
import { type WalkLoop, walkLoop } from "../latent/walk-loop";
import { backFrom } from "./back";
import { type PinScore, scorePin, spreadOf } from "./pin";

const LEGS = 0;
/** The plot shows this many times the width of the loop. */
const AROUND = 1.5;
/** Frames from now to the pin. */
const AHEAD = 10;
const FUTURES = 100;
/** Futures that the stage shows as faint figures. */
const FIGURES = 4;
/** Frames of a future, and of a path from anywhere. */
const FAN = 30;
const PATH = 120;
/** Earlier paths that stay in the drawing. */
const PATHS = 6;
/** Frames drawn in a second. */
const SPEED = 24;
/** Pixels that an arrow key moves the pin. */
const STEP = 12;

interface Futures {
  paths: RolloutResult[];
  mean: RolloutResult;
  score: PinScore;
}

/** A mean path from a place that the visitor has chosen. */
interface FreePath {
  /** [frames x Q] */
  latents: Float64Array;
  /** Seconds until the path stays near the loop; null: it does not come back. */
  back: number | null;
}

export class NextChapter extends Store implements Chapter, LatentScene {
  readonly #words: WordsStore;
  readonly #body: StoryBody;
  readonly #pose: PoseStage;
  #loop: WalkLoop | null = null;
  #sequence = 0;
  #start: PredictionsReport | null = null;
  /** The latents of the legs at the start [p x Q]. */
  #history: Float64Array = new Float64Array(0);
  /** Along the first two axes. */
  #pin: [number, number] | null = null;
  #guessed = false;
  #futures: Futures | null = null;
  #free: FreePath | null = null;
  /** Earlier paths from anywhere. */
  #past: Float64Array[] = [];
  /** Frames drawn of the futures or of the path. */
  #drawn = 0;
  #asked = 0;
  #here = false;

  constructor(words: WordsStore, body: StoryBody) {
    super();
    this.#words = words;
    this.#body = body;
    this.#pose = new PoseStage(body);
    body.model.on(() => this.#open());
    this.#open();
  }

  get #now() {
    return this.#words.now.chapters.next;
  }

  get projection(): Projection | null {
    return this.#start && (this.#loop?.projection ?? null);
  }

  get moves(): boolean {
    return this.#drawn < this.#longest;
  }

  get score(): PinScore | null {
    return this.#futures?.score ?? null;
  }

  get #longest(): number {
    return this.#free ? PATH : this.#futures ? FAN : 0;
  }

  /** The last frame of the start: the state now. */
  get #frameNow(): number {
    return (this.#body.model.model?.info.order ?? 2) - 1;
  }

  get handles(): readonly Handle[] {
    const pin: Handle = {
      id: "pin",
      label: this.#guessed ? this.#now.anywhere : this.#now.pin,
      anywhere: true,
      place: (plane) => this.#pixels(plane, this.#pin ?? [0, 0]),
      drag: (plane, x, y) => this.#take(axesAt(plane, this.#loop!.projection, x, y)),
      nudge: (right, down) => this.#nudge(right, down),
    };
    return [pin];
  }

  #open(): void {
    if (this.#loop) return;
    this.#loop = walkLoop(this.#body, LEGS, AROUND);
    if (this.#loop && this.#here) attempt(this.#body, this.#begin());
  }

  #request(frames: number): RolloutRequest {
    return { frames, sequence: this.#sequence, alpha: null, reading: "as-learned" };
  }

  /** Asks for the first step from the start. */
  async #begin(): Promise<void> {
    const { engine } = this.#body.engine;
    if (!engine || !this.#loop) return;
    this.#asked += 1;
    const asked = this.#asked;
    [this.#guessed, this.#futures, this.#free, this.#past, this.#drawn] = [false, null, null, [], 0];
    const request = this.#request(this.#frameNow + 2);
    const [start, rollout] = await Promise.all([engine.predictions(request), engine.rollout(request)]);
    if (asked !== this.#asked) return;
    this.#start = start;
    this.#history = rollout.latents[LEGS]!;
    // The pin waits where the point is now.
    this.#pin = this.#axes(this.#history, this.#frameNow);
    this.changed();
  }

  /** Row `row` of latents [frames x Q] along the first two axes. */
  #axes(latents: Float64Array, row: number): [number, number] {
    const { centre, axes, dimensions: q } = this.#loop!.projection;
    const along = (axis: number) => {
      let sum = 0;
      for (let a = 0; a < q; a++) sum += axes[axis * q + a]! * (latents[row * q + a]! - centre[a]!);
      return sum;
    };
    return [along(0), along(1)];
  }

  #pixels(plane: Plane, [right, up]: readonly [number, number]): [number, number] {
    const { centre, axes, dimensions: q } = this.#loop!.projection;
    const point = Float64Array.from(
      { length: q },
      (_, a) => centre[a]! + right * axes[a]! + up * axes[q + a]!,
    );
    const [x, y] = plane.place(point, 0);
    return [x, y];
  }

  /** Moves the pin; after the guess, a path starts from there. */
  #take(place: [number, number]): void {
    this.#pin = place;
    this.changed();
    if (this.#guessed && this.#futures) attempt(this.#body, this.#startFrom(place));
  }

  #nudge(right: number, down: number): void {
    if (!this.#pin || !this.#loop) return;
    const [width] = this.#loop.projection.flat;
    const step = (STEP * width) / 250;
    this.#take([this.#pin[0] + right * step, this.#pin[1] - down * step]);
  }

  guess() {
    return this.#guessed || !this.#start ? null : this.#now.guess;
  }

  guessed(): void {
    this.#guessed = true;
    this.changed();
    attempt(this.#body, this.#fan());
  }

  async #fan(): Promise<void> {
    const { engine } = this.#body.engine;
    const { stage } = this.#body;
    if (!engine || !this.#pin) return;
    const asked = this.#asked;
    const request = this.#request(this.#frameNow + 1 + FAN);
    const seed = 1 + FUTURES * this.#sequence;
    const [paths, mean] = await Promise.all([
      engine.futures(request, FUTURES, seed),
      engine.rollout(request),
    ]);
    if (asked !== this.#asked || !this.#here) return;
    const frame = this.#frameNow + AHEAD;
    const places = paths.map(({ latents }) => this.#axes(latents[LEGS]!, frame));
    this.#futures = { paths, mean, score: scorePin(places, this.#pin) };
    this.#pose.play(mean.motion);
    stage.setFutures(paths.slice(0, FIGURES).map(({ motion }) => motion));
    this.#run();
  }

  /** Draws frame after frame. */
  #run(): void {
    this.#drawn = prefersReducedMotion() ? this.#longest : 0;
    this.changed();
  }

  /** The mean path from a place: legs and their history are moved there. */
  async #startFrom(place: readonly [number, number]): Promise<void> {
    const { engine } = this.#body.engine;
    const { model, stage } = this.#body;
    if (!engine || !model.learned || !this.#loop) return;
    this.#asked += 1;
    const asked = this.#asked;
    const { first } = this.#loop.lap;
    const { axes, dimensions: q } = this.#loop.projection;
    const [fromRight, fromUp] = this.#axes(model.learned.latents[LEGS]!, first);
    const [right, up] = [place[0] - fromRight, place[1] - fromUp];
    const by = Array.from({ length: q }, (_, a) => right * axes[a]! + up * axes[q + a]!);
    await engine.startLive(model.learned.request, first);
    const { latents, distances, motion } = await engine.advanceLive([{ kind: "push", part: LEGS, by }], PATH);
    await engine.endLive();
    if (asked !== this.#asked || !this.#here) return;
    const parts = latents.length;
    const away = Float64Array.from(
      { length: distances.length / parts },
      (_, t) => distances[t * parts + LEGS]!,
    );
    if (this.#free) this.#past = [...this.#past, this.#free.latents].slice(-PATHS);
    this.#free = { latents: latents[LEGS]!, back: backFrom(away, motion.frameTime) };
    stage.setFutures([]);
    this.#pose.play(motion);
    this.#run();
  }

  tick(seconds: number): void {
    if (!this.moves) return;
    const before = this.#drawn;
    this.#drawn = Math.min(this.#longest, this.#drawn + SPEED * seconds * (this.#free ? 2 : 1));
    // The sentences come when their frames are drawn.
    if (crosses(before, this.#drawn, AHEAD) || this.#drawn === this.#longest) this.changed();
  }

  paint(draw: CanvasRenderingContext2D, plane: Plane): void {
    const { quiet, ink } = theme();
    const colour = partColourNow(LEGS);
    const { lap, projection } = this.#loop!;
    draw.strokeStyle = colour;
    draw.globalAlpha = 0.25;
    draw.lineWidth = 3;
    draw.beginPath();
    for (let t = 0; t < lap.frames; t++) trace(draw, plane, lap.path, t);
    draw.closePath();
    draw.stroke();
    if (this.#free) this.#paintFree(draw, plane, this.#free, colour);
    else if (this.#futures) this.#paintFutures(draw, plane, this.#futures, colour, quiet);
    if (!this.#free) this.#paintStep(draw, plane, colour, ink, projection.dimensions);
    this.#paintPin(draw, plane, ink);
  }

  /** The states before and now, and the guess of the next one: arrow and circle. */
  #paintStep(draw: CanvasRenderingContext2D, plane: Plane, colour: string, ink: string, q: number): void {
    const product = this.#start!.parts[LEGS]!.product;
    const [from, now, to] = [
      plane.place(this.#history, this.#frameNow - 1),
      plane.place(this.#history, this.#frameNow),
      plane.place(product.means.subarray(0, q), 0),
    ];
    const circle = ellipseOf(to, plane.roundSpread(product.variances[0]!));
    draw.globalAlpha = 0.18;
    draw.fillStyle = ink;
    draw.beginPath();
    traceEllipse(draw, circle, 2);
    draw.fill();
    draw.globalAlpha = 1;
    draw.strokeStyle = draw.fillStyle = ink;
    draw.lineWidth = 2.5;
    draw.beginPath();
    traceEllipse(draw, circle, 2);
    draw.stroke();
    draw.beginPath();
    draw.moveTo(now[0], now[1]);
    draw.lineTo(to[0], to[1]);
    draw.stroke();
    arrowHead(draw, [...now], [...to], 10);
    draw.fillStyle = colour;
    for (const [place, size] of [
      [from, 5],
      [now, 9],
    ] as const) {
      draw.beginPath();
      draw.arc(place[0], place[1], size, 0, 2 * Math.PI);
      draw.fill();
    }
  }

  #paintFutures(
    draw: CanvasRenderingContext2D,
    plane: Plane,
    { paths, mean }: Futures,
    colour: string,
    quiet: string,
  ): void {
    const first = this.#frameNow;
    const last = first + Math.floor(this.#drawn);
    draw.lineWidth = 1;
    draw.strokeStyle = draw.fillStyle = quiet;
    draw.globalAlpha = 0.3;
    for (const { latents } of paths) {
      draw.beginPath();
      for (let t = first; t <= last; t++) trace(draw, plane, latents[LEGS]!, t);
      draw.stroke();
    }
    draw.globalAlpha = 1;
    draw.lineWidth = 3;
    draw.strokeStyle = colour;
    draw.beginPath();
    for (let t = first; t <= last; t++) trace(draw, plane, mean.latents[LEGS]!, t);
    draw.stroke();
    if (this.#drawn < AHEAD) return;
    draw.fillStyle = colour;
    const places = paths.map(({ latents }): [number, number] => {
      const [x, y] = plane.place(latents[LEGS]!, first + AHEAD);
      return [x, y];
    });
    for (const [x, y] of places) {
      draw.beginPath();
      draw.arc(x, y, 2.2, 0, 2 * Math.PI);
      draw.fill();
    }
    const { mean: middle, covariance } = spreadOf(places);
    draw.strokeStyle = colour;
    for (const deviations of [1, 2]) {
      draw.lineWidth = deviations === 1 ? 2.5 : 1.25;
      draw.beginPath();
      traceEllipse(draw, ellipseOf(middle, covariance), deviations);
      draw.stroke();
    }
  }

  #paintFree(draw: CanvasRenderingContext2D, plane: Plane, { latents }: FreePath, colour: string): void {
    const last = Math.min(PATH - 1, Math.floor(this.#drawn));
    draw.strokeStyle = draw.fillStyle = colour;
    draw.globalAlpha = 0.35;
    draw.lineWidth = 1.5;
    for (const path of this.#past) {
      draw.beginPath();
      for (let t = 0; t < PATH; t++) trace(draw, plane, path, t);
      draw.stroke();
    }
    draw.globalAlpha = 1;
    draw.lineWidth = 3;
    draw.beginPath();
    if (this.#pin) draw.moveTo(...this.#pixels(plane, this.#pin));
    for (let t = 0; t <= last; t++) trace(draw, plane, latents, t);
    draw.stroke();
    const [x, y] = plane.place(latents, last);
    draw.beginPath();
    draw.arc(x, y, 8, 0, 2 * Math.PI);
    draw.fill();
  }

  #paintPin(draw: CanvasRenderingContext2D, plane: Plane, ink: string): void {
    if (!this.#pin) return;
    const [x, y] = this.#pixels(plane, this.#pin);
    draw.globalAlpha = 1;
    draw.strokeStyle = ink;
    draw.lineWidth = 2.5;
    draw.beginPath();
    draw.moveTo(x, y);
    draw.lineTo(x, y - 26);
    draw.stroke();
    draw.fillStyle = "#d55e00";
    draw.beginPath();
    draw.arc(x, y - 30, 9, 0, 2 * Math.PI);
    draw.fill();
  }

  stage() {
    const { stage, playback } = this.#body;
    return html`
      <div class="story-pair">
        <pg-latent-space .scene=${this} .label=${this.#now.plane}></pg-latent-space>
        <pg-stage .stage=${stage} .playback=${playback} .running=${true} .label=${this.#words.now.chapters.arms.figure}></pg-stage>
      </div>`;
  }

  control() {
    const { hint, hintAnywhere, again } = this.#now;
    if (!this.#guessed) return html`<p class="story-hint">${hint}</p>`;
    if (!this.#futures) return null;
    return html`<div class="story-row">
      <button class="story-button" data-testid="next-start" @click=${() => this.#another()}>${again}</button>
      <p class="story-hint">${hintAnywhere}</p></div>`;
  }

  #another(): void {
    const count = this.#body.model.model?.info.sequences.length ?? 1;
    this.#sequence = (this.#sequence + 1) % count;
    this.#body.stage.setFutures([]);
    this.#pose.end();
    attempt(this.#body, this.#begin());
  }

  reveal() {
    if (!this.#futures || (!this.#free && this.#drawn < AHEAD)) return null;
    const { deviations, beaten, futures } = this.#futures.score;
    const { away, beat, back, lost } = this.#now;
    return html`
      <p data-testid="score">${away(deviations.toFixed(1))} ${beat(beaten, futures)}</p>
      ${
        this.#free && this.#drawn === PATH
          ? html`<p data-testid="back">${this.#free.back === null ? lost : back(this.#free.back.toFixed(2))}</p>`
          : nothing
      }`;
  }

  equation() {
    return equation("dynamics", this.#now.equation);
  }

  lab() {
    return { tab: "loops" as const, start: this.#sequence };
  }

  arrive(): void {
    this.#here = true;
    void this.#body.showFirstMotion();
    this.#body.start().catch(() => {});
    if (!this.#start) attempt(this.#body, this.#begin());
    if (!prefersReducedMotion()) this.#body.playback.play();
  }

  leave(): void {
    this.#here = false;
    this.#asked += 1;
    [this.#start, this.#guessed, this.#futures, this.#free] = [null, false, null, null];
    this.#body.stage.setFutures([]);
    this.#pose.end();
  }
}

const crosses = (before: number, after: number, at: number) => before < at && after >= at;

function trace(draw: CanvasRenderingContext2D, plane: Plane, latents: Float64Array, row: number): void {
  const [x, y] = plane.place(latents, row);
  draw.lineTo(x, y);
}
