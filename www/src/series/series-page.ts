// The view of time series without a body: tables, the model of their columns, its curves, latents and
// couplings.
import { html, nothing } from "lit";
import { settingField } from "../settings/setting-field";
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
import type { Draw } from "../views/define-view";
import type { Series } from "./series";
import "./series.css";
import "./series-curves";
import "./series-figure";
import "./series-latent";
import "./tables-view";
import { lab } from "../words/lab";
import { seriesWords } from "../words/series";
import { READINGS } from "../couplings/couplings-store";
import { couplingsTable } from "../couplings/couplings-table";
import type { SeriesStore } from "./series-store";

function seriesCouplings(model: SeriesStore) {
  const { opened, couplings } = model;
  const words = seriesWords();
  if (!opened?.info.alpha) {
    return html`<p class="hint">${words.noCouplings}</p>`;
  }
  return html`
    ${couplingsTable({
      couplings,
      parts: opened.info.parts.map(({ name }) => name),
    })}
    <div class="button-row">
      <span class="segments" role="group" aria-label=${words.changed}>
        ${READINGS.map(
          (
            reading,
          ) => html`<button title=${words.readings[reading]} aria-pressed=${couplings.reading === reading ? "true" : "false"}
            @click=${() => couplings.setReading(reading)}>${lab().readings.text[reading]}</button>`,
        )}</span>
      <button class="small" data-testid="series-reset" ?disabled=${!couplings.altered} @click=${() => couplings.resetAll()}>${words.reset}</button>
    </div>
    ${model.problem ? html`<p class="bad" role="alert">${model.problem}</p>` : nothing}`;
}

const ROWS = 100;
const STEP = 0.05;
const NAMES = ["leader_a", "leader_b", "leader_c", "follower_d", "follower_e"];

function measured(recording: number, row: number): number[] {
  const phase = 0.25 * row + 1.5 * recording;
  return [
    10 + Math.sin(phase),
    2 * Math.cos(phase),
    Math.tanh(Math.sin(phase + 0.5)),
    5 + 0.8 * Math.sin(phase - 0.7),
    0.5 * Math.cos(2 * (phase - 0.7)),
  ];
}

/** Two recordings of the machines, as files. */
function exampleFiles(): File[] {
  return [1, 2].map((number) => {
    const rows = Array.from({ length: ROWS }, (_, row) =>
      [row * STEP, ...measured(number - 1, row)].map((value) => value.toFixed(4)).join(","),
    );
    return new File([["time", ...NAMES].join(","), "\n", rows.join("\n"), "\n"], `machines-${number}.csv`);
  });
}

/** The column of a table that holds seconds. */
const TIME_COLUMN = "time";

