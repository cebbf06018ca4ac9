// The couplings: presets, arrows on the body, readings, and behind "Numbers" a table of sliders.
import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
import type { EngineStore } from "../engine/engine-store";
import type { ModelInfo } from "../engine/protocol";
import type { SettingsStore } from "../settings/settings-store";
import type { Playback } from "../stage/playback";
import { clipTitle, fixed } from "../ui/format";
import { withTerms } from "../terms/term";
import { View } from "../ui/view";
import "./body-map";
import type { BodyStore } from "./body-store";
import type { ClipStartStore } from "./clip-start-store";
import "./couplings.css";
import { couplingsTable } from "./couplings-table";
import "./measured-view";
import type { ModelStore } from "./model-store";
import "./presets-view";
import type { ReadingsStore } from "./readings-store";
import "./readings-view";
import "./weight-bar";
import { lab, shownPart } from "../words/lab";

export class CouplingsView extends View {
  declare model: ModelStore;
  declare settings: SettingsStore;
  declare engine: EngineStore;
  declare body: BodyStore;
  declare readings: ReadingsStore;
  declare playback: Playback;
  declare starts: ClipStartStore;

  protected override stores() {
    return [this.model, this.settings, this.engine, this.starts];
  }

  #table(info: ModelInfo) {
    const bar = (target: number) =>
      html`<pg-weight-bar .model=${this.model} .target=${target}></pg-weight-bar>`;
    return couplingsTable({
      couplings: this.model.couplings,
      parts: info.parts.map(({ name }) => shownPart(name)),
      ...(info.parts.length > 1 ? { above: bar } : {}),
    });
  }

  #starts({ sequences }: ModelInfo) {
    const { start, startFrame } = this.settings.values;
    const last = this.model.startFrames(start) - 1;
    const frame = Math.min(startFrame, last);
    // The clock stops at frame 0, so that the first pose is visible.
    const from = (event: Event) => {
      this.playback.scrub(0);
      this.model.setStart(start, (event.target as HTMLInputElement).valueAsNumber);
    };
    const frames =
      last > 0 && this.starts.clip === null
        ? html`<label class="start">${lab().couplings.fromFrame} <input type="range" min="0" max=${last} .value=${String(frame)} data-testid="start-frame"
            aria-valuetext=${lab().couplings.frame(frame + 1, last + 1)} @input=${from} /><output>${frame + 1}</output></label>`
        : nothing;
    return html`${this.#startChoice(sequences, start)}${frames}`;
  }

  /** The training sequences and the other clips that a rollout can start as. */
  #startChoice(sequences: ModelInfo["sequences"], start: number) {
    const { clip: chosen, clips, observed } = this.starts;
    if (sequences.length + clips.length < 2) return nothing;
    const words = lab().couplings;
    const choose = (event: Event) => {
      const { value } = event.target as HTMLSelectElement;
      if (clips.some(({ key }) => key === value)) this.starts.chooseClip(value);
      else this.starts.chooseSequence(Number(value));
    };
    // A choice that failed must show the present start again.
    const option = (value: string, name: string, selected: boolean) =>
      html`<option value=${value} .selected=${live(selected)}>${clipTitle(name)}</option>`;
    return html`
      <label class="start">${words.startAs}
        <select aria-label=${words.startLabel} aria-busy=${this.starts.isBusy ? "true" : "false"} @change=${choose}>
          <optgroup label=${words.trainedOn}>
            ${sequences.map(({ name }, i) => option(String(i), name, chosen === null && i === start))}
          </optgroup>
          ${
            clips.length > 0
              ? html`<optgroup label=${words.notTrainedOn}>${clips.map(({ key, title }) => option(key, title, key === chosen))}</optgroup>`
              : nothing
          }
        </select>
      </label>
      ${chosen === null ? nothing : html`<p class="hint" data-testid="clip-start">${words.clipStart(fixed(observed, 1))}</p>`}`;
  }

  #numbers(info: ModelInfo) {
    return html`
      <details class="advanced" data-testid="coupling-numbers">
        <summary>${lab().couplings.numbers}</summary>
        <p class="hint">${withTerms(lab().couplings.table)}</p>
        ${this.#table(info)}
        <div class="starts">${this.#starts(info)}</div>
      </details>`;
  }

  protected override render() {
    const info = this.model.model?.info;
    if (!info)
      return html`<p class="empty">${
        this.engine.state === "failed" ? lab().couplings.failed : lab().couplings.empty
      }</p>`;
    if (info.parts.length < 2)
      return html`
        <p data-testid="one-part">${withTerms(lab().couplings.onePart)}</p>
        ${this.#numbers(info)}`;
    return html`
      <div class="couplings-body">
        <pg-body-map .model=${this.model} .settings=${this.settings}></pg-body-map>
        <pg-presets .model=${this.model} .settings=${this.settings}></pg-presets>
      </div>
      <pg-measured .model=${this.model} .body=${this.body} .readings=${this.readings}></pg-measured>
      <pg-readings .model=${this.model} .settings=${this.settings} .readings=${this.readings}></pg-readings>
      ${this.#numbers(info)}`;
  }
}
customElements.define("pg-couplings", CouplingsView);
