// The view of time series without a body: tables, the model of their columns, its curves, latents and
// couplings.
import { html, nothing } from "lit";
import { type NumberName, settingField } from "../settings/setting-field";
import type { SettingsStore } from "../settings/settings-store";
import { progressRow } from "../training/progress-row";
import { download } from "../ui/download";
import { eachFrame } from "../ui/each-frame";
import { fileButton } from "../ui/file-button";
import { messageOf } from "../ui/format";
import { icon } from "../ui/icons";
import type { NoticesStore } from "../ui/notices-store";
import { noticeCard } from "../ui/notices-view";
import "../ui/two-columns.css";
import { View } from "../ui/view";
import { exampleFiles } from "./example";
import type { Series } from "./series";
import "./series.css";
import { seriesCouplings } from "./series-couplings";
import "./series-curves";
import "./series-latent";
import "./tables-view";
import { lab } from "../words/lab";

const COUNTS: [NumberName, string, string][] = [
  ["latent", "Latent dimensions", "The dimensions of each part's latent space"],
  ["dynamicsIps", "Dynamics points", "Inducing points of each coupling's dynamics"],
  ["poseIps", "Observation points", "Inducing points of the map from each part's latents to its columns"],
  ["order", "Rows of history", "The order of the dynamics"],
  ["maxIterations", "Iterations at most", "The optimiser stops here at the latest"],
  ["seed", "Seed", "The seed of everything random"],
];

export class SeriesPage extends View {
  declare series: Series;
  declare settings: SettingsStore;
  declare notices: NoticesStore;

  protected override stores() {
    const { tables, model, training } = this.series;
    return [tables, model, model.clock, training, this.settings, this.notices];
  }

  protected override arrived(): void {
    this.whenLeaving(eachFrame((seconds) => this.series.model.clock.advance(seconds)));
  }

  /** The clock that the keys for play and step control. */
  togglePlay(): void {
    this.series.model.clock.togglePlay();
  }

  step(direction: 1 | -1): void {
    this.series.model.clock.step(direction);
  }

