// What next? A Gaussian process guesses a step; the visitor guesses ten; futures show who was right.
import { html, nothing } from "lit";
import type { PredictionsReport, RolloutRequest, RolloutResult } from "../../engine/protocol";
import { ellipseOf, type Plane } from "../../latents/plane";
import type { Projection } from "../../latents/projection";
import { arrowHead, drawEllipse, fillDot, traceEllipse } from "../../latents/shapes";
import { partColourNow, theme } from "../../ui/palette";
import { prefersReducedMotion } from "../../ui/browser";
import type { WordsStore } from "../../words/words";
import type { StoryBody } from "../../app/story-body";
import type { Chapter } from "../chapter";
import { attempt, LatentChapter } from "../latent/latent-chapter";
import { strokeLoop, strokePath, tracePath, axesAt, type Place, pixelsAt, placeOf } from "../latent/drawing";
import type { Handle } from "../latent/latent-view";
import "../latent/latent-view";
import { type PinScore, scorePin, spreadOf } from "./pin";
import type { App } from "../../app/app";
import "../../stage/stage-view";

/** A path is back on the loop within this distance, in radii of the loop. */
const NEAR = 0.1;

/**
 * Seconds until a path stays near the loop; null: it does not. `distances`: in radii, one for each frame; the first
 * is one frame after the start.
 */
export function backFrom(distances: Float64Array, frameTime: number): number | null {
  const last = distances.findLastIndex((distance) => !(distance <= NEAR));
  return last === distances.length - 1 ? null : (last + 2) * frameTime;
}

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

export class NextChapter extends LatentChapter<"next"> {
  #sequence = 0;
  #start: PredictionsReport | null = null;
  /** The latents of the legs at the start [p x Q]. */
  #history: Float64Array = new Float64Array(0);
  /** Along the first two axes. */
  #pin: Place | null = null;
  #futures: Futures | null = null;
  #free: FreePath | null = null;
  /** Earlier paths from anywhere. */
  #past: Float64Array[] = [];
  /** Frames drawn of the futures or of the path. */
  #drawn = 0;
  #asked = 0;

  constructor(words: WordsStore, body: StoryBody) {
    super(words, "next", body);
    this.awaitLoop(LEGS, AROUND);
  }

  get projection(): Projection | null {
    return this.#start && (this.loop?.projection ?? null);
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
    return (this.body.model.model?.info.order ?? 2) - 1;
  }

