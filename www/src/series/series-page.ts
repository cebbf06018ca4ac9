// The view of time series without a body: the picture of the Lab, with curves in place of the figure.
import { html, nothing } from "lit";
import { coupledPicture } from "../picture/coupled-picture";
import { progressRow } from "../training/progress-row";
import { download } from "../ui/download";
import { messageOf } from "../ui/format";
import { icon } from "../ui/icons";
import type { NoticesStore } from "../ui/notices-store";
import type { Draw } from "../views/define-view";
import { lab } from "../words/lab";
import { seriesWords } from "./view-words";
import { exampleFiles } from "./example";
import type { Series } from "./series";
import "./series.css";
import "./series-curves";
import "./series-figure";
import { seriesSetup } from "./series-setup";
import { SeriesView } from "./series-view";

export class SeriesPage extends SeriesView {
  declare series: Series;
  declare notices: NoticesStore;

  protected override get shown() {
    return this.series.model;
  }

  protected override stores() {
    const { tables, model, training } = this.series;
    return [tables, model, model.clock, training, this.settings, this.notices];
  }

  #open(files: readonly File[]): void {
    this.tell("open-files", files);
  }

  async #saveCurves(): Promise<void> {
    try {
      download("curves.csv", new Blob([await this.series.model.csv()], { type: "text/csv" }));
    } catch (problem) {
      this.notices.addError(lab().files.nothingSaved, messageOf(problem));
    }
  }

  #begin() {
    const words = seriesWords().begin;
    return html`
      <section class="series-empty">
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

  #start() {
    const { model } = this.series;
    const { sequences = [] } = model.opened?.info ?? {};
    if (sequences.length < 2) return nothing;
    const choose = (event: Event) => model.setSequence(Number((event.target as HTMLSelectElement).value));
    return html`<label class="start">${seriesWords().startAs} <select data-testid="series-start" @change=${choose}>
      ${sequences.map(({ name }, i) => html`<option value=${i} .selected=${i === model.sequence}>${name}</option>`)}</select></label>`;
  }

  #stage() {
    const { model } = this.series;
    const words = seriesWords();
    return html`
      <section class="stage-area series-stage" aria-label=${words.curves}>
        <header class="panel-head">
          ${this.#start()}
          <div class="button-row">
            <button class="small" data-testid="save-curves" title=${words.saveCurvesMeaning} @click=${() => void this.#saveCurves()}>${icon("save")} ${words.saveCurves}</button>
            <button class="small" data-testid="save-series" title=${words.saveModelMeaning} @click=${() => model.save()}>${icon("save")} ${words.saveModel}</button>
          </div>
        </header>
        <div class="series-motion">
          <pg-series-curves .model=${model} data-testid="series-curves"></pg-series-curves>
          <pg-series-figure .model=${model}></pg-series-figure>
        </div>
        <p class="hint">${model.recorded ? words.recorded : words.notRecorded}</p>
        ${this.#controls()}
      </section>`;
  }

  #train() {
    const { training } = this.series;
    const words = seriesWords();
    return progressRow({
      progress: training,
      verb: [words.train, words.training, words.trained],
      testIds: ["series-train", "series-cancel", "series-words"],
      whyNot: training.whyNot,
      hint: words.hint,
      start: () => void training.train(),
    });
  }

  #picture() {
    const { model } = this.series;
    const { panel } = this.settings.values;
    const foot = html`
      <div class="picture-foot">
        <div>${this.#train()}</div>
        <div class="panel-buttons">
          <button id="open-learn" aria-expanded=${panel === "learn" ? "true" : "false"} aria-controls="panel-learn"
            @click=${() => this.settings.change({ panel: panel === "learn" ? "none" : "learn" })}>${lab().page.panels.learn}</button>
        </div>
      </div>`;
    if (!model.model)
      return html`<div class="picture-area picture"><p class="hint">${seriesWords().noCouplings}</p>${foot}</div>`;
    const { problem } = model;
    return coupledPicture({ model, space: this.space, lead: lab().stage.lead.drag, problem, foot });
  }

  protected override render() {
    const { series, settings, notices } = this;
    const { opened } = series.model;
    const isOpen = !opened || settings.values.panel === "learn";
    const setup = () => seriesSetup({ series, settings, notices, open: (files) => this.#open(files) });
    return html`
      <div class="lab" data-panel=${isOpen ? "learn" : "none"}>
        ${opened ? [this.#stage(), this.#picture()] : this.#begin()}
        ${isOpen ? html`<aside id="panel-learn" class="panel" aria-label=${seriesWords().setup}>${opened ? nothing : this.#train()}${setup()}</aside>` : nothing}
      </div>`;
  }
}
customElements.define("pg-series", SeriesPage);

export const draw: Draw<"series"> = (series, { settings, notices }) =>
  html`<pg-series data-clock .series=${series} .settings=${settings} .notices=${notices}></pg-series>`;
