// A walk is a loop: the legs' path through their latent space, and the poses of its points.
import { html, nothing } from "lit";
import { Latest } from "../../engine/latest";
import type { Plane } from "../../latents/plane";
import type { Projection } from "../../latents/projection";
import { partColourNow, theme } from "../../ui/palette";
import { prefersReducedMotion } from "../../ui/reduced-motion";
import { Store } from "../../ui/store";
import type { WordsStore } from "../../words/words";
import type { StoryBody } from "../body";
import type { Chapter } from "../chapter";
import { attempt } from "../latent/attempt";
import {
  axesAt,
  type Cells,
  cellPoints,
  cellsOf,
  certaintyPicture,
  channels,
  drawCertainty,
  strengthOf,
} from "../latent/certainty-map";
import { equation } from "../latent/equation";
import type { Lap } from "../latent/lap";
import type { Handle, LatentScene } from "../latent/latent-view";
import { lift, nearestRow } from "../latent/lift";
import { PoseStage } from "../latent/pose-stage";
import { walkLoop } from "../latent/walk-loop";

const LEGS = 0;
/** The plot shows this many times the width of the loop. */
const AROUND = 1.75;
/** Pixels within which the dot stays on the loop. */
const SNAP = 16;
/** Distance of the dot from the middle after the guess, in radii of the loop, and seconds on the way. */
const AWAY = 1.9;
const SECONDS = 1.6;
/** The step of an arrow key off the loop, in radii of the loop. */
const STEP = 0.12;

/** A point of the plane, along the first two axes. */
type Place = [right: number, up: number];

interface Known {
  /** The share of the prior variance at the dot. */
  share: number;
  /** The largest share on the loop. */
  onLoop: number;
}

export class LoopChapter extends Store implements Chapter, LatentScene {
  readonly #words: WordsStore;
  readonly #body: StoryBody;
  readonly #pose: PoseStage;
  #lap: Lap | null = null;
  #projection: Projection | null = null;
  /** The lap on the axes of the plot [frames x 3]. */
  #seen: Float64Array = new Float64Array(0);
  #place: Place = [0, 0];
  #walks = true;
  #frame = 0;
  #guessed = false;
  /** Seconds since the guess, while the dot leaves the loop by itself. */
  #leaving: number | null = null;
  #known: Known | null = null;
  #onLoop = 0;
  #map: { picture: HTMLCanvasElement; cells: Cells; colour: string } | null = null;
  #mapAsked = "";
  readonly #poses: Latest<Place, { positions: Float32Array; share: number; point: Place }>;

  constructor(words: WordsStore, body: StoryBody) {
    super();
    this.#words = words;
    this.#body = body;
    this.#pose = new PoseStage(body);
    this.#poses = new Latest(
      (place) => this.#ask(place),
      (answer) => this.#take(answer.positions, answer.share),
      (problem) => attempt(body, Promise.reject(problem)),
    );
    body.model.on(() => this.#open());
    this.#open();
  }

