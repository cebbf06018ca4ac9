// A few poses are enough: inducing points of the legs are taken away until the walk stumbles.
import { html, nothing, svg, type TemplateResult } from "lit";
import { Latest } from "../../engine/latest";
import { OpenDocument } from "../../engine/open-document";
import type { Measures, RolloutRequest } from "../../engine/protocol";
import type { WholeCalls, WholeWorkers } from "../../engine/whole-workers";
import type { Plane } from "../../latents/plane";
import type { Projection } from "../../latents/projection";
import { arrowHead } from "../../latents/shapes";
import { grouped } from "../../ui/format";
import { partColourNow, theme } from "../../ui/palette";
import type { WordsStore } from "../../words/words";
import type { StoryBody } from "../../app/story-body";
import type { Chapter } from "../chapter";
import { attempt, LatentChapter } from "../latent/latent-chapter";
import { strokeLoop, strokePath } from "../latent/drawing";
import type { Handle } from "../latent/latent-view";
import "../latent/latent-view";
import {
  allPoints,
  bestChoice,
  choices,
  count,
  keptOf,
  LEGS,
  type LegPoints,
  type PointKind,
  toggled,
  type Trial,
} from "./elimination";
import { stumbles, walkError } from "./walk-error";
import type { App } from "../../app/app";
import "../../stage/stage-view";

const WIDTH = 420;
const HEIGHT = 84;
const EDGE = 6;

/** The labels of the two lines. */
interface ChartWords {
  bound: string;
  error: string;
  label: string;
  guess: string;
}

/** `guessed`: the number of points that the visitor has said. */
function pointsChart(
  trials: readonly Trial[],
  now: Trial,
  guessed: number,
  words: ChartWords,
): TemplateResult {
  const most = trials[0]?.count ?? now.count;
  const finite = trials.filter(({ error }) => Number.isFinite(error));
  const worst = Math.max(0.01, ...finite.map(({ error }) => error));
  const bounds = trials.map(({ bound }) => bound);
  const [low, high] = [Math.min(...bounds, now.bound), Math.max(...bounds, now.bound)];
  const x = (count: number) => EDGE + ((most - count) / Math.max(1, most - 2)) * (WIDTH - 2 * EDGE);
  const y = (share: number) => HEIGHT - EDGE - share * (HEIGHT - 2 * EDGE);
  const error = (trial: Trial) =>
    y(Math.min(1, (Number.isFinite(trial.error) ? trial.error : worst) / worst));
  const bound = (trial: Trial) => y((trial.bound - low) / Math.max(1e-9, high - low));
  const line = (height: (trial: Trial) => number) =>
    trials.map((trial) => `${x(trial.count).toFixed(1)},${height(trial).toFixed(1)}`).join(" ");
  const marks = trials
    .filter((trial) => trial.stumbles)
    .map((trial) => svg`<circle class="stumble" cx=${x(trial.count)} cy=${error(trial)} r="3.2" />`);
  return html`
    <figure class="points-chart passive">
      <svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label=${words.label}>
        <polyline class="bound" points=${line(bound)} />
        <polyline class="error" points=${line(error)} />
        ${marks}
        <path class="guess" d="M${x(guessed)} ${HEIGHT - 9}l-5 9h10z" data-testid="guessed-points" />
        <line class="now" x1=${x(now.count)} x2=${x(now.count)} y1="0" y2=${HEIGHT} />
      </svg>
      <figcaption class="note"><span class="bound">${words.bound}</span> <span class="error">${words.error}</span> <span>▴ ${words.guess}</span></figcaption>
    </figure>`;
}

/** The plot shows this many times the width of the loop. */
const AROUND = 1.6;
const FRAMES = 240;
/** "Ten or fewer" */
const FEW = 10;
/** Milliseconds between two points that the program takes away. */
const PAUSE = 250;
/** The numbers of points that are shown side by side: the fewest that walk, and fewer. */
const PAIR = [12, 10] as const;

export class PointsChapter extends LatentChapter<"points"> {
  #points: LegPoints = { poses: [], steps: [] };
  /** The trial with all points. */
  #full: Trial | null = null;
  #now: Trial | null = null;
  /** The program's trials, from all points to two. */
  #trials: Trial[] = [];
  /** The fewest points with which the visitor's walk went on. */
  #fewest: number | null = null;
  #running = 0;
  readonly #asked: Latest<LegPoints, Trial>;
  readonly #document: OpenDocument<WholeCalls, void>;
  #modelText: Promise<string> | null = null;

