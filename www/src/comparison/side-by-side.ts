// Predictions of the same trial side by side, under one clock: which trial, which models, and the clock's controls.
import { html, nothing } from "lit";
import { studying } from "./comparison-store";
import { distances } from "../scene/motion";
import { Player } from "../stage/player";
import type { Finished, Motion } from "../engine/whole-protocol";
import { candidateKey, inOrder, jobKey, type Positions } from "./jobs";
import { icon } from "../ui/icons";
import { View } from "../ui/view";
import { type ColumnMotion, Columns } from "./columns";
import "./distance";
import type { Distances, DistanceFigure } from "./distance";
import { modelStyle } from "./model-style";
import { plain } from "../figures/numbers";

/** More would be too narrow to see. */
const MOST = 4;

interface Shown {
  key: string;
  finished: Finished;
  predicted: Positions;
}

const motionOf = ({ positions, frameTime }: Positions, nodes: number): Motion => ({
  positions,
  nodes,
  frameTime,
  frames: positions.length / (3 * nodes),
});

export class SideBySide extends View {
  static override topics = ["study"] as const;
  /** The whole frame that the controls show, and where the clock was when the columns were last drawn. */
  private frame = 0;
  private drawnAt = -1;
  private readonly player = new Player();
  private columns: Columns | null = null;
  private problem = "";
  /** What the columns show: of which study, which trial, which models. */
  private onStage: { of: unknown; what: string } = { of: null, what: "" };
  private apart: Distances | null = null;
  private lastTick = 0;
  private timer = 0;

  override connectedCallback(): void {
    super.connectedCallback();
    this.player.playing = studying(this.app).look.playing ?? !matchMedia("(prefers-reduced-motion: reduce)").matches;
    const tick = (now: number) => {
      this.timer = requestAnimationFrame(tick);
      this.tick(Math.min(0.25, (now - this.lastTick) / 1000));
      this.lastTick = now;
    };
    this.lastTick = performance.now();
    this.timer = requestAnimationFrame(tick);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    cancelAnimationFrame(this.timer);
    this.leave();
  }

  /** Gives the canvas up. */
  private leave(): void {
    this.columns?.dispose();
    this.columns = null;
    this.onStage = { of: null, what: "" };
  }

  togglePlay(): void {
    if (this.player.playing) this.player.pause();
    else this.player.play();
    this.remember();
  }

  step(direction: 1 | -1): void {
    this.player.step(direction);
    this.showFrame();
    this.remember();
  }

  private scrub(event: Event): void {
    this.player.pause();
    this.player.scrub(Number((event.target as HTMLInputElement).value));
    this.showFrame();
    this.remember();
  }

  /** Whether it plays is as it was left when the view is opened again. */
  private remember(): void {
    studying(this.app).look.playing = this.player.playing;
    this.requestUpdate();
  }

  private tick(seconds: number): void {
    this.player.advance(seconds);
    const changed = this.player.frame !== this.drawnAt;
    this.drawnAt = this.player.frame;
    if (Math.floor(this.player.frame + 1e-6) !== this.frame) this.showFrame();
    this.columns?.draw(this.player.frame, changed, seconds, this.player.playing);
  }

  /** Moves what follows the clock; all else stays as it is drawn. */
  private showFrame(): void {
    const frame = Math.floor(this.player.frame + 1e-6);
    this.frame = frame;
    const [range, clock] = [this.querySelector<HTMLInputElement>(".scrub input"), this.querySelector(".clock b")];
    if (!range || !clock) return;
    range.value = String(frame);
    range.setAttribute("aria-valuetext", this.frameWords());
    clock.textContent = String(frame + 1);
    this.querySelector<DistanceFigure>("comparison-distance")?.at(frame);
  }

  private frameWords(): string {
    return `Frame ${this.frame + 1} of ${this.player.last + 1}`;
  }

