// The choices of a comparison: models, trials and settings.
import { html, nothing } from "lit";
import type { ClipsStore } from "../clips/clips-store";
import { type NumberName, settingField } from "../settings/setting-field";
import { BY_HAND, MODELS, numberOf, type SettingName, trialNumber, trialOf } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import { withTerms } from "../terms/term";
import type { TermName } from "../terms/terms";
import { numberField } from "../settings/number-field";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { View } from "../ui/view";
import type { ComparisonStore } from "./comparison-store";
import { modelStyle } from "../figures/model-style";
import type { CompareWords } from "./en";
import { compareWords } from "./view-words";
import { lab, shownPart, shownSplit } from "../words/lab";

/** The settings with a label. */
type FieldName = Exclude<keyof CompareWords["fields"], "byHand" | "growthNeeds" | "growthTimes">;

/** The movement of these clips, as the library names it. */
const BOTTLE = "pass a bottle";

const isTicked = (event: Event): boolean => (event.target as HTMLInputElement).checked;

export class ComparisonChoices extends View {
  declare comparison: ComparisonStore;
  declare settings: SettingsStore;
  declare clips: ClipsStore;
  declare notices: NoticesStore;
  #unfolded = true;

  /** Folds the choices, to show the results. */
  fold(): void {
    this.#unfolded = false;
    this.requestUpdate();
  }

