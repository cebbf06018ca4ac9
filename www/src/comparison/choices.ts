// The choices of a comparison: models, trials and settings.
import { html, nothing } from "lit";
import type { ClipsStore } from "../clips/clips-store";
import { type NumberName, settingField } from "../settings/setting-field";
import { BY_HAND, MODELS, numberOf, type SettingName, trialNumber, trialOf } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import "../terms/term";
import type { TermName } from "../terms/terms";
import { numberField } from "../settings/number-field";
import { View } from "../ui/view";
import type { ComparisonStore } from "./comparison-store";
import { modelStyle } from "../figures/model-style";

/** A line about each kind of model. */
const ABOUT: Record<(typeof MODELS)[number], string> = {
  vcgpdm: "The coupled model of this page",
  vgpdm: "The same, with the whole body as one part",
  "map-gpdm": "Point latents instead of distributions; slow",
  "map-cgpdm": "The same, with coupled parts; slowest",
  tmp: "Weighted curves over a common phase",
  "dmp-discrete": "A spring pulled towards a goal",
  "dmp-rhythmic": "A spring pulled around a cycle",
};

const isTicked = (event: Event): boolean => (event.target as HTMLInputElement).checked;

export class ComparisonChoices extends View {
  static override properties = { unfolded: { state: true } };
  declare comparison: ComparisonStore;
  declare settings: SettingsStore;
  declare clips: ClipsStore;
  declare unfolded: boolean;

  constructor() {
    super();
    this.unfolded = true;
  }

  protected override stores() {
    return [this.comparison, this.settings, this.clips];
  }

  /** Folds the choices, to show the results. */
  fold(): void {
    this.unfolded = false;
  }