  get #now() {
    return this.#words.now.chapters.loop;
  }

  get projection(): Projection | null {
    return this.#projection;
  }

  get moves(): boolean {
    return this.#walks || this.#leaving !== null;
  }

  get #isOnLoop(): boolean {
    const row = nearestRow(this.#seen, ...this.#place);
    return (
      Math.hypot(this.#seen[3 * row]! - this.#place[0], this.#seen[3 * row + 1]! - this.#place[1]) < 1e-9
    );
  }

  /** The share of the prior variance at the dot and the largest on the loop; null before it is measured. */
  get known(): Known | null {
    return this.#known;
  }

  get handles(): readonly Handle[] {
    return [
      {
        id: "dot",
        label: this.#now.dot,
        anywhere: true,
        place: (plane) => this.#pixels(plane),
        drag: (plane, x, y) => this.#drag(plane, x, y),
        nudge: (right, down) => this.#nudge(right, down),
      },
    ];
  }

  #open(): void {
    const loop = this.#lap ? null : walkLoop(this.#body, LEGS, AROUND);
    if (!loop) return;
    [this.#lap, this.#projection, this.#seen] = [loop.lap, loop.projection, loop.seen];
    attempt(this.#body, this.#measureLoop());
    this.changed();
  }

  async #measureLoop(): Promise<void> {
    const { engine } = this.#body.engine;
    if (!engine || !this.#lap) return;
    this.#onLoop = Math.max(...(await engine.poseVariance(LEGS, this.#lap.path)));
    this.changed();
  }

  async #ask(point: Place) {
    const { engine } = this.#body.engine;
    const { learned } = this.#body.model;
    if (!engine || !learned || !this.#projection || !this.#lap) throw new Error("There is no model yet.");
    const row = nearestRow(this.#seen, ...point);
    const onLoop = this.#isOnLoop;
    const q = this.#projection.dimensions;
    const legs = onLoop
      ? this.#lap.path.slice(row * q, (row + 1) * q)
      : lift(this.#projection, this.#seen, ...point);
    // The arms keep to the time of the nearest point of the loop.
    const frame = this.#lap.first + row;
    const others = learned.latents.slice(1).flatMap((path) => {
      const width = path.length / learned.request.frames;
      return [...path.slice(frame * width, (frame + 1) * width)];
    });
    const [positions, shares] = await Promise.all([
      engine.bodyPose(Float64Array.of(...legs, ...others)),
      engine.poseVariance(LEGS, legs),
    ]);
    return { positions, share: shares[0]!, point };
  }

  #take(positions: Float32Array, share: number): void {
    if (this.#walks) return;
    this.#known = { share, onLoop: this.#onLoop };
    const opacity = this.#isOnLoop ? 1 : Math.max(0.03, strengthOf(share));
    this.#pose.show(positions, { part: LEGS, opacity });
    this.changed();
  }

  #pixels(plane: Plane): [number, number] {
    const { centre, axes, dimensions: q } = this.#projection!;
    const [right, up] = this.#place;
    const point = Float64Array.from(
      { length: q },
      (_, a) => centre[a]! + right * axes[a]! + up * axes[q + a]!,
    );
    const [x, y] = plane.place(point, 0);
    return [x, y];
  }

  #stop(): void {
    this.#walks = false;
    this.#leaving = null;
  }

  #drag(plane: Plane, x: number, y: number): void {
    this.#stop();
    this.#moveTo(axesAt(plane, this.#projection!, x, y), this.#snap(plane));
  }

  /** The distance within which the dot stays on the loop. Before the guess it never leaves. */
  #snap(plane: Plane): number {
    return this.#guessed ? Math.hypot(...plane.latentStep(SNAP, 0)) : Infinity;
  }

  #moveTo(place: Place, snap: number): void {
    const row = nearestRow(this.#seen, ...place);
    const on: Place = [this.#seen[3 * row]!, this.#seen[3 * row + 1]!];
    this.#frame = row;
    this.#place = Math.hypot(place[0] - on[0], place[1] - on[1]) <= snap ? on : place;
    this.#poses.request(this.#place);
    this.changed();
  }

  #nudge(right: number, down: number): void {
    this.#stop();
    const rows = this.#seen.length / 3;
    if (right !== 0) {
      this.#frame = (this.#frame + right + rows) % rows;
      this.#moveTo([this.#seen[3 * this.#frame]!, this.#seen[3 * this.#frame + 1]!], Infinity);
    } else if (this.#guessed) {
      // Up leads outwards.
      const [u, v] = this.#place;
      const radius = Math.hypot(u, v) || 1;
      const factor = Math.max(0.05, 1 - (down * STEP * this.#radius()) / radius);
      const row = this.#frame;
      this.#moveTo([u * factor, v * factor], 0.5 * STEP * this.#radius());
      this.#frame = row;
    }
  }

  #radius(): number {
    const [right, up] = this.#projection?.flat ?? [1, 1];
    return (right + up) / (2 * AROUND);
  }

  tick(seconds: number): void {
    if (this.#leaving !== null) {
      this.#leaving = Math.min(1, this.#leaving + seconds / SECONDS);
      const [u, v] = [this.#seen[3 * this.#frame]!, this.#seen[3 * this.#frame + 1]!];
      const factor = 1 + (AWAY - 1) * this.#leaving * this.#leaving * (3 - 2 * this.#leaving);
      this.#place = [factor * u, factor * v];
      if (this.#leaving >= 1) this.#leaving = null;
      this.#poses.request(this.#place);
      this.changed();
      return;
    }
    const rows = this.#seen.length / 3;
    if (!this.#walks || !this.#lap || rows === 0) return;
    const { frame } = this.#body.playback;
    const row = (((frame - this.#lap.first) % rows) + rows) % rows;
    this.#frame = Math.floor(row) % rows;
    const after = (this.#frame + 1) % rows;
    const share = row - Math.floor(row);
    const at = (axis: number) =>
      (1 - share) * this.#seen[3 * this.#frame + axis]! + share * this.#seen[3 * after + axis]!;
    this.#place = [at(0), at(1)];
  }

  paint(draw: CanvasRenderingContext2D, plane: Plane, { width, height }: { width: number; height: number }) {
    const { ink } = theme();
    const colour = partColourNow(LEGS);
    if (this.#guessed) {
      attempt(this.#body, this.#askMap(plane, width, height, colour));
      if (this.#map) drawCertainty(draw, this.#map.picture, this.#map.cells);
    }
    const rows = this.#seen.length / 3;
    draw.strokeStyle = colour;
    draw.lineWidth = 4;
    draw.beginPath();
    for (let t = 0; t < rows; t++) draw.lineTo(...this.#row(plane, t));
    draw.closePath();
    draw.stroke();
    const [x, y] = this.#pixels(plane);
    draw.globalAlpha = 0.2;
    draw.fillStyle = colour;
    draw.beginPath();
    draw.arc(x, y, 22, 0, 2 * Math.PI);
    draw.fill();
    draw.globalAlpha = 1;
    draw.beginPath();
    draw.arc(x, y, 11, 0, 2 * Math.PI);
    draw.fill();
    draw.lineWidth = 3;
    draw.strokeStyle = theme().ground;
    draw.stroke();
    draw.strokeStyle = ink;
  }

  #row(plane: Plane, row: number): [number, number] {
    const q = this.#projection!.dimensions;
    const [x, y] = plane.place(this.#lap!.path, row);
    return q > 0 ? [x, y] : [0, 0];
  }

  async #askMap(plane: Plane, width: number, height: number, colour: string): Promise<void> {
    const key = `${width} ${height} ${colour}`;
    const { engine } = this.#body.engine;
    const projection = this.#projection;
    if (this.#mapAsked === key || !engine || !projection) return;
    this.#mapAsked = key;
    const cells = cellsOf(width, height);
    const points = cellPoints(cells, (x, y) =>
      lift(projection, this.#seen, ...axesAt(plane, projection, x, y)),
    );
    const shares = await engine.poseVariance(LEGS, points);
    const picture = certaintyPicture(cells, shares, channels(colour));
    if (!picture || this.#mapAsked !== key) return;
    this.#map = { picture, cells, colour };
    this.changed();
  }

  stage() {
    const { stage, playback, model } = this.#body;
    const info = model.model?.info;
    const columns = info ? columnsOf(info.columns, info.joints, info.parts[LEGS]!.joints) : 0;
    return html`
      <div class="story-pair">
        <pg-latent-space .scene=${this} .label=${this.#now.plane}></pg-latent-space>
        <pg-stage .stage=${stage} .playback=${playback} .running=${true} .label=${this.#words.now.chapters.arms.figure}></pg-stage>
        ${info ? html`<p class="story-pair-note" data-testid="sizes">${this.#now.sizes(columns, info.parts[LEGS]!.latent)}</p>` : nothing}
      </div>`;
  }

  guess() {
    return this.#guessed ? null : this.#now.guess;
  }

  guessed(): void {
    this.#guessed = true;
    this.#walks = false;
    this.#pause();
    this.#leaving = prefersReducedMotion() ? 0.999 : 0;
    this.changed();
  }

  control() {
    const { walk, hint, hintOff } = this.#now;
    return html`<div class="story-row">
      ${this.#walks ? nothing : html`<button class="story-button" data-testid="walk-on" @click=${() => this.#walkOn()}>${walk}</button>`}
      <p class="story-hint">${this.#guessed ? hintOff : hint}</p></div>`;
  }

  #pause(): void {
    if (this.#body.playback.playing) this.#body.playback.togglePlay();
  }

  #walkOn(): void {
    this.#stop();
    this.#walks = true;
    this.#pose.end();
    this.#body.playback.play();
    this.changed();
  }

  reveal() {
    if (!this.#guessed || !this.#known || this.#leaving !== null) return null;
    const { share, onLoop } = this.#known;
    const percent = (value: number) => percentOf(Math.sqrt(value));
    return html`<p data-testid="certainty">${
      this.#isOnLoop ? this.#now.onLoop(percent(onLoop)) : this.#now.offLoop(percent(share), percent(onLoop))
    }</p>`;
  }

  equation() {
    return equation("pose", this.#now.equation);
  }

  lab() {
    return { tab: "loops" as const };
  }

  arrive(): void {
    void this.#body.showFirstMotion();
    this.#body.start().catch(() => {});
    this.#walkOn();
    if (prefersReducedMotion()) {
      this.#walks = false;
      this.#pause();
      if (this.#lap) this.#moveTo([this.#seen[0]!, this.#seen[1]!], Infinity);
    }
  }

  leave(): void {
    this.#stop();
    [this.#guessed, this.#known] = [false, null];
    this.#poses.drop();
    this.#pose.end();
  }
}

/** A share in percent, with a digit after the point below ten. */
export function percentOf(share: number): string {
  const percent = 100 * share;
  return percent < 10 ? percent.toFixed(1) : percent.toFixed(0);
}

/** The number of columns that belong to these joints. */
export function columnsOf(
  columns: readonly string[],
  joints: readonly { name: string }[],
  part: readonly number[],
): number {
  const names = new Set(part.map((joint) => joints[joint]!.name));
  return columns.filter((column) => names.has(column.slice(0, column.lastIndexOf(".")))).length;
}