  /** Trials of which there are predictions. */
  private folds(): number[] {
    const { study } = studying(this.app);
    const known = (study?.results.finished ?? []).filter(({ job }) => study!.predictions.has(jobKey(job)));
    return [...new Set(known.map(({ job }) => job.held_out))].sort((a, b) => a - b);
  }

  /** What can be shown of a trial: models trained on all others. */
  private candidates(fold: number): Shown[] {
    const { study } = studying(this.app);
    if (!study) return [];
    const all = study.results.setting.trials.length - 1;
    const found = study.results.finished.flatMap((finished) => {
      const { job } = finished;
      if (job.held_out !== fold || job.training_trials !== all) return [];
      const predicted = study.predictions.get(jobKey(job));
      return predicted ? [{ key: jobKey({ ...job, held_out: 0 }), finished, predicted }] : [];
    });
    return found.sort((a, b) => inOrder(a.finished.job, b.finished.job));
  }

  private chosen(of: readonly Shown[]): Shown[] {
    const picked = studying(this.app).look.picked?.flatMap((key) => of.filter((one) => one.key === key)) ?? [];
    if (picked.length > 0) return picked.slice(0, MOST);
    const kinds = new Map<string, Shown>();
    for (const one of of) {
      const { model } = one.finished.job.candidate;
      if (!kinds.has(model)) kinds.set(model, one);
    }
    return [...kinds.values()].slice(0, MOST);
  }

  private toggle(of: readonly Shown[], key: string): void {
    const now = this.chosen(of).map((one) => one.key);
    const next = now.includes(key) ? now.filter((one) => one !== key) : [...now, key];
    if (next.length >= 1 && next.length <= MOST) studying(this.app).look.picked = next;
    this.requestUpdate();
  }

  private nameOf({ finished: { job } }: Shown): string {
    const { study, comparison } = studying(this.app);
    const key = candidateKey(job.candidate);
    const label = comparison?.models.find(({ candidate }) => candidateKey(candidate) === key)?.label ?? "";
    const alike = study?.results.finished.filter((one) => one.job.candidate.model === job.candidate.model) ?? [];
    const seed = new Set(alike.map((one) => one.job.seed)).size > 1 ? `seed ${job.seed}` : "";
    return [label, seed].filter(Boolean).join(", ");
  }

  override updated(): void {
    const canvas = this.querySelector("canvas");
    if (this.columns && this.columns.canvas !== canvas) this.leave();
    if (!canvas) return;
    if (!this.columns && !this.problem) {
      try {
        this.columns = new Columns(canvas);
      } catch {
        this.problem =
          "This browser shows no 3-D graphics (WebGL), so the figures cannot be drawn. The tables below work all the same.";
        this.requestUpdate();
        return;
      }
    }
    const { study } = studying(this.app);
    const fold = this.foldNow();
    const actual = study?.actual.get(fold);
    if (!study?.body || !actual) return;
    const shown = this.chosen(this.candidates(fold));
    const what = JSON.stringify([fold, shown.map((one) => [one.key, this.nameOf(one)])]);
    if (this.onStage.of === study && this.onStage.what === what) return;
    this.onStage = { of: study, what };
    const nodes = study.body.figure.nodes.length;
    const trial = motionOf(actual, nodes);
    const motions = shown.map(
      ({ predicted }): ColumnMotion => ({ predicted: motionOf(predicted, nodes), actual: trial }),
    );
    this.columns?.show(study.body, motions);
    this.apart = {
      frameTime: trial.frameTime,
      trial: study.titles[fold - 1] ?? "",
      lines: shown.map((one, i) => ({
        model: one.finished.job.candidate.model,
        label: this.nameOf(one),
        metres: distances(motions[i]!.predicted, trial),
      })),
    };
    this.player.load(trial.frames, trial.frameTime, trial.frames - 1);
    this.requestUpdate();
  }

