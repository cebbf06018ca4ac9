// A walk is a loop: the legs' path through their latent space, and the poses of its points.
import { html, nothing } from "lit";
import { Latest } from "../../engine/latest";
import type { Plane } from "../../latents/plane";
import type { Projection } from "../../latents/projection";
import { fillDot } from "../../latents/shapes";
import { partColourNow, theme } from "../../ui/palette";
import { prefersReducedMotion } from "../../ui/browser";
import type { WordsStore } from "../../words/words";
import type { StoryBody } from "../../app/story-body";
import type { Chapter } from "../chapter";
import { attempt, LatentChapter } from "../latent/latent-chapter";
import {
  type Cells,
  cellPoints,
  cellsOf,
  certaintyPicture,
  channels,
  drawCertainty,
  strengthOf,
} from "../latent/certainty-map";
import { strokeLoop, axesAt, type Place, pixelsAt, lift, nearestRow } from "../latent/drawing";
import type { Handle } from "../latent/latent-view";
import "../latent/latent-view";
import type { App } from "../../app/app";
import "../../stage/stage-view";

const LEGS = 0;
const NOTHING = new Float64Array(0);
/** The plot shows this many times the width of the loop. */
const AROUND = 1.75;
/** Pixels within which the dot stays on the loop. */
const SNAP = 16;
/** Distance of the dot from the middle after the guess, in radii of the loop, and seconds on the way. */
const AWAY = 1.9;
const SECONDS = 1.6;
/** The step of an arrow key off the loop, in radii of the loop. */
const STEP = 0.12;

interface Known {
  /** The share of the prior variance at the dot. */
  share: number;
  /** The largest share on the loop. */
  onLoop: number;
}

export class LoopChapter extends LatentChapter<"loop"> {
  #place: Place = [0, 0];
  #walks = true;
  #frame = 0;
  /** Seconds since the guess, while the dot leaves the loop by itself. */
  #leaving: number | null = null;
  #known: Known | null = null;
  #onLoop = 0;
  #map: { picture: HTMLCanvasElement; cells: Cells; colour: string } | null = null;
  #mapAsked = "";
  readonly #poses: Latest<Place, { positions: Float32Array; share: number }>;