  #field(name: SettingName & FieldName, term?: TermName, symbol = "?") {
    const { label, hint } = compareWords().fields[name];
    const about = lab().learn.field.about(label);
    const afterLabel = term && html`<pg-term of=${term} text=${symbol} about=${about}></pg-term>`;
    const field = { label, hint, testId: `compare-${name}`, disabled: this.comparison.busy };
    return { ...field, ...(afterLabel && { afterLabel }) };
  }

  #number(name: NumberName & FieldName, term?: TermName, symbol?: string) {
    return settingField(this.settings, name, this.#field(name, term, symbol));
  }

  #heldOut() {
    const { settings } = this;
    return numberField({
      ...this.#field("heldOut", "fold"),
      limits: trialNumber,
      value: numberOf(settings.values.heldOut),
      change(number) {
        settings.change({ heldOut: trialOf(number) });
        return numberOf(settings.values.heldOut);
      },
    });
  }

  #numbers(name: "ips" | "bases", term: TermName) {
    const { label, hint } = compareWords().fields[name];
    const about = lab().learn.field.about(label);
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
      <div class="field stack" title=${hint}><span><label for="field-${name}">${label}</label> <pg-term of=${term} text="?" about=${about}></pg-term></span>
        <input type="text" id="field-${name}" inputmode="numeric" data-testid="compare-${name}" .value=${settings.values[name].join(", ")}
          ?disabled=${comparison.busy} @change=${change} />
      </div>`;
  }

  #flag(name: "balanced" | "growth") {
    const { label, hint } = compareWords().fields[name];
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
    const words = compareWords().models;
    const change = (kind: (typeof MODELS)[number], on: boolean) =>
      settings.change({ models: MODELS.filter((other) => (other === kind ? on : models.includes(other))) });
    return html`
      <fieldset class="models stack">
        <legend>${words.title} <small>${withTerms(words.whatIs)}</small></legend>
        ${MODELS.map(
          (kind) => html`
          <label class="check">
            <input type="checkbox" data-testid="model-${kind}" .checked=${models.includes(kind)} ?disabled=${comparison.busy}
              @change=${(event: Event) => change(kind, isTicked(event))} />
            <span>${modelStyle(kind).name} <small class="own-line">${words.about[kind]}</small></span>
          </label>`,
        )}
      </fieldset>`;
  }

  async #loadBottle(): Promise<void> {
    const { settings, clips, notices } = this;
    try {
      settings.change({ parts: "body-arms", split: [] });
      await clips.loadMade(BOTTLE);
    } catch (problem) {
      notices.addError(compareWords().trials.bottle.load, messageOf(problem));
    }
  }

  /** Passing a bottle: its clips when asked for, and what this project found with them. */
  #bottle() {
    const { clips, comparison, settings } = this;
    const words = compareWords().trials.bottle;
    if (!clips.all.some(({ key }) => key.startsWith("made-bottle")))
      return html`<p class="hint">${words.about} <button class="small" data-testid="bottle" ?disabled=${comparison.busy || clips.locked || !clips.samplesLoaded}
        @click=${() => void this.#loadBottle()}>${words.load}</button></p>`;
    return html`<p class="hint" data-testid="bottle-found">${words.found}
      <button class="small" data-testid="bottle-watch" @click=${() => settings.change({ view: "play" })}>${words.watch}</button></p>`;
  }

  #trials() {
    const { clips, comparison } = this;
    const words = compareWords().trials;
    return html`
      <details class="trials">
        <summary>${words.title} <small>${words.ticked(clips.ticked.length, clips.all.length)}</small></summary>
        <ul>${clips.all.map(
          ({ key, title, ticked }) => html`
          <li><label class="check"><input type="checkbox" .checked=${ticked} ?disabled=${comparison.busy || clips.locked}
            @change=${(event: Event) => void clips.tick(key, isTicked(event))} /> ${title}</label></li>`,
        )}
        </ul>
        <p class="hint">${words.drop}</p>
        ${this.#bottle()}
      </details>`;
  }

  #parts() {
    const { settings, comparison, clips } = this;
    const [clip] = clips.ticked;
    const { parts } = settings.values;
    const names = clips.parts.map(({ name }) => shownPart(name)).join(", ");
    const words = compareWords().fields;
    return html`
      <label class="field stack wide" title=${words.parts.hint}><span>${words.parts.label}</span>
        <select data-testid="compare-parts" ?disabled=${comparison.busy || !clip}
          @change=${(event: Event) => settings.change({ parts: (event.target as HTMLSelectElement).value })}>
          ${(clip?.loaded.info.presets ?? []).map((preset) => html`<option value=${preset.id} ?selected=${preset.id === parts}>${shownSplit(preset)}</option>`)}
          ${parts === BY_HAND ? html`<option value=${BY_HAND} selected>${words.byHand(names)}</option>` : nothing}
        </select>
      </label>`;
  }

  /** What the figure of learning time still needs. */
  #growthWords(): string {
    const { outlook } = this.comparison;
    if (!this.settings.values.growth) return "";
    const { growthNeeds, growthTimes } = compareWords().fields;
    return outlook && !outlook.growth ? growthNeeds : growthTimes;
  }

  protected override render() {
    const toggle = (event: Event) => {
      this.#unfolded = (event.target as HTMLDetailsElement).open;
      this.requestUpdate();
    };
    return html`
      <details class="choices" ?open=${this.#unfolded} @toggle=${toggle}>
        <summary class="quiet">${compareWords().setup}</summary>
        ${this.#models()}
        ${this.#trials()}
        <div class="fields">
          ${this.#parts()}
          ${this.#numbers("ips", "inducing-point")}
          ${this.#numbers("bases", "bases")}
          ${this.#number("comparedIterations", "iterations")}
          ${this.#heldOut()}
        </div>
        ${this.#flag("growth")}
        <p class="hint">${this.#growthWords()}</p>
        <details class="advanced">
          <summary>${lab().learn.settings.advanced}</summary>
          <div class="fields">
            ${this.#number("seed", "seed")}
            ${this.#number("seeds")}
            ${this.#number("latent", "latent-space", "Q")}
            ${this.#number("order", "order", "p")}
            ${this.#number("framesPerSecond")}
          </div>
          ${this.#flag("balanced")}
        </details>
      </details>`;
  }
}
customElements.define("pg-comparison-choices", ComparisonChoices);
