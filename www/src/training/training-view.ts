// The settings of a training, and its chart.
import { html, nothing } from "lit";
import type { ClipsStore } from "../clips/clips-store";
import type { EngineStore } from "../engine/engine-store";
import { type NumberName, settingField, settingInput } from "../settings/setting-field";
import { BY_HAND, POSE_WEIGHTS } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import { fixed } from "../ui/format";
import { icon } from "../ui/icons";
import { partColour } from "../ui/palette";
import { View } from "../ui/view";
import "../terms/term";
import type { TermName } from "../terms/terms";
import "./bound-chart";
import "./training.css";
import type { TrainingStore } from "./training-store";
import { type LearnWords, lab, shownPart, shownSplit } from "../words/lab";
import { partStyle } from "../ui/styled";

export class TrainingView extends View {
  declare training: TrainingStore;
  declare settings: SettingsStore;
  declare clips: ClipsStore;
  declare engine: EngineStore;

  #count(name: Exclude<NumberName & keyof LearnWords["settings"], "seed">, term?: TermName, symbol = "?") {
    const { field, settings } = lab().learn;
    const { label, hint } = settings[name];
    // Trainings of one session have the same data, so that their bounds can be compared.
    const disabled = this.training.busy && name === "framesPerSecond";
    const afterLabel =
      term && html`<pg-term of=${term} text=${symbol} about=${field.about(label)}></pg-term>`;
    const usual = name === "dynamicsIps" || name === "poseIps" ? this.training.usual?.[name] : undefined;
    const input = { testId: `setting-${name}`, disabled, ...(afterLabel && { afterLabel }) };
    return settingField(this.settings, name, { label, hint, ...input }, usual);
  }

  /** Why the library gives these clips as many inducing points. */
  #whyPoints() {
    const { usual } = this.training;
    const { dynamicsIps, poseIps } = this.settings.values;
    if (!usual || (dynamicsIps > 0 && poseIps > 0)) return nothing;
    const words = lab().learn.settings.whyPoints(usual.dynamicsIps, fixed(usual.longest, 1));
    return html`<p class="hint" data-testid="why-points">${words}</p>`;
  }

  #partsField() {
    const { clips } = this;
    const [clip] = clips.ticked;
    const presets = clip?.loaded.info.presets ?? [];
    const { parts } = this.settings.values;
    const words = lab().learn.settings;
    const byHand = parts === BY_HAND;
    // The editor is loaded at its first use; after a failure the next change tries again.
    if (byHand) import("../clips/parts-editor").catch(() => {});
    const chosen = byHand ? BY_HAND : (presets.find(({ id }) => id === parts) ?? presets[0])?.id;
    const choose = (event: Event) => {
      const { value } = event.target as HTMLSelectElement;
      clips.setParts(value === BY_HAND ? { parts: BY_HAND, split: clips.parts } : { parts: value });
    };
    return html`
      <div class="field stack wide">
        <span><pg-term of="part" text=${words.parts}></pg-term></span>
        <select data-testid="setting-parts" aria-label=${words.parts} ?disabled=${clips.locked || !clip} @change=${choose}>
          ${presets.map((preset) => html`<option value=${preset.id} ?selected=${preset.id === chosen}>${shownSplit(preset)}</option>`)}
          <option value=${BY_HAND} ?selected=${byHand}>${words.byHand}</option>
        </select>
      </div>
      <ul class="part-row wrap note" aria-label=${words.partsToTrain}>
        ${clips.parts.map(
          ({ name, joints }, part) => html`
          <li class="row" style=${partStyle(partColour(part))}><i class="swatch"></i>${shownPart(name)} <small>${words.joints(joints.length)}</small></li>`,
        )}
      </ul>
      ${byHand && clip ? html`<pg-parts-editor .settings=${this.settings} .clips=${clips}></pg-parts-editor>` : nothing}`;
  }

  protected override render() {
    const { training, settings } = this;
    const { asInPapers } = settings.values;
    const { field, settings: names, training: words } = lab().learn;
    return html`
      <h2>${words.title}</h2>
      <div class="fields main-fields">
        ${this.#partsField()}
        ${this.#count("latent", "latent-space", "Q")}
        ${this.#count("dynamicsIps", "dynamics-points", "K")}
        ${this.#count("poseIps", "pose-points", "L")}
        ${this.#count("framesPerSecond")}
      </div>
      ${this.#whyPoints()}
      <label class="tick-label row" title=${names.asInPapers.hint}>
        <input type="checkbox" data-testid="setting-asInPapers" .checked=${asInPapers}
          @change=${() => settings.change({ asInPapers: !asInPapers })} />
        ${names.asInPapers.label}</label>
      <details class="advanced">
        <summary>${names.advanced}</summary>
        <div class="fields">
          <div class="field stack seed">
            <span><label for="seed-input">${names.seed}</label> <pg-term of="seed" text="?" about=${field.about(names.seed)}></pg-term></span>
            ${settingInput(settings, "seed", { id: "seed-input", testId: "setting-seed", disabled: false })}
            <button class="round" aria-label=${names.newSeed} title=${names.newSeed} ?disabled=${!this.engine.engine} @click=${() => void training.newSeed()}>${icon("dice")}</button>
          </div>
          ${this.#count("trainings")}
          ${this.#count("order", "order", "p")}
          ${this.#count("maxIterations", "iterations")}
          <label class="field stack"><span>${names.poseWeight.label}</span>
            <select data-testid="setting-poseWeight" title=${names.poseWeight.hint} ?disabled=${asInPapers}
              @change=${(event: Event) => settings.change({ poseWeight: POSE_WEIGHTS[(event.target as HTMLSelectElement).selectedIndex] ?? "balanced" })}>
              ${POSE_WEIGHTS.map((weight) => html`<option ?selected=${weight === training.poseWeight}>${names.poseWeight.value(weight)}</option>`)}
            </select></label>
        </div>
      </details>
      <pg-bound-chart .training=${training}></pg-bound-chart>`;
  }
}
customElements.define("pg-training", TrainingView);