  #open(files: readonly File[]): void {
    this.dispatchEvent(new CustomEvent("open-files", { detail: files, bubbles: true }));
  }

  async #saveCurves(): Promise<void> {
    try {
      download("curves.csv", new Blob([await this.series.model.csv()], { type: "text/csv" }));
    } catch (problem) {
      this.notices.addError("Nothing was saved", messageOf(problem));
    }
  }

  #setup() {
    const { tables, training } = this.series;
    const { busy } = training;
    const { notices } = this;
    const timeless = tables.ticked.some(({ info }) => info.frameTime === null);
    const field = (name: NumberName, label: string, hint: string) =>
      settingField(this.settings, name, { label, hint, testId: `series-${name}`, disabled: busy });
    return html`
      <header class="panel-head"><h2>Tables</h2>
        ${fileButton({
          label: "Open",
          meaning: "Open tables (.csv) or a model of tables (.json)",
          testId: "open-series",
          accept: ".csv,.json,text/csv,application/json",
          multiple: true,
          disabled: busy,
          chosen: (files) => this.#open(files),
        })}
      </header>
      ${notices.all.filter(({ at }) => at === null).map((notice) => noticeCard(notices, notice, lab().files.dismiss))}
      <p class="hint">Drop CSV files anywhere, one a trial: names in the first row, then a row of numbers a moment. A column <code>time</code> holds seconds.
        They stay on this machine, and only as long as this page is open.</p>
      <pg-tables .tables=${tables} ?busy=${busy}></pg-tables>
      ${progressRow({
        progress: training,
        verb: ["Train", "Training", "Trained"],
        testIds: ["series-train", "series-cancel", "series-words"],
        whyNot: training.whyNot,
        hint: "Learns how the columns of each part go on, and which part drives which.",
        start: () => void training.train(),
      })}
      <div class="fields">
        ${COUNTS.map((row) => field(...row))}
        ${timeless ? field("framesPerSecond", "Rows a second", "How fast rows follow each other: the tables have no column of times") : nothing}
      </div>`;
  }

  #begin() {
    return html`
      <section class="panel series-empty">
        <h2>Curves that are no body</h2>
        <p>Forces, joint torques, muscle activity, prices, two machines: whatever you measured several of at once. Columns are put into parts; each part gets a
          latent space, and the couplings say which part drives which. A model of tables is one file, like all others.</p>
        <button class="small primary" data-testid="series-example" @click=${() => this.#open(exampleFiles())}>Open an example</button>
        <p class="hint">Two made-up machines, by a formula; the second follows the first a little later.</p>
      </section>`;
  }

  #controls() {
    const { clock } = this.series.model;
    const { playing, lastFrame: last } = clock;
    const frame = Math.floor(clock.frame + 1e-6);
    return html`
      <div class="timeline" role="group" aria-label="Time">
        <button class="round primary" data-testid="series-play" aria-label=${playing ? "Pause" : "Play"} title=${playing ? "Pause (space)" : "Play (space)"}
          @click=${() => clock.togglePlay()}>${icon(playing ? "pause" : "play")}</button>
        <div class="scrub"><input type="range" aria-label="Row" data-testid="series-scrub" min="0" max=${last} step="1" .value=${String(frame)}
          aria-valuetext="Row ${frame + 1} of ${last + 1}" @input=${(event: Event) => clock.scrub((event.target as HTMLInputElement).valueAsNumber)} /></div>
        <output class="clock" aria-hidden="true"><b>${frame + 1}</b><span> of ${last + 1}</span></output>
      </div>`;
  }

  #model() {
    const { model } = this.series;
    const { opened, recorded, sequence } = model;
    if (!opened) return this.#begin();
    const { parts, sequences, alpha, provenance } = opened.info;
    return html`
      <section class="panel series-stage" aria-label="Curves">
        <header class="panel-head">
          <h2>Curves</h2>
          ${
            sequences.length > 1
              ? html`<label class="start">Start as <select data-testid="series-start" @change=${(
                  event: Event,
                ) => model.setSequence(Number((event.target as HTMLSelectElement).value))}>
                ${sequences.map(({ name }, i) => html`<option value=${i} .selected=${i === sequence}>${name}</option>`)}</select></label>`
              : nothing
          }
          <div class="button-row">
            <button class="small" data-testid="save-curves" title="A row a frame, a column for each curve" @click=${() => void this.#saveCurves()}>${icon("save")} Curves, CSV</button>
            <button class="small" data-testid="save-series" title="Opens here and in the terminal" @click=${() => model.save()}>${icon("save")} Model, JSON</button>
          </div>
        </header>
        <pg-series-curves .model=${model} data-testid="series-curves"></pg-series-curves>
        ${this.#controls()}
        <p class="hint">${
          recorded
            ? "In colour: the model on its own, from the first rows of the table on. Dashed: what was recorded."
            : "The model on its own. Its file does not hold what was recorded: open the tables to see them dashed."
        } Trained by ${provenance.engine}, ${provenance.iterations} iterations, seed ${provenance.settings.seed}.</p>
      </section>
      <section class="panel series-latents" aria-label="Latent spaces">
        <header class="panel-head"><h2>Latent spaces</h2></header>
        ${
          alpha
            ? html`<div class="plots">${parts.map((_, part) => html`<pg-series-latent .model=${model} .bodyPart=${part}></pg-series-latent>`)}</div>`
            : nothing
        }
      </section>
      <section class="panel series-couplings" aria-label="Couplings">
        <header class="panel-head"><h2>Couplings</h2>
          <p class="hint">Which part decides about which. Right is strong: small α, large w.</p></header>
        ${seriesCouplings(model)}
      </section>`;
  }

  protected override render() {
    return html`
      <section class="panel panels-setup" aria-label="Tables and training">${this.#setup()}</section>
      <div class="panels-found series-found">${this.#model()}</div>`;
  }
}
customElements.define("pg-series", SeriesPage);