  private foldNow(): number {
    const { fold } = studying(this.app).look;
    const folds = this.folds();
    return folds.includes(fold) ? fold : (folds[0] ?? 0);
  }

  private controls() {
    const { player } = this;
    return html`
      <div class="timeline" role="group" aria-label="Time">
        <button class="round primary" data-testid="compare-play" aria-label=${player.playing ? "Pause" : "Play"} title=${player.playing ? "Pause (space)" : "Play (space)"}
          @click=${this.togglePlay}>${icon(player.playing ? "pause" : "play")}</button>
        <button class="round" aria-label="One frame back" title="One frame back (left arrow)" @click=${() => this.step(-1)}>${icon("back")}</button>
        <button class="round" aria-label="One frame forward" title="One frame forward (right arrow)" @click=${() => this.step(1)}>${icon("forward")}</button>
        <div class="scrub">
          <input type="range" aria-label="Frame" data-testid="compare-scrub" min="0" max=${player.last} step="1" .value=${String(this.frame)}
            aria-valuetext=${this.frameWords()} @input=${this.scrub} />
        </div>
        <output class="clock" aria-hidden="true"><b .textContent=${String(this.frame + 1)}></b><span> of ${player.last + 1}</span></output>
      </div>`;
  }

  protected override render() {
    const { study } = studying(this.app);
    const folds = this.folds();
    if (!study || folds.length === 0) {
      return html`<p class="empty waiting">${
        study && study.clips.length === 0
          ? "A file of results holds no motions: press Compare with the clips to see the models move."
          : "The models will walk here side by side, each with the real trial as a grey ghost."
      }</p>`;
    }
    const fold = this.foldNow();
    const all = this.candidates(fold);
    const shown = this.chosen(all);
    const full = shown.length >= MOST;
    return html`
      <div class="which">
        <label>Trial held out
          <select data-testid="compare-fold" @change=${(event: Event) => {
            studying(this.app).look.fold = Number((event.target as HTMLSelectElement).value);
            this.requestUpdate();
          }}>
            ${folds.map((k) => html`<option value=${k} ?selected=${k === fold}>${study.titles[k - 1] ?? k}</option>`)}
          </select>
        </label>
        <div class="picks" role="group" aria-label="Models to show, at most ${MOST}">
          ${all.map((one) => {
            const on = shown.some(({ key }) => key === one.key);
            const { name } = modelStyle(one.finished.job.candidate.model);
            return html`<button class="chip" aria-pressed=${on ? "true" : "false"} ?disabled=${!on && full}
              title=${!on && full ? "Four at most: take one away first" : ""} @click=${() => this.toggle(all, one.key)}>${[name, this.nameOf(one)].filter(Boolean).join(", ")}</button>`;
          })}
        </div>
      </div>
      <div class="columns" style="--columns:${shown.length}">
        <canvas tabindex="0" role="img" data-frames-drawn="0" data-testid="compare-stage"
          aria-label="${shown.length} predictions of the trial side by side, each with the real trial as a ghost. Drag to look from another side; with the keyboard: w, a, s, d."
          @keydown=${(event: KeyboardEvent) => this.columns?.turnByKey(event)}></canvas>
        ${this.problem ? html`<p class="stage-problem" role="alert">${this.problem}</p>` : nothing}
        <ol class="column-heads">
          ${shown.map(
            (one) => html`
            <li>
              <strong>${modelStyle(one.finished.job.candidate.model).name}</strong>
              <span>${this.nameOf(one)}</span>
              <span>MSE ${plain(one.finished.outcome?.score.dtw_mse ?? NaN)}</span>
            </li>`,
          )}
        </ol>
      </div>
      ${this.controls()}
      <p class="hint">In colour: what the model predicts from the trial’s first five frames. Grey: the real trial, laid on top.</p>
      <comparison-distance .data=${this.apart}></comparison-distance>`;
  }
}
customElements.define("pg-side-by-side", SideBySide);
