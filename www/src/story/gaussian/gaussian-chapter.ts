// What is a Gaussian process? One input, points to drag, inducing points, and an input that is uncertain.
import { html } from "lit";
import type { Plane } from "../../latents/plane";
import type { Projection } from "../../latents/projection";
import { fillDot } from "../../latents/shapes";
import { partColourNow, theme } from "../../ui/palette";
import type { WordsStore } from "../../words/words";
import type { Chapter } from "../chapter";
import { GuessedChapter } from "../guessed-chapter";
import type { Handle, LatentScene } from "../latent/latent-view";
import "../latent/latent-view";
import { type Point, type Prediction, Process } from "./process";
import type { App } from "../../app/app";

const KERNEL = { lambda: 0.5, variance: 1 };
const NOISE = 0.01;
const START: readonly Point[] = [
  [-2.4, -0.7],
  [-1.5, 0.3],
  [-0.9, 0.9],
  [0.1, 0.2],
  [0.8, -0.6],
];
const INDUCING = [-2.2, -1, 0.6];
/** Half the width and height of the drawing. */
const WIDTH = 4;
const HEIGHT = 1.9;
/** The heights of the inducing points and of the uncertain input. */
const INDUCING_AT = -0.62 * HEIGHT;
const INPUT_AT = -0.82 * HEIGHT;
/** The place that the question is about. */
const ASKED = 2.8;
/** The step of an arrow key. */
const STEP = 0.1;
/** The largest standard deviation of the uncertain input. */
const MOST = 1;

const within = (value: number, most: number) => Math.max(-most, Math.min(most, value));

export class GaussianChapter extends GuessedChapter<"gaussian"> implements LatentScene {
  #points: Point[] = [...START];
  #inducing = [...INDUCING];
  /** Whether the inducing points stand for all points. */
  #sparse = false;
  #input = -0.4;
  /** Standard deviation of the input. */
  #spread = 0;
  #process = this.#fit();

  readonly projection: Projection = {
    centre: Float64Array.of(0, 0),
    axes: Float64Array.of(1, 0, 0, 1, 0, 0),
    reach: WIDTH,
    flat: [0.82 * WIDTH, 0.82 * HEIGHT],
    dimensions: 2,
  };
  readonly moves = false;

  constructor(words: WordsStore) {
    super(words, "gaussian");
  }

  /** The process about the place of the question. */
  get asked(): Prediction {
    return this.#process.at(ASKED);
  }