  constructor(words: WordsStore, body: StoryBody, { desk }: Pick<WholeWorkers, "desk">) {
    super(words, "points", body);
    this.#document = new OpenDocument(desk, (worker, text) => worker.openOutlook(text));
    this.#asked = new Latest(
      (points) => this.#try(points),
      (trial) => this.#take(trial),
      (problem) => attempt(body, Promise.reject(problem)),
    );
    this.awaitLoop(LEGS, AROUND);
  }

  get projection(): Projection | null {
    return this.#full && (this.loop?.projection ?? null);
  }

  get moves(): boolean {
    return false;
  }

  /** The program's trials so far. */
  get trials(): readonly Trial[] {
    return this.#trials;
  }

  /** Whether the program is taking points away. */
  get isRunning(): boolean {
    return this.#running > 0;
  }

  get handles(): readonly Handle[] {
    const { model } = this.body.model;
    if (!model || !this.hasGuessed) return [];
    const all = allPoints(model.info);
    const handle = (kind: PointKind, index: number): Handle => ({
      id: `${kind}-${index}`,
      label: this.words.point[kind](index + 1),
      pressed: this.#points[kind].includes(index),
      place: (plane) => this.#place(plane, kind, index),
      press: () => this.#toggle(kind, index),
    });
    return [
      ...all.steps.map((index) => handle("steps", index)),
      ...all.poses.map((index) => handle("poses", index)),
    ];
  }

  /** The place of a point: of a step its prediction. */
  #place(plane: Plane, kind: PointKind, index: number): [number, number] {
    const view = this.body.model.model!;
    const points = kind === "poses" ? view.poseInducing[LEGS]! : view.dynamicsInducing[LEGS]![LEGS]!.outputs;
    const [x, y] = plane.place(points, index);
    return plane.inFrame(x, y);
  }

  protected async begin(): Promise<void> {
    const { model } = this.body.model;
    if (!model) return;
    this.#points = allPoints(model.info);
    this.#full = await this.#try(this.#points);
    this.#now = this.#full;
    this.changed();
  }

  #request(): RolloutRequest {
    return { frames: FRAMES, sequence: 0, alpha: null, reading: "as-learned" };
  }

  /** Asks a worker of the whole program, which has the model open. */
  async #ask<Answer>(call: (worker: WholeCalls) => Promise<Answer>): Promise<Answer> {
    const { engine } = this.body.engine;
    if (!engine) throw new Error("There is no model yet.");
    this.#modelText ??= engine.modelJson();
    return this.#document.ask(await this.#modelText, call);
  }

  async #try(points: LegPoints): Promise<Trial> {
    const { model, learned } = this.body.model;
    if (!model || !learned || !this.loop) throw new Error("There is no model yet.");
    const kept = keptOf(model.info, points);
    const report = await this.#ask((worker) => worker.keptRollout(kept, this.#request()));
    const error = walkError(report.motion, learned.motion, this.loop.lap);
    const walk: Measures = this.#full?.report.measures ?? report.measures;
    return {
      points,
      count: count(points),
      bound: report.bound,
      error,
      stumbles: stumbles({ ...report, error }, walk, LEGS),
      report,
    };
  }

  #take(trial: Trial): void {
    this.#now = trial;
    if (!trial.stumbles) this.#fewest = Math.min(this.#fewest ?? Infinity, trial.count);
    this.body.stage.setColumns(null);
    if (this.isHere) this.pose.play(trial.report.motion);
    this.changed();
  }

  #toggle(kind: PointKind, index: number): void {
    const next = this.isRunning ? null : toggled(this.#points, kind, index);
    if (next) this.#set(next);
  }

  #set(points: LegPoints): void {
    this.#points = points;
    this.#asked.request(points);
    this.changed();
  }

  override guess() {
    if (this.hasGuessed || !this.#full) return null;
    const { poses, steps } = this.#full.points;
    const { question, choices } = this.words.guess;
    return { question: question(poses.length, steps.length), choices };
  }

  override guessed(choice: string): void {
    super.guessed(choice);
    attempt(this.body, this.#eliminate());
  }

  /** Takes away point after point, always the one whose loss costs the bound least. */
  async #eliminate(): Promise<void> {
    const { model } = this.body.model;
    if (!model || !this.#full) return;
    this.#running += 1;
    const running = this.#running;
    let points = allPoints(model.info);
    this.#trials = [this.#full];
    this.changed();
    while (count(points) > 2) {
      const all = choices(points);
      const kept = all.map((choice) => keptOf(model.info, choice));
      const bounds = await this.#ask((worker) => worker.keptBounds(kept));
      points = bestChoice(all, bounds);
      const trial = await this.#try(points);
      await new Promise((resolve) => setTimeout(resolve, PAUSE));
      // The visitor may have left or stopped it.
      if (running !== this.#running || !this.isHere) return;
      this.#points = points;
      this.#now = trial;
      this.#trials = [...this.#trials, trial];
      if (!trial.stumbles || this.#trials.at(-2)?.stumbles === false) this.pose.play(trial.report.motion);
      this.changed();
    }
    this.#running = 0;
    const enough = this.#enough;
    if (enough) this.#set(enough.points);
  }

  /** The trial with the fewest points before the first stumble. */
  get #enough(): Trial | null {
    const first = this.#trials.findIndex((trial) => trial.stumbles);
    return this.#trials.at(first === -1 ? -1 : first - 1) ?? null;
  }

  paint(draw: CanvasRenderingContext2D, plane: Plane): void {
    const { lap, projection } = this.loop!;
    const { ink } = theme();
    const view = this.body.model.model!;
    const colour = partColourNow(LEGS);
    draw.strokeStyle = colour;
    draw.globalAlpha = 0.3;
    draw.lineWidth = 3;
    strokeLoop(draw, plane, lap);
    const path = this.#now?.report.latents[LEGS];
    if (path) {
      draw.globalAlpha = 0.8;
      draw.lineWidth = 1.5;
      const frames = path.length / projection.dimensions;
      strokePath(draw, plane, path, Math.floor(frames / 2), frames - 1);
    }
    const { inputs, outputs } = view.dynamicsInducing[LEGS]![LEGS]!;
    const { order } = view.info;
    const all = allPoints(view.info);
    draw.strokeStyle = draw.fillStyle = ink;
    for (const index of all.steps) {
      draw.globalAlpha = this.#points.steps.includes(index) ? 1 : 0.16;
      draw.lineWidth = 2;
      const from = plane.placeInHistory(inputs, order, index, order - 1);
      const to = plane.place(outputs, index);
      draw.beginPath();
      draw.moveTo(from[0], from[1]);
      draw.lineTo(to[0], to[1]);
      draw.stroke();
      arrowHead(draw, [...from], [...to], 9);
    }
    for (const index of all.poses) {
      draw.globalAlpha = this.#points.poses.includes(index) ? 1 : 0.16;
      const [x, y] = this.#place(plane, "poses", index);
      draw.fillStyle = colour;
      draw.beginPath();
      draw.moveTo(x, y - 8);
      draw.lineTo(x + 8, y);
      draw.lineTo(x, y + 8);
      draw.lineTo(x - 8, y);
      draw.closePath();
      draw.fill();
    }
  }

  stage() {
    return this.pair(
      this.words.plane,
      html`<p class="story-pair-note passive quiet">${this.words.legend} ${this.#state()}</p>
        ${this.#trials.length > 1 && this.#now ? pointsChart(this.#trials, this.#now, this.#guessed, this.words.chart) : ""}`,
    );
  }

  /** The number of points that the visitor has said. */
  get #guessed(): number {
    const all = this.#trials[0]?.count ?? 0;
    return { most: 0.9 * all, half: 0.5 * all }[this.choice ?? ""] ?? FEW;
  }

  /** Bound and error of the walk with the points now. */
  #state() {
    const trial = this.#now;
    if (!this.hasGuessed || !trial || !this.#full) return nothing;
    const { found, walks, stumbled } = this.words;
    const error = Number.isFinite(trial.error) ? (100 * trial.error).toFixed(1) : "∞";
    const sentence = found(trial.count, grouped(this.#full.bound - trial.bound), error);
    return html`<span data-testid="trial">${sentence} ${trial.stumbles ? stumbled : walks}</span>`;
  }

  control() {
    const { all, pair, hint, waiting, removing } = this.words;
    if (!this.#full) return html`<p class="story-hint quiet" role="status">${waiting}</p>`;
    if (!this.hasGuessed) return null;
    if (this.isRunning) return html`<p class="story-hint quiet" role="status">${removing}</p>`;
    return html`<div class="story-row">
      <button class="story-button" data-testid="all-points" @click=${() => this.#all()}>${all}</button>
      <button class="story-button" data-testid="pair" @click=${() => this.#showPair()}>${pair(...PAIR)}</button>
      <p class="story-hint quiet">${hint(this.#fewest)}</p></div>`;
  }

  #all(): void {
    const { model } = this.body.model;
    if (model) this.#set(allPoints(model.info));
  }

  #showPair(): void {
    const trials = PAIR.map((points) => this.#trials.find((trial) => trial.count === points));
    this.body.stage.setColumns(
      trials.flatMap((trial) =>
        trial ? [{ title: this.words.column(trial.count), motion: trial.report.motion }] : [],
      ),
    );
  }

  reveal() {
    const enough = this.#enough;
    if (!this.hasGuessed || this.isRunning || !enough || !this.#full) return null;
    const { enough: sentence } = this.words;
    return html`<p data-testid="enough">${sentence(enough.count, this.#full.count, (100 * enough.error).toFixed(1))}</p>`;
  }

  equation() {
    return this.equations(["posterior"], this.words.equation);
  }

  override leave(): void {
    this.#running = 0;
    this.#asked.drop();
    [this.#trials, this.#fewest, this.#now] = [[], null, this.#full];
    if (this.#full) this.#points = this.#full.points;
    this.body.stage.setColumns(null);
    super.leave();
  }
}

export async function openChapter(app: App): Promise<Chapter> {
  return new PointsChapter(app.words, app.story, app.workers);
}
