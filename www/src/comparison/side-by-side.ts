// Predictions of one trial side by side, with one clock: the choice of the trial and of the models, and the
// controls of the clock.
import { html, nothing } from "lit";
import { plain } from "../figures/numbers";
import { type ColumnMotion, Columns } from "../scene/columns";
import { distances } from "../scene/motion";
import { Player } from "../stage/player";
import type { StagedModel } from "../stage/stage-store";
import { eachFrame, prefersReducedMotion } from "../ui/browser";
import { icon } from "../ui/icons";
import { View } from "../ui/view";
import type { ReadonlyEntry, Positions, PredictedMotion } from "./comparison-entry";
import type { ComparisonStore } from "./comparison-store";
import type { Distances, DistanceFigure } from "./distance";
import "./distance";
import { modelStyle } from "../figures/model-style";
import { styled } from "../ui/styled";
import { compareWords } from "./view-words";
import { lab } from "../words/lab";
import "../stage/stage-canvas.css";
import type { FinishedJob, Job, ModelSummary } from "../engine/whole-protocol";
import type { Motion } from "../engine/protocol";

/** More columns would be too narrow to see. */
const MOST_COLUMNS = 4;

/** A model's prediction of a trial. */
interface Prediction {
  /** The key of the model with its settings and seed, the same for all held-out trials. */
  key: string;
  finished: FinishedJob;
  predicted: PredictedMotion;
  /** The differences from other models of its kind; may be empty. */
  label: string;
}

// The program writes equal candidates as equal texts.
const textOf = (candidate: ModelSummary["candidate"]): string => JSON.stringify(candidate);

function labelOf(
  { candidate, seed }: Job,
  finished: readonly FinishedJob[],
  models: readonly ModelSummary[],
): string {
  const label = models.find((summary) => textOf(summary.candidate) === textOf(candidate))?.label ?? "";
  const alike = finished.filter(({ job }) => job.candidate.model === candidate.model);
  const severalSeeds = new Set(alike.map(({ job }) => job.seed)).size > 1;
  return [label, severalSeeds ? lab().learn.bound.seed(seed) : ""].filter(Boolean).join(", ");
}

/** The trials with predictions. */
export function foldsOf({ results, predictions }: ReadonlyEntry): number[] {
  const known = results.finished.filter(({ id }) => predictions.has(id));
  return [...new Set(known.map(({ job }) => job.heldOut))].sort((a, b) => a - b);
}

/** The predictions of a trial by models trained on all other trials, in the order of the tables. */
export function predictionsOf({ results, predictions }: ReadonlyEntry, fold: number): Prediction[] {
  const { finished, comparison } = results;
  return finished.flatMap((entry) => {
    const { id, job } = entry;
    const predicted = predictions.get(id);
    if (job.heldOut !== fold || !predicted) return [];
    const key = `${textOf(job.candidate)} ${job.seed}`;
    return [{ key, finished: entry, predicted, label: labelOf(job, finished, comparison.models) }];
  });
}

/** The predictions that the visitor has chosen, or else the first of each kind of model. */
export function chosenOf(predictions: readonly Prediction[], picked: readonly string[] | null): Prediction[] {
  const chosen = picked?.flatMap((key) => predictions.filter((prediction) => prediction.key === key)) ?? [];
  if (chosen.length > 0) return chosen.slice(0, MOST_COLUMNS);
  const kinds = new Map<string, Prediction>();
  for (const prediction of predictions) {
    const { model } = prediction.finished.job.candidate;
    if (!kinds.has(model)) kinds.set(model, prediction);
  }
  return [...kinds.values()].slice(0, MOST_COLUMNS);
}

/** The keys after one was added or removed; unchanged when that would leave none or too many. */
export function toggled(keys: readonly string[], key: string): readonly string[] {
  const next = keys.includes(key) ? keys.filter((other) => other !== key) : [...keys, key];
  return next.length >= 1 && next.length <= MOST_COLUMNS ? next : keys;
}

const motionOf = ({ positions, frameTime }: Positions, nodes: number): Motion => ({
  positions,
  nodes,
  frameTime,
  frames: positions.length / (3 * nodes),
});

const modelOf = ({ finished }: Prediction) => finished.job.candidate.model;

const nameOf = (prediction: Prediction) =>
  [modelStyle(modelOf(prediction)).name, prediction.label].filter(Boolean).join(", ");