const COUNTS = ["latent", "dynamicsIps", "poseIps", "order", "maxIterations", "seed"] as const;

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
      this.notices.addError(lab().files.nothingSaved, messageOf(problem));
    }
  }

  #setup() {
    const { tables, training } = this.series;
    const { busy } = training;
    const { notices } = this;
    const timeless = tables.ticked.some(({ info }) => info.frameTime === null);
    const words = seriesWords();
    const [dropHere, seconds] = words.drop;
    const field = (name: (typeof COUNTS)[number] | "framesPerSecond") =>
      settingField(this.settings, name, {
        ...words.fields[name],
        testId: `series-${name}`,
        disabled: busy,
      });
    return html`
      <header class="panel-head"><h2>${words.tables}</h2>
        ${fileButton({
          label: words.open,
          meaning: words.openMeaning,
          testId: "open-series",
          accept: ".csv,.json,text/csv,application/json",
          multiple: true,
          disabled: busy,
          chosen: (files) => this.#open(files),
        })}
      </header>
      ${notices.all.filter(({ at }) => at === null).map((notice) => noticeCard(notices, notice, lab().files.dismiss))}
      <p class="hint">${dropHere} <code>${TIME_COLUMN}</code> ${seconds}</p>
      <pg-tables .tables=${tables} ?busy=${busy}></pg-tables>
      ${progressRow({
        progress: training,
        verb: [words.train, words.training, words.trained],
        testIds: ["series-train", "series-cancel", "series-words"],
        whyNot: training.whyNot,
        hint: words.hint,
        start: () => void training.train(),
      })}
      <div class="fields">
        ${COUNTS.map(field)}
        ${timeless ? field("framesPerSecond") : nothing}
      </div>`;
  }

  #begin() {
    const words = seriesWords().begin;
    return html`
      <section class="panel series-empty">
        <h2>${words.title}</h2>
        <p>${words.text}</p>
        <button class="small primary" data-testid="series-example" @click=${() => this.#open(exampleFiles())}>${words.example}</button>
        <p class="hint">${words.machines}</p>
      </section>`;
  }

  #controls() {
    const { clock } = this.series.model;
    const { playing, lastFrame: last } = clock;
    const frame = Math.floor(clock.frame + 1e-6);
    const words = seriesWords();
    const { time } = lab();
    return html`
      <div class="timeline" role="group" aria-label=${time.label}>
        <button class="round primary" data-testid="series-play" aria-label=${playing ? time.pause : time.play} title=${playing ? time.pauseMeaning : time.playMeaning}
          @click=${() => clock.togglePlay()}>${icon(playing ? "pause" : "play")}</button>
        <div class="scrub"><input type="range" aria-label=${words.row} data-testid="series-scrub" min="0" max=${last} step="1" .value=${String(frame)}
          aria-valuetext=${words.rowOf(frame + 1, last + 1)} @input=${(event: Event) => clock.scrub((event.target as HTMLInputElement).valueAsNumber)} /></div>
        <output class="clock" aria-hidden="true"><b>${frame + 1}</b><span> ${words.of(last + 1)}</span></output>
      </div>`;
  }

  #model() {
    const { model } = this.series;
    const { opened, recorded, sequence } = model;
    if (!opened) return this.#begin();
    const { parts, sequences, alpha, provenance } = opened.info;
    const words = seriesWords();
    return html`
      <section class="panel series-stage" aria-label=${words.curves}>
        <header class="panel-head">
          <h2>${words.curves}</h2>
          ${
            sequences.length > 1
              ? html`<label class="start">${words.startAs} <select data-testid="series-start" @change=${(
                  event: Event,
                ) => model.setSequence(Number((event.target as HTMLSelectElement).value))}>
                ${sequences.map(({ name }, i) => html`<option value=${i} .selected=${i === sequence}>${name}</option>`)}</select></label>`
              : nothing
          }
          <div class="button-row">
            <button class="small" data-testid="save-curves" title=${words.saveCurvesMeaning} @click=${() => void this.#saveCurves()}>${icon("save")} ${words.saveCurves}</button>
            <button class="small" data-testid="save-series" title=${words.saveModelMeaning} @click=${() => model.save()}>${icon("save")} ${words.saveModel}</button>
          </div>
        </header>
        <div class="series-motion">
          <pg-series-curves .model=${model} data-testid="series-curves"></pg-series-curves>
          <pg-series-figure .model=${model}></pg-series-figure>
        </div>
        ${this.#controls()}
        <p class="hint">${
          recorded ? words.recorded : words.notRecorded
        } ${words.provenance(provenance.engine, provenance.iterations, provenance.settings.seed)}</p>
      </section>
      <section class="panel series-latents" aria-label=${words.latents}>
        <header class="panel-head"><h2>${words.latents}</h2></header>
        ${
          alpha
            ? html`<div class="plots">${parts.map((_, part) => html`<pg-series-latent .model=${model} .bodyPart=${part}></pg-series-latent>`)}</div>`
            : nothing
        }
      </section>
      <section class="panel series-couplings" aria-label=${words.couplings}>
        <header class="panel-head"><h2>${words.couplings}</h2>
          <p class="hint">${words.couplingsMeaning}</p></header>
        ${seriesCouplings(model)}
      </section>`;
  }

  protected override render() {
    return html`
      <section class="panel panels-setup" aria-label=${seriesWords().setup}>${this.#setup()}</section>
      <div class="panels-found series-found">${this.#model()}</div>`;
  }
}
customElements.define("pg-series", SeriesPage);

export const draw: Draw<"series"> = (series, { settings, notices }) =>
  html`<pg-series data-clock .series=${series} .settings=${settings} .notices=${notices}></pg-series>`;