  #field(name: SettingName, label: string, hint: string, term?: TermName, symbol = "?") {
    const afterLabel =
      term && html`<pg-term of=${term} text=${symbol} about="${label}: what is that?"></pg-term>`;
    const field = { label, hint, testId: `compare-${name}`, disabled: this.comparison.busy };
    return { ...field, ...(afterLabel && { afterLabel }) };
  }

  #number(name: NumberName, label: string, hint: string, term?: TermName, symbol?: string) {
    return settingField(this.settings, name, this.#field(name, label, hint, term, symbol));
  }

  #heldOut() {
    const { settings } = this;
    const hint = "The trial held out, counted from 1; 0: each in turn";
    return numberField({
      ...this.#field("heldOut", "Only trial (0: each)", hint, "fold"),
      limits: trialNumber,
      value: numberOf(settings.values.heldOut),
      change(number) {
        settings.change({ heldOut: trialOf(number) });
        return numberOf(settings.values.heldOut);
      },
    });
  }

  #numbers(name: "ips" | "bases", label: string, hint: string, term: TermName) {
    const { settings, comparison } = this;
    const change = (event: Event) => {
      const input = event.target as HTMLInputElement;
      const numbers = input.value
        .split(/[\s,]+/)
        .filter(Boolean)
        .map(Number);
      settings.change({ [name]: numbers });
      input.value = settings.values[name].join(", ");
    };
    return html`
      <div class="field" title=${hint}><span><label for="field-${name}">${label}</label> <pg-term of=${term} text="?" about="${label}: what is that?"></pg-term></span>
        <input type="text" id="field-${name}" inputmode="numeric" data-testid="compare-${name}" .value=${settings.values[name].join(", ")}
          ?disabled=${comparison.busy} @change=${change} />
      </div>`;
  }

  #flag(name: "balanced" | "growth", label: string, hint: string) {
    const { settings, comparison } = this;
    return html`
      <label class="check" title=${hint}>
        <input type="checkbox" data-testid="compare-${name}" .checked=${settings.values[name]} ?disabled=${comparison.busy}
          @change=${(event: Event) => settings.change({ [name]: isTicked(event) })} />
        ${label}</label>`;
  }

  #models() {
    const { settings, comparison } = this;
    const { models } = settings.values;
    const change = (kind: (typeof MODELS)[number], on: boolean) =>
      settings.change({ models: MODELS.filter((other) => (other === kind ? on : models.includes(other))) });
    return html`
      <fieldset class="models">
        <legend>Models <small>What is <pg-term of="map" text="MAP"></pg-term>, <pg-term of="tmp" text="TMP"></pg-term>,
          <pg-term of="dmp" text="DMP"></pg-term>?</small></legend>
        ${MODELS.map(
          (kind) => html`
          <label class="check">
            <input type="checkbox" data-testid="model-${kind}" .checked=${models.includes(kind)} ?disabled=${comparison.busy}
              @change=${(event: Event) => change(kind, isTicked(event))} />
            <span>${modelStyle(kind).name} <small>${ABOUT[kind]}</small></span>
          </label>`,
        )}
      </fieldset>`;
  }

  #trials() {
    const { clips, comparison } = this;
    return html`
      <details class="trials">
        <summary>Trials <small>${clips.ticked.length} of ${clips.all.length} clips ticked</small></summary>
        <ul>${clips.all.map(
          ({ key, title, ticked }) => html`
          <li><label class="check"><input type="checkbox" .checked=${ticked} ?disabled=${comparison.busy || clips.locked}
            @change=${(event: Event) => void clips.tick(key, isTicked(event))} /> ${title}</label></li>`,
        )}
        </ul>
        <p class="hint">Drop your own clips (.bvh) anywhere on the page.</p>
      </details>`;
  }

  #parts() {
    const { settings, comparison, clips } = this;
    const [clip] = clips.ticked;
    const { parts } = settings.values;
    const names = clips.parts.map(({ name }) => name).join(", ");
    return html`
      <label class="field wide" title="How the coupled models split the body"><span>Parts of the coupled models</span>
        <select data-testid="compare-parts" ?disabled=${comparison.busy || !clip}
          @change=${(event: Event) => settings.change({ parts: (event.target as HTMLSelectElement).value })}>
          ${(clip?.loaded.info.presets ?? []).map(({ id, title }) => html`<option value=${id} ?selected=${id === parts}>${title}</option>`)}
          ${parts === BY_HAND ? html`<option value=${BY_HAND} selected>By hand: ${names}</option>` : nothing}
        </select>
      </label>`;
  }

  /** What the figure of learning time still needs. */
  #growthWords(): string {
    const { outlook } = this.comparison;
    if (!this.settings.values.growth) return "";
    return outlook && !outlook.growth
      ? "Needs the vCGPDM or the MAP CGPDM, and four trials or more."
      : "Times are taken with all workers busy; the terminal can measure alone.";
  }

  protected override render() {
    const toggle = (event: Event) => {
      this.unfolded = (event.target as HTMLDetailsElement).open;
    };
    return html`
      <details class="choices" ?open=${this.unfolded} @toggle=${toggle}>
        <summary>What to compare</summary>
        ${this.#models()}
        ${this.#trials()}
        <div class="fields">
          ${this.#parts()}
          ${this.#numbers("ips", "Inducing points", "Of every dynamics map and every pose map of the variational models; several to compare", "inducing-point")}
          ${this.#numbers("bases", "DMP bases", "Basis functions of every column of the DMPs; several to compare", "bases")}
          ${this.#number("comparedIterations", "Iterations at most", "Of the optimiser, for every model that has one", "iterations")}
          ${this.#heldOut()}
        </div>
        ${this.#flag("growth", "Learning time against frames", "Trains the vCGPDM and the MAP CGPDM also on fewer trials")}
        <p class="hint">${this.#growthWords()}</p>
        <details class="advanced">
          <summary>Advanced</summary>
          <div class="fields">
            ${this.#number("seed", "First seed", "Of everything random", "seed")}
            ${this.#number("seeds", "Seeds", "How many, from the first on")}
            ${this.#number("latent", "Latent dimensions", "Of every part", "latent-space", "Q")}
            ${this.#number("order", "Frames of history", "The order of the dynamics", "order", "p")}
            ${this.#number("framesPerSecond", "Frames a second", "Clips are resampled to this rate")}
          </div>
          ${this.#flag("balanced", "Balanced MAP models", "Their dynamics weigh as much as their many columns (Urtasun, Fleet and Fua 2006)")}
        </details>
      </details>`;
  }
}
customElements.define("pg-comparison-choices", ComparisonChoices);