  constructor(words: WordsStore, body: StoryBody) {
    super(words, "loop", body);
    this.#poses = new Latest(
      (place) => this.#ask(place),
      ({ positions, share }) => this.#take(positions, share),
      (problem) => attempt(body, Promise.reject(problem)),
    );
    this.awaitLoop(LEGS, AROUND);
  }

  get projection(): Projection | null {
    return this.loop?.projection ?? null;
  }

  get #seen(): Float64Array {
    return this.loop?.seen ?? NOTHING;
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
        label: this.words.dot,
        anywhere: true,
        place: (plane) => pixelsAt(plane, this.loop!.projection, this.#place),
        drag: (plane, x, y) => this.#drag(plane, x, y),
        nudge: (right, down) => this.#nudge(right, down),
      },
    ];
  }

  /** Measures the doubt on the loop. */
  protected async begin(): Promise<void> {
    this.changed();
    const { engine } = this.body.engine;
    if (!engine || !this.loop) return;
    this.#onLoop = Math.max(...(await engine.poseVariance(LEGS, this.loop.lap.path)));
    this.changed();
  }

  async #ask(point: Place) {
    const { engine } = this.body.engine;
    const { learned } = this.body.model;
    if (!engine || !learned || !this.loop) throw new Error("There is no model yet.");
    const { lap, projection, seen } = this.loop;
    const row = nearestRow(seen, ...point);
    const q = projection.dimensions;
    const legs = this.#isOnLoop ? lap.path.slice(row * q, (row + 1) * q) : lift(projection, seen, ...point);
    // The arms keep to the time of the nearest point of the loop.
    const frame = lap.first + row;
    const others = learned.latents.slice(1).flatMap((path) => {
      const width = path.length / learned.request.frames;
      return [...path.slice(frame * width, (frame + 1) * width)];
    });
    const [positions, shares] = await Promise.all([
      engine.bodyPose(Float64Array.of(...legs, ...others)),
      engine.poseVariance(LEGS, legs),
    ]);
    return { positions, share: shares[0]! };
  }

  #take(positions: Float32Array, share: number): void {
    if (this.#walks) return;
    this.#known = { share, onLoop: this.#onLoop };
    const opacity = this.#isOnLoop ? 1 : Math.max(0.03, strengthOf(share));
    this.pose.show(positions, { part: LEGS, opacity });
    this.changed();
  }

  #stop(): void {
    this.#walks = false;
    this.#leaving = null;
  }

  #drag(plane: Plane, x: number, y: number): void {
    this.#stop();
    this.#moveTo(axesAt(plane, this.loop!.projection, x, y), this.#snap(plane));
  }

  /** The distance within which the dot stays on the loop. Before the guess it never leaves. */
  #snap(plane: Plane): number {
    return this.hasGuessed ? Math.hypot(...plane.latentStep(SNAP, 0)) : Infinity;
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
    } else if (this.hasGuessed) {
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
    const [right, up] = this.projection?.flat ?? [1, 1];
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
    if (!this.#walks || !this.loop) return;
    const { frame } = this.body.playback;
    const row = (((frame - this.loop.lap.first) % rows) + rows) % rows;
    this.#frame = Math.floor(row) % rows;
    const after = (this.#frame + 1) % rows;
    const share = row - Math.floor(row);
    const at = (axis: number) =>
      (1 - share) * this.#seen[3 * this.#frame + axis]! + share * this.#seen[3 * after + axis]!;
    this.#place = [at(0), at(1)];
  }

  paint(draw: CanvasRenderingContext2D, plane: Plane, { width, height }: { width: number; height: number }) {
    const colour = partColourNow(LEGS);
    if (this.hasGuessed) {
      attempt(this.body, this.#askMap(plane, width, height, colour));
      if (this.#map) drawCertainty(draw, this.#map.picture, this.#map.cells);
    }
    draw.strokeStyle = colour;
    draw.lineWidth = 4;
    strokeLoop(draw, plane, this.loop!.lap);
    const [x, y] = pixelsAt(plane, this.loop!.projection, this.#place);
    draw.globalAlpha = 0.2;
    draw.fillStyle = colour;
    fillDot(draw, x, y, 22);
    draw.globalAlpha = 1;
    fillDot(draw, x, y, 11);
    draw.lineWidth = 3;
    draw.strokeStyle = theme().ground;
    draw.stroke();
  }

  async #askMap(plane: Plane, width: number, height: number, colour: string): Promise<void> {
    const key = `${width} ${height} ${colour}`;
    const { engine } = this.body.engine;
    const { projection } = this;
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
    const info = this.body.model.model?.info;
    if (!info) return this.pair(this.words.plane);
    const { joints, latent } = info.parts[LEGS]!;
    const columns = columnsOf(info.columns, info.joints, joints);
    return this.pair(
      this.words.plane,
      html`<p class="story-pair-note passive quiet" data-testid="sizes">${this.words.sizes(columns, latent)}</p>`,
    );
  }

  override guessed(choice: string): void {
    this.choice = choice;
    this.#walks = false;
    this.#pause();
    this.#leaving = prefersReducedMotion() ? 0.999 : 0;
    this.changed();
  }

  control() {
    const { walk, hint, hintOff } = this.words;
    return html`<div class="story-row">
      ${this.#walks ? nothing : html`<button class="story-button" data-testid="walk-on" @click=${() => this.#walkOn()}>${walk}</button>`}
      <p class="story-hint quiet">${this.hasGuessed ? hintOff : hint}</p></div>`;
  }

  #pause(): void {
    if (this.body.playback.playing) this.body.playback.togglePlay();
  }

  #walkOn(): void {
    this.#stop();
    this.#walks = true;
    this.pose.end();
    this.body.playback.play();
    this.changed();
  }

  reveal() {
    if (!this.hasGuessed || !this.#known || this.#leaving !== null) return null;
    const { share, onLoop } = this.#known;
    const percent = (value: number) => percentOf(Math.sqrt(value));
    return html`<p data-testid="certainty">${
      this.#isOnLoop
        ? this.words.onLoop(percent(onLoop))
        : this.words.offLoop(percent(share), percent(onLoop))
    }</p>`;
  }

  equation() {
    return this.equations(["pose"], this.words.equation);
  }

  override arrive(): void {
    super.arrive();
    this.#walkOn();
    if (prefersReducedMotion()) {
      this.#walks = false;
      this.#pause();
      if (this.loop) this.#moveTo([this.#seen[0]!, this.#seen[1]!], Infinity);
    }
  }

  override leave(): void {
    this.#stop();
    this.#known = null;
    this.#poses.drop();
    super.leave();
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

export async function openChapter(app: App): Promise<Chapter> {
  return new LoopChapter(app.words, app.story);
}
