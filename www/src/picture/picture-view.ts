// The picture of the Lab next to the figure: a loop for each part, and between the loops the couplings with the
// sliders of alpha. Below it what the couplings do, measured, and the buttons for everything else.
import { html, nothing } from "lit";
import type { ClipsStore } from "../clips/clips-store";
import type { BodyStore } from "../couplings/body-store";
import "../couplings/coupling-view";
import type { Way } from "../couplings/coupling-view";
import { READINGS } from "../couplings/couplings-store";
import "../couplings/measured-view";
import type { ModelStore } from "../couplings/model-store";
import { presetWords } from "../couplings/presets";
import type { ReadingsStore } from "../couplings/readings-store";
import type { EngineStore } from "../engine/engine-store";
import type { ModelInfo } from "../engine/protocol";
import "../latents/latent-plot";
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
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import { lab, shownPart } from "../words/lab";
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
  static override properties = { panels: {}, chosen: { state: true }, one: { state: true } };
  declare app: PictureStores;
  /** The panels that can be opened. */
  declare panels: readonly Panel[];
  /** With three parts or more: the part whose sliders are visible. */
  declare chosen: number;
  /** On a phone: the coupling whose slider is visible, as "source.target". */
  declare one: string;

  constructor() {
    super();
    this.panels = PANELS;
    this.chosen = 0;
    this.one = "0.1";
  }

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

  #reading() {
    const { model, settings } = this.app;
    const { label, meaning } = lab().readings;
    const now = settings.values.reading;
    const choose = (event: Event) =>
      model.couplings.setReading(
        READINGS[(event.target as HTMLSelectElement).selectedIndex] ?? "re-inferred",
      );
    return html`
      <label class="reading" title=${meaning[now]}>${label}
        <select data-testid="reading" @change=${choose}>
          ${READINGS.map((reading) => html`<option value=${reading} .selected=${reading === now}>${lab().readings.text[reading]}</option>`)}
        </select></label>`;
  }

  /** What the couplings now are, or what to try. */
  #lead(): string {
    const { stage, model, training } = this.app;
    const { lead, otherKind } = lab().stage;
    if (stage.content?.kind === "clip") return lead.clip;
    if (stage.content?.kind !== "model") return otherKind.noCouplings;
    if (stage.content.live) return lead.live;
    if (model.couplings.altered) {
      const { bothShown } = this.app.readings;
      if (bothShown) return lab().readings.both;
      return model.preset ? presetWords(model.preset).meaning : lead.own;
    }
    return training.learning ? lead.learning : lead.drag;
  }

  #coupling(source: number, target: number, way: Way) {
    const key = `${source}.${target}`;
    return html`<pg-coupling .model=${this.app.model} .source=${source} .target=${target} .way=${way} data-one=${key === this.one ? "yes" : "no"}></pg-coupling>`;
  }

  /** A part: its name, the coupling with itself, and its latent space. */
  #loop(info: ModelInfo, part: number) {
    const { model, pointing, predictions, settings, stage, playback, layers } = this.app;
    const name = shownPart(info.parts[part]?.name ?? "");
    const choice = info.parts.length > 2;
    const label = html`<i class="swatch"></i>${name}`;
    const isChosen = this.#chosenOf(info) === part;
    return html`
      <section class="loop" style=${partStyle(partColour(part))} aria-label=${name}>
        ${
          choice
            ? html`<button class="loop-name" aria-pressed=${isChosen ? "true" : "false"} title=${lab().couplings.slidersOf(name)}
              data-testid="part-${part}" @click=${() => {
                this.chosen = part;
              }}>${label}</button>`
            : html`<span class="loop-name">${label}</span>`
        }
        <pg-latent-plot .bodyPart=${part} .layers=${layers} .model=${model} .pointing=${pointing} .predictions=${predictions}
          .settings=${settings} .stage=${stage} .playback=${playback}></pg-latent-plot>
        ${info.alpha.length > 0 && (!choice || isChosen) ? this.#coupling(part, part, "itself") : nothing}
      </section>`;
  }

  #chosenOf({ parts }: ModelInfo): number {
    return Math.min(this.chosen, parts.length - 1);
  }

  /** The first part, often the legs, is the lowest. */
  #loops(info: ModelInfo) {
    const count = info.parts.length;
    const parts = info.parts.map((_, part) => part).reverse();
    const chosen = this.#chosenOf(info);
    const between = (part: number) => {
      if (count < 2) return nothing;
      if (count === 2)
        return part === 1
          ? html`<div class="between">${this.#coupling(0, 1, "up")}${this.#coupling(1, 0, "down")}</div>`
          : nothing;
      const others = parts.filter((other) => other !== part);
      return part === chosen
        ? html`<div class="between">${others.map((source) => this.#coupling(source, part, "up"))}</div>`
        : nothing;
    };
    return html`
      <div class=${count > 2 ? "loops many" : "loops"}>
        ${parts.map((part) => html`${this.#loop(info, part)}${between(part)}`)}
      </div>`;
  }

  /** On a phone one slider is visible at a time. */
  #oneAtATime({ parts, alpha }: ModelInfo) {
    const { toOther, oneSlider } = lab().couplings;
    const name = (part: number) => shownPart(parts[part]?.name ?? "");
    const pairs = alpha.flatMap((row, source) => row.map((_, target) => [source, target] as const));
    const choose = (event: Event) => {
      this.one = (event.target as HTMLSelectElement).value;
      this.chosen = Number(this.one.split(".")[1]);
    };
    return html`
      <select class="one-slider" aria-label=${oneSlider} data-testid="one-slider" @change=${choose}>
        ${pairs.map(([source, target]) => html`<option value="${source}.${target}" .selected=${`${source}.${target}` === this.one}>${toOther(name(source), name(target))}</option>`)}
      </select>`;
  }

  #foot() {
    const { settings, training, clips } = this.app;
    const { panel: open } = settings.values;
    const words = lab().page.panels;
    const toggle = (panel: Panel) => () => settings.change({ panel: panel === open ? "none" : panel });
    return html`
      <div class="picture-foot">
        ${this.panels.includes("learn") ? html`<pg-train .training=${training} .clips=${clips}></pg-train>` : html`<span></span>`}
        <div class="panel-buttons">
          ${this.panels.map(
            (panel) => html`
            <button id="open-${panel}" aria-expanded=${panel === open ? "true" : "false"} aria-controls="panel-${panel}"
              @click=${toggle(panel)}>${words[panel]}</button>`,
          )}
        </div>
      </div>`;
  }

  protected override render() {
    const { model, body, readings, engine, stage } = this.app;
    const info = model.model?.info;
    const words = lab().couplings;
    if (!info)
      return html`<p class="empty">${engine.state === "failed" ? words.failed : words.empty}</p>${this.#foot()}`;
    const isCoupled = info.parts.length > 1;
    const { content } = stage;
    const isMeasured = content?.kind === "model" && !content.live;
    return html`
      <div class="picture-head" role="group" aria-label=${words.map}>
        ${isCoupled ? [this.#presets(), this.#reading(), this.#oneAtATime(info)] : nothing}
        ${
          model.couplings.altered
            ? html`<button data-testid="reset-couplings" @click=${() => model.couplings.resetAll()}>${icon("reset")} ${lab().readings.resetAll} <kbd>0</kbd></button>`
            : nothing
        }
      </div>
      <p class="picture-lead" data-testid="lead" role="status">${isCoupled || content?.kind !== "model" ? withTerms(this.#lead()) : withTerms(words.onePart)}</p>
      ${this.#loops(info)}
      <div class="picture-measured">${isMeasured && isCoupled ? html`<pg-measured .model=${model} .body=${body} .readings=${readings}></pg-measured>` : nothing}</div>
      ${this.#foot()}`;
  }
}
customElements.define("pg-picture", PictureView);