  get handles(): readonly Handle[] {
    const place = (x: number, y: number) => (plane: Plane) => {
      const [px, py] = plane.place(Float64Array.of(x, y), 0);
      return [px, py] as const;
    };
    const points = this.#points.map(
      ([x, y], i): Handle => ({
        id: `point-${i}`,
        label: this.words.point(i + 1),
        place: place(x, y),
        drag: (plane, px, py) => this.#movePoint(i, ...this.#at(plane, px, py)),
        nudge: (right, down) => this.#movePoint(i, x + STEP * right, y - STEP * down),
      }),
    );
    if (!this.hasGuessed) return points;
    const inducing = this.#inducing.map(
      (x, i): Handle => ({
        id: `inducing-${i}`,
        label: this.words.inducing(i + 1),
        place: place(x, INDUCING_AT),
        drag: (plane, px, py) => this.#moveInducing(i, this.#at(plane, px, py)[0]),
        nudge: (right) => this.#moveInducing(i, x + STEP * right),
      }),
    );
    const input: Handle = {
      id: "input",
      label: this.words.input,
      place: place(this.#input, INPUT_AT),
      drag: (plane, px, py) => this.#moveInput(this.#at(plane, px, py)[0]),
      nudge: (right) => this.#moveInput(this.#input + STEP * right),
    };
    return [...points, ...(this.#sparse ? inducing : []), input];
  }

  #at(plane: Plane, px: number, py: number): [number, number] {
    const [x0, y0] = plane.place(Float64Array.of(0, 0), 0);
    const [x, y] = plane.latentStep(px - x0, py - y0);
    return [x!, y!];
  }

  #fit(): Process {
    const inducing = this.#sparse ? this.#inducing : this.#points.map(([x]) => x);
    return new Process(this.#points, inducing, KERNEL, NOISE);
  }

  #refit(): void {
    this.#process = this.#fit();
    this.changed();
  }

  #movePoint(index: number, x: number, y: number): void {
    this.#points[index] = [within(x, WIDTH), within(y, HEIGHT)];
    this.#refit();
  }

  #moveInducing(index: number, x: number): void {
    this.#inducing[index] = within(x, WIDTH);
    this.#refit();
  }

  #moveInput(x: number): void {
    this.#input = within(x, WIDTH);
    this.changed();
  }

  paint(draw: CanvasRenderingContext2D, plane: Plane, { width }: { width: number; height: number }): void {
    const { ink, quiet, line } = theme();
    const colour = partColourNow(0);
    const pixels = (x: number, y: number): [number, number] => {
      const [px, py] = plane.place(Float64Array.of(x, y), 0);
      return [px, py];
    };
    const [zero, base] = pixels(0, 0);
    draw.strokeStyle = line;
    draw.lineWidth = 1;
    draw.beginPath();
    draw.moveTo(0, base);
    draw.lineTo(width, base);
    draw.stroke();
    const perPixel = plane.latentStep(1, 0)[0]!;
    const columns: [number, Prediction][] = [];
    // Before the guess, the curve ends where it would tell the answer.
    const ends = this.hasGuessed ? [0, width] : [-0.9 * ASKED, 0.55 * ASKED].map((x) => pixels(x, 0)[0]);
    for (let px = ends[0]!; px < ends[1]! + 3; px += 3)
      columns.push([px, this.#process.at((px - zero) * perPixel)]);
    const y = (value: number) => base - value / perPixel;
    draw.fillStyle = draw.strokeStyle = colour;
    for (const deviations of [2, 1]) {
      draw.globalAlpha = 0.15;
      draw.beginPath();
      for (const [px, { mean, variance }] of columns)
        draw.lineTo(px, y(mean + deviations * Math.sqrt(variance)));
      for (const [px, { mean, variance }] of columns.toReversed())
        draw.lineTo(px, y(mean - deviations * Math.sqrt(variance)));
      draw.fill();
    }
    draw.globalAlpha = 1;
    draw.lineWidth = 3;
    draw.beginPath();
    for (const [px, { mean }] of columns) draw.lineTo(px, y(mean));
    draw.stroke();
    if (!this.hasGuessed) {
      const [px] = pixels(ASKED, 0);
      draw.strokeStyle = quiet;
      draw.lineWidth = 2;
      draw.setLineDash([3, 6]);
      draw.beginPath();
      draw.moveTo(px, y(HEIGHT));
      draw.lineTo(px, y(-HEIGHT));
      draw.stroke();
      draw.setLineDash([]);
    } else this.#paintInput(draw, pixels, perPixel);
    if (this.choice === "on") this.#paintGuess(draw, pixels, quiet);
    draw.fillStyle = ink;
    for (const point of this.#points) fillDot(draw, ...pixels(...point), 9);
    if (!this.#sparse || !this.hasGuessed) return;
    draw.fillStyle = "#d55e00";
    for (const x of this.#inducing) {
      const [px, py] = pixels(x, INDUCING_AT);
      draw.beginPath();
      draw.moveTo(px, py - 11);
      draw.lineTo(px + 10, py + 8);
      draw.lineTo(px - 10, py + 8);
      draw.fill();
    }
  }

  /** The curve as it would go on behind its last point. */
  #paintGuess(
    draw: CanvasRenderingContext2D,
    pixels: (x: number, y: number) => [number, number],
    colour: string,
  ): void {
    const last = Math.max(...this.#points.map(([x]) => x));
    // The curve before, turned about its last point: a wave that goes on.
    const [end, steps] = [this.#process.at(last).mean, Math.ceil((WIDTH - last) / STEP)];
    draw.strokeStyle = colour;
    draw.lineWidth = 2;
    draw.setLineDash([6, 6]);
    draw.beginPath();
    for (let k = 0; k <= steps; k++)
      draw.lineTo(...pixels(last + k * STEP, 2 * end - this.#process.at(last - k * STEP).mean));
    draw.stroke();
    draw.setLineDash([]);
  }

  /** The uncertain input below, and the prediction there: a bar of two standard deviations to each side. */
  #paintInput(
    draw: CanvasRenderingContext2D,
    pixels: (x: number, y: number) => [number, number],
    perPixel: number,
  ): void {
    const colour = partColourNow(1);
    const [px, bottom] = pixels(this.#input, INPUT_AT);
    const { mean, variance } = this.#process.at(this.#input, this.#spread ** 2);
    const [, middle] = pixels(this.#input, mean);
    const half = (2 * Math.sqrt(variance)) / perPixel;
    draw.strokeStyle = draw.fillStyle = colour;
    draw.lineWidth = 5;
    draw.beginPath();
    draw.moveTo(px, middle - half);
    draw.lineTo(px, middle + half);
    draw.stroke();
    fillDot(draw, px, middle, 7);
    const wide = (2 * this.#spread) / perPixel;
    draw.lineWidth = 5;
    draw.beginPath();
    draw.moveTo(px - wide, bottom);
    draw.lineTo(px + wide, bottom);
    draw.stroke();
    fillDot(draw, px, bottom, 9);
  }

  stage() {
    return html`<div class="story-single"><pg-latent-space .scene=${this} .label=${this.words.plane}></pg-latent-space></div>`;
  }

  control() {
    const { hint, exact, sparse, spread } = this.words;
    if (!this.hasGuessed) return html`<p class="story-hint quiet">${hint}</p>`;
    const choose = (on: boolean) => () => {
      this.#sparse = on;
      this.#refit();
    };
    return html`
      <div class="story-row"><div class="segments" role="group">
        <button aria-pressed=${this.#sparse ? "false" : "true"} data-testid="exact" @click=${choose(false)}>${exact}</button>
        <button aria-pressed=${this.#sparse ? "true" : "false"} data-testid="sparse" @click=${choose(true)}>${sparse(this.#inducing.length)}</button>
      </div>
      <label class="story-slider row loose note">${spread}
        <input type="range" min="0" max=${MOST} step="0.02" data-testid="spread" .value=${String(this.#spread)}
          @input=${({ target }: Event) => {
            this.#spread = Number((target as HTMLInputElement).value);
            this.changed();
          }} /></label></div>`;
  }

  reveal() {
    if (!this.hasGuessed) return null;
    const number = (value: number) => (Math.abs(value) < 0.005 ? "0.00" : value.toFixed(2));
    const wide = ({ variance }: Prediction) => number(2 * Math.sqrt(variance));
    const far = this.asked;
    const near = this.#process.at(this.#points[0]![0]);
    const here = this.#process.at(this.#input, this.#spread ** 2);
    const { answer, input } = this.words.reveal;
    return html`
      <p data-testid="far">${answer(number(far.mean), wide(far), wide(near))}</p>
      <p data-testid="input">${input(number(here.mean), wide(here))}</p>`;
  }

  equation() {
    return this.equations(["kernel"], this.words.equation);
  }

  override lab() {
    return { view: "series" as const };
  }

  override leave(): void {
    super.leave();
    this.#sparse = false;
    [this.#points, this.#inducing, this.#spread] = [[...START], [...INDUCING], 0];
    this.#process = this.#fit();
  }
}

export async function openChapter(app: App): Promise<Chapter> {
  return new GaussianChapter(app.words);
}
