// The picture of the Lab next to the figure: a loop for each part, and between the loops the couplings with the
// sliders of alpha. Below it what the couplings do, measured, and the buttons for everything else.
import { html, nothing } from "lit";
import type { ClipsStore } from "../clips/clips-store";
import type { BodyStore } from "../couplings/body-store";
import { readingChoice } from "../couplings/reading-choice";
import "../couplings/measured-view";
import type { ModelStore } from "../couplings/model-store";
import { presetWords } from "../couplings/presets";
import type { ReadingsStore } from "../couplings/readings-store";
import type { EngineStore } from "../engine/engine-store";
import type { LayersStore } from "../latents/layers-store";
import type { PointingStore } from "../latents/pointing-store";
import type { PredictionsStore } from "../latents/predictions-store";
import { PANELS } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import type { Playback } from "../stage/playback";
import type { StageStore } from "../stage/stage-store";
import { withTerms } from "../terms/term";
import "../training/train-row";
import type { TrainingStore } from "../training/training-store";
import { icon } from "../ui/icons";
import { View } from "../ui/view";
import { lab } from "../words/lab";
import "./loops-view";
import "./picture.css";

/** What the picture shows; all stores of the page have these. */
export interface PictureStores {
  readonly model: ModelStore;
  readonly settings: SettingsStore;
  readonly engine: EngineStore;
  readonly body: BodyStore;
  readonly readings: ReadingsStore;
  readonly stage: StageStore;
  readonly playback: Playback;
  readonly pointing: PointingStore;
  readonly predictions: PredictionsStore;
  readonly layers: LayersStore;
  readonly training: TrainingStore;
  readonly clips: ClipsStore;
}

type Panel = (typeof PANELS)[number];

/** Exercises that ask for the couplings of a preset. */
const WITHOUT_PRESETS: readonly number[] = [1, 2];

export class PictureView extends View {
  static override properties = { panels: {} };
  declare app: PictureStores;
  /** The panels that can be opened. */
  panels: readonly Panel[] = PANELS;

  protected override stores() {
    const { model, settings, engine, stage, training, readings } = this.app;
    return [model, settings, engine, stage, training, readings];
  }

  #presets() {
    const { model, settings } = this.app;
    const { label, own } = lab().presets;
    if (WITHOUT_PRESETS.includes(settings.values.exercise) || model.presets.length === 0) return nothing;
    const now = model.preset;
    const choose = (event: Event) => {
      const { value } = event.target as HTMLSelectElement;
      const preset = model.presets.find(({ id }) => id === value);
      if (preset) model.takePreset(preset);
    };
    return html`
      <select data-testid="preset" aria-label=${label} @change=${choose}>
        ${now ? nothing : html`<option value="" .selected=${true} disabled>${own}</option>`}
        ${model.presets.map((preset) => html`<option value=${preset.id} .selected=${preset.id === now?.id}>${presetWords(preset).name}</option>`)}
      </select>`;
  }

  /** What the couplings now are, or what to try. */
  #lead(): string {
    const { model, training } = this.app;
    const { content } = this.app.stage;
    const { lead } = lab().stage;
    if (content?.kind === "clip") return content.caption ? lead.hidden : lead.clip;
    if (content?.kind === "completed") return lead.hidden;
    if (content?.live) return lead.live;
    if (model.couplings.altered) {
      const { bothShown } = this.app.readings;
      if (bothShown) return lab().readings.both;
      return model.preset ? presetWords(model.preset).meaning : lead.own;
    }
    return training.learning ? lead.learning : lead.drag;
  }

  #foot() {
    const { settings, training, clips } = this.app;
    const { panel: open } = settings.values;
    const words = lab().page.panels;
    const toggle = (panel: Panel) => () => settings.change({ panel: panel === open ? "none" : panel });
    return html`
      <div class="picture-foot wrap spread">
        ${this.panels.includes("learn") ? html`<pg-train .training=${training} .clips=${clips}></pg-train>` : html`<span></span>`}
        <div class="panel-buttons row tight">
          ${this.panels.map(
            (panel) => html`
            <button id="open-${panel}" aria-expanded=${panel === open ? "true" : "false"} aria-controls="panel-${panel}"
              @click=${toggle(panel)}>${words[panel]}</button>`,
          )}
        </div>
      </div>`;
  }

  protected override render() {
    const { model, body, readings, engine } = this.app;
    const { content } = this.app.stage;
    const info = model.model?.info;
    const words = lab().couplings;
    if (!info)
      return html`<p class="empty">${engine.state === "failed" ? words.failed : words.empty}</p>${this.#foot()}`;
    const isCoupled = info.parts.length > 1;
    const isMeasured = content?.kind === "model" && !content.live;
    return html`
      <div class="picture-head row wrap" role="group" aria-label=${words.map}>
        ${isCoupled ? [this.#presets(), readingChoice(model.couplings)] : nothing}
        ${
          model.couplings.altered
            ? html`<button data-testid="reset-couplings" @click=${() => model.couplings.resetAll()}>${icon("reset")} ${lab().readings.resetAll} <kbd>0</kbd></button>`
            : nothing
        }
      </div>
      <p class="picture-lead" data-testid="lead" role="status">${isCoupled || content?.kind !== "model" ? withTerms(this.#lead()) : withTerms(words.onePart)}</p>
      <pg-loops .model=${model} .space=${this.app}></pg-loops>
      <div class="picture-measured">${isMeasured && isCoupled ? html`<pg-measured .model=${model} .body=${body} .readings=${readings}></pg-measured>` : nothing}</div>
      ${this.#foot()}`;
  }
}
customElements.define("pg-picture", PictureView);