  get handles(): readonly Handle[] {
    const pin: Handle = {
      id: "pin",
      label: this.hasGuessed ? this.words.anywhere : this.words.pin,
      anywhere: true,
      place: (plane) => pixelsAt(plane, this.loop!.projection, this.#pin ?? [0, 0]),
      drag: (plane, x, y) => this.#take(axesAt(plane, this.loop!.projection, x, y)),
      nudge: (right, down) => this.#nudge(right, down),
    };
    return [pin];
  }

  #request(frames: number): RolloutRequest {
    return { frames, sequence: this.#sequence, alpha: null, reading: "as-learned" };
  }

  /** Asks for the first step from the start, while the chapter is on screen. */
  protected async begin(): Promise<void> {
    const { engine } = this.body.engine;
    if (!engine || !this.loop || !this.isHere) return;
    this.#asked += 1;
    const asked = this.#asked;
    [this.choice, this.#futures, this.#free, this.#past, this.#drawn] = [null, null, null, [], 0];
    const request = this.#request(this.#frameNow + 2);
    const [start, rollout] = await Promise.all([engine.predictions(request), engine.rollout(request)]);
    if (asked !== this.#asked) return;
    this.#start = start;
    this.#history = rollout.latents[LEGS]!;
    // The pin waits in the middle of the loop, where it covers nothing.
    this.#pin = [0, 0];
    this.changed();
  }

  /** Moves the pin; after the guess, a path starts from there. */
  #take(place: Place): void {
    this.#pin = place;
    this.changed();
    if (this.hasGuessed && this.#futures) attempt(this.body, this.#startFrom(place));
  }

  #nudge(right: number, down: number): void {
    if (!this.#pin || !this.loop) return;
    const [width] = this.loop.projection.flat;
    const step = (STEP * width) / 250;
    this.#take([this.#pin[0] + right * step, this.#pin[1] - down * step]);
  }

  override guess() {
    return this.hasGuessed || !this.#start ? null : this.words.guess;
  }

  override guessed(choice: string): void {
    super.guessed(choice);
    attempt(this.body, this.#fan());
  }

  async #fan(): Promise<void> {
    const { engine } = this.body.engine;
    const { stage } = this.body;
    if (!engine || !this.#pin) return;
    const asked = this.#asked;
    const request = this.#request(this.#frameNow + 1 + FAN);
    const seed = 1 + FUTURES * this.#sequence;
    const [paths, mean] = await Promise.all([
      engine.futures(request, FUTURES, seed),
      engine.rollout(request),
    ]);
    if (asked !== this.#asked || !this.isHere) return;
    const frame = this.#frameNow + AHEAD;
    const places = paths.map(({ latents }) => placeOf(this.loop!.projection, latents[LEGS]!, frame));
    this.#futures = { paths, mean, score: scorePin(places, this.#pin) };
    this.pose.play(mean.motion);
    stage.setFutures(paths.slice(0, FIGURES).map(({ motion }) => motion));
    this.#run();
  }

  /** Draws frame after frame. */
  #run(): void {
    this.#drawn = prefersReducedMotion() ? this.#longest : 0;
    this.changed();
  }

  /** The mean path from a place: legs and their history are moved there. */
  async #startFrom(place: Readonly<Place>): Promise<void> {
    const { engine } = this.body.engine;
    const { model, stage } = this.body;
    if (!engine || !model.learned || !this.loop) return;
    this.#asked += 1;
    const asked = this.#asked;
    const { first } = this.loop.lap;
    const { axes, dimensions: q } = this.loop.projection;
    const [fromRight, fromUp] = placeOf(this.loop!.projection, model.learned.latents[LEGS]!, first);
    const [right, up] = [place[0] - fromRight, place[1] - fromUp];
    const by = Array.from({ length: q }, (_, a) => right * axes[a]! + up * axes[q + a]!);
    await engine.startLive(model.learned.request, first);
    const { latents, distances, motion } = await engine.advanceLive({
      back: 0,
      changes: [{ kind: "push", part: LEGS, by }],
      frames: PATH,
    });
    await engine.endLive();
    if (asked !== this.#asked || !this.isHere) return;
    const parts = latents.length;
    const away = Float64Array.from(
      { length: distances.length / parts },
      (_, t) => distances[t * parts + LEGS]!,
    );
    if (this.#free) this.#past = [...this.#past, this.#free.latents].slice(-PATHS);
    this.#free = { latents: latents[LEGS]!, back: backFrom(away, motion.frameTime) };
    stage.setFutures([]);
    this.pose.play(motion);
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
    const { lap, projection } = this.loop!;
    draw.strokeStyle = colour;
    draw.globalAlpha = 0.25;
    draw.lineWidth = 3;
    strokeLoop(draw, plane, lap);
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
    draw.strokeStyle = draw.fillStyle = ink;
    draw.lineWidth = 2.5;
    drawEllipse(draw, circle, 0.18, 2);
    draw.beginPath();
    draw.moveTo(now[0], now[1]);
    draw.lineTo(to[0], to[1]);
    draw.stroke();
    arrowHead(draw, [...now], [...to], 10);
    draw.fillStyle = colour;
    fillDot(draw, from[0], from[1], 5);
    fillDot(draw, now[0], now[1], 9);
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
    for (const { latents } of paths) strokePath(draw, plane, latents[LEGS]!, first, last);
    draw.globalAlpha = 1;
    draw.lineWidth = 3;
    draw.strokeStyle = colour;
    strokePath(draw, plane, mean.latents[LEGS]!, first, last);
    if (this.#drawn < AHEAD) return;
    draw.fillStyle = colour;
    const places = paths.map(({ latents }): [number, number] => {
      const [x, y] = plane.place(latents[LEGS]!, first + AHEAD);
      return [x, y];
    });
    for (const [x, y] of places) fillDot(draw, x, y, 2.2);
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
    for (const path of this.#past) strokePath(draw, plane, path, 0, PATH - 1);
    draw.globalAlpha = 1;
    draw.lineWidth = 3;
    draw.beginPath();
    if (this.#pin) draw.moveTo(...pixelsAt(plane, this.loop!.projection, this.#pin));
    tracePath(draw, plane, latents, 0, last);
    draw.stroke();
    const [x, y] = plane.place(latents, last);
    fillDot(draw, x, y, 8);
  }

  #paintPin(draw: CanvasRenderingContext2D, plane: Plane, ink: string): void {
    if (!this.#pin) return;
    const [x, y] = pixelsAt(plane, this.loop!.projection, this.#pin);
    draw.globalAlpha = 1;
    draw.strokeStyle = ink;
    draw.lineWidth = 2.5;
    draw.beginPath();
    draw.moveTo(x, y);
    draw.lineTo(x, y - 26);
    draw.stroke();
    draw.fillStyle = "#d55e00";
    fillDot(draw, x, y - 30, 9);
  }

  stage() {
    return this.pair(this.words.plane);
  }

  control() {
    const { hint, hintAnywhere, again } = this.words;
    if (!this.hasGuessed) return html`<p class="story-hint quiet">${hint}</p>`;
    if (!this.#futures) return null;
    return html`<div class="story-row">
      <button class="story-button" data-testid="next-start" @click=${() => this.#another()}>${again}</button>
      <p class="story-hint quiet">${hintAnywhere}</p></div>`;
  }

  #another(): void {
    const count = this.body.model.model?.info.sequences.length ?? 1;
    this.#sequence = (this.#sequence + 1) % count;
    this.body.stage.setFutures([]);
    this.pose.end();
    attempt(this.body, this.begin());
  }

  reveal() {
    if (!this.#futures || (!this.#free && this.#drawn < AHEAD)) return null;
    const { deviations, beaten, futures } = this.#futures.score;
    const { away, beat, back, lost } = this.words;
    return html`
      <p data-testid="score">${away(deviations.toFixed(1))} ${beat(beaten, futures)}</p>
      ${
        this.#free && this.#drawn === PATH
          ? html`<p data-testid="back">${this.#free.back === null ? lost : back(this.#free.back.toFixed(2))}</p>`
          : nothing
      }`;
  }

  equation() {
    return this.equations(["dynamics"], this.words.equation);
  }

  override lab() {
    return { start: this.#sequence };
  }

  override arrive(): void {
    super.arrive();
    if (!this.#start) attempt(this.body, this.begin());
  }

  override leave(): void {
    this.#asked += 1;
    [this.#start, this.#futures, this.#free] = [null, null, null];
    this.body.stage.setFutures([]);
    super.leave();
  }
}

const crosses = (before: number, after: number, at: number) => before < at && after >= at;

export async function openChapter(app: App): Promise<Chapter> {
  return new NextChapter(app.words, app.story);
}