export class SideBySide extends View {
  declare comparison: ComparisonStore;
  /** The frame in the controls, and the time of the last drawing of the columns. */
  #frame = 0;
  #drawnAt = -1;
  readonly #player = new Player();
  #columns: Columns | null = null;
  #problem = "";
  /** The comparison, the trial and the models in the columns now. */
  #loaded: { entry: ReadonlyEntry | null; words: string } = { entry: null, words: "" };
  #distances: Distances | null = null;

  protected override arrived(): void {
    this.#player.playing = this.comparison.look.playing ?? !prefersReducedMotion();
    this.whenLeaving(eachFrame((seconds) => this.#tick(seconds)));
    this.whenLeaving(() => this.#leaveCanvas());
    this.requestUpdate();
  }

  #leaveCanvas(): void {
    this.#columns?.dispose();
    this.#columns = null;
    this.#loaded = { entry: null, words: "" };
  }

  togglePlay(): void {
    if (this.#player.playing) this.#player.pause();
    else this.#player.play();
    this.#remember();
  }

  step(direction: 1 | -1): void {
    this.#player.step(direction);
    this.#showFrame();
    this.#remember();
  }

  #scrub(event: Event): void {
    this.#player.pause();
    this.#player.scrub(Number((event.target as HTMLInputElement).value));
    this.#showFrame();
    this.#remember();
  }

  /** The view plays again if it played when it was left. */
  #remember(): void {
    this.comparison.lookAt({ playing: this.#player.playing });
  }

  #tick(seconds: number): void {
    this.#player.advance(seconds);
    const { frame, playing } = this.#player;
    const changed = frame !== this.#drawnAt;
    this.#drawnAt = frame;
    if (this.#wholeFrame() !== this.#frame) this.#showFrame();
    this.#columns?.draw(frame, changed, seconds, playing);
  }

  #wholeFrame(): number {
    return Math.floor(this.#player.frame + 1e-6);
  }

  /** Moves only the elements that follow the clock. */
  #showFrame(): void {
    this.#frame = this.#wholeFrame();
    const [range, clock] = [
      this.querySelector<HTMLInputElement>(".scrub input"),
      this.querySelector(".clock b"),
    ];
    if (!range || !clock) return;
    range.value = String(this.#frame);
    range.setAttribute("aria-valuetext", this.#frameWords());
    clock.textContent = String(this.#frame + 1);
    this.querySelector<DistanceFigure>("comparison-distance")?.at(this.#frame);
  }

  #frameWords(): string {
    return lab().time.frameOf(this.#frame + 1, this.#player.last + 1);
  }

  /** The chosen trial, or the first with predictions. */
  #foldNow(folds: readonly number[]): number {
    const { fold } = this.comparison.look;
    return folds.find((trial) => trial === fold) ?? folds[0] ?? 0;
  }

  protected override updated(): void {
    const canvas = this.querySelector("canvas");
    if (this.#columns && this.#columns.canvas !== canvas) this.#leaveCanvas();
    if (!canvas) return;
    if (!this.#columns && !this.#problem) {
      try {
        this.#columns = new Columns(canvas);
      } catch {
        this.#problem = compareWords().beside.noGraphics;
        this.requestUpdate();
        return;
      }
    }
    const { shown } = this.comparison;
    if (shown) this.#load(shown);
  }

  /** Updates the columns and the figure below them, if their content has changed. */
  #load(entry: ReadonlyEntry): void {
    const fold = this.#foldNow(foldsOf(entry));
    const actual = entry.actual.get(fold);
    const body = entry.body;
    if (!body || !actual) return;
    const chosen = chosenOf(predictionsOf(entry, fold), this.comparison.look.picked);
    const words = JSON.stringify([fold, chosen.map(({ key, label }) => [key, label])]);
    if (this.#loaded.entry === entry && this.#loaded.words === words) return;
    this.#loaded = { entry, words };
    const nodes = body.figure.nodes.length;
    const trial = motionOf(actual, nodes);
    const lines: Distances["lines"] = [];
    const motions: ColumnMotion[] = [];
    for (const prediction of chosen) {
      const predicted = motionOf(prediction.predicted, nodes);
      motions.push({ motion: predicted, ghost: trial });
      const metres = distances(predicted, trial);
      lines.push({ model: modelOf(prediction), label: prediction.label, metres });
    }
    this.#columns?.show(body, motions);
    this.#distances = { frameTime: trial.frameTime, trial: entry.titles[fold] ?? "", lines };
    this.#player.load(trial.frames, trial.frameTime, trial.frames - 1);
    this.requestUpdate();
  }

  #controls() {
    const { playing, last } = this.#player;
    const words = lab().time;
    return html`
      <div class="timeline row" role="group" aria-label=${words.label}>
        <button class="round primary" data-testid="compare-play" aria-label=${playing ? words.pause : words.play} title=${playing ? words.pauseMeaning : words.playMeaning}
          @click=${() => this.togglePlay()}>${icon(playing ? "pause" : "play")}</button>
        <button class="round" aria-label=${words.back} title=${words.backMeaning} @click=${() => this.step(-1)}>${icon("back")}</button>
        <button class="round" aria-label=${words.forward} title=${words.forwardMeaning} @click=${() => this.step(1)}>${icon("forward")}</button>
        <div class="scrub">
          <input class="cover" type="range" aria-label=${words.frame} data-testid="compare-scrub" min="0" max=${last} step="1" .value=${String(this.#frame)}
            aria-valuetext=${this.#frameWords()} @input=${(event: Event) => this.#scrub(event)} />
        </div>
        <output class="clock note tabular" aria-hidden="true"><b .textContent=${String(this.#frame + 1)}></b><span> ${compareWords().beside.of(last + 1)}</span></output>
      </div>`;
  }

  #choices(entry: ReadonlyEntry, folds: readonly number[], fold: number, chosen: readonly Prediction[]) {
    const keys = chosen.map(({ key }) => key);
    const words = compareWords().beside;
    const full = chosen.length >= MOST_COLUMNS;
    const chip = (prediction: Prediction) => {
      const { key } = prediction;
      const on = keys.includes(key);
      return html`<button class="chip" aria-pressed=${on ? "true" : "false"} ?disabled=${!on && full}
        title=${!on && full ? words.mostChosen : ""}
        @click=${() => this.comparison.lookAt({ picked: toggled(keys, key) })}>${nameOf(prediction)}</button>`;
    };
    return html`
      <div class="which row wrap">
        <label class="row quiet">${words.trial}
          <select data-testid="compare-fold" @change=${(event: Event) =>
            this.comparison.lookAt({ fold: Number((event.target as HTMLSelectElement).value) })}>
            ${folds.map((trial) => html`<option value=${trial} ?selected=${trial === fold}>${entry.titles[trial] ?? trial + 1}</option>`)}
          </select>
        </label>
        <div class="picks wrap" role="group" aria-label=${words.models(MOST_COLUMNS)}>${predictionsOf(entry, fold).map(chip)}</div>
      </div>`;
  }

  #putOnStage(prediction: Prediction, model: Blob, trial: string): void {
    const text = model.text();
    const detail: StagedModel = { text, name: `${modelOf(prediction)} without ${trial}`, made: true };
    this.tell("stage-model", detail);
  }

  #toStage(prediction: Prediction, trial: string) {
    const words = compareWords().beside;
    const { model } = prediction.predicted;
    return model
      ? html`<button class="small" data-testid="to-stage" title=${words.toStageMeaning} aria-label="${words.toStage}: ${nameOf(prediction)}"
          @click=${() => this.#putOnStage(prediction, model, trial)}>${words.toStage}</button>`
      : nothing;
  }

  protected override render() {
    const { shown, look } = this.comparison;
    const words = compareWords().beside;
    const folds = shown ? foldsOf(shown) : [];
    if (!shown || folds.length === 0) {
      return html`<p class="empty waiting">${
        shown && !shown.request && !shown.given ? words.noMotions : words.empty
      }</p>`;
    }
    const fold = this.#foldNow(folds);
    const chosen = chosenOf(predictionsOf(shown, fold), look.picked);
    return html`
      ${this.#choices(shown, folds, fold, chosen)}
      <div class="columns" style=${styled({ "--columns": chosen.length })}>
        <canvas class="stage-canvas cover" tabindex="0" role="img" data-testid="compare-stage"
          aria-label=${words.stage(chosen.length)}></canvas>
        ${this.#problem ? html`<p class="stage-problem quiet" role="alert">${this.#problem}</p>` : nothing}
        <ol class="column-heads passive cover">
          ${chosen.map(
            (prediction) => html`
            <li>
              <strong>${modelStyle(modelOf(prediction)).name}</strong>
              <span class="hint tabular">${prediction.label}</span>
              <span class="hint tabular">MSE ${plain(prediction.finished.outcome?.score.dtwMse ?? NaN)}</span>
              ${this.#toStage(prediction, shown.titles[fold] ?? "")}
            </li>`,
          )}
        </ol>
      </div>
      ${this.#controls()}
      <p class="hint">${words.about}</p>
      <comparison-distance .data=${this.#distances}></comparison-distance>`;
  }
}
customElements.define("pg-side-by-side", SideBySide);
