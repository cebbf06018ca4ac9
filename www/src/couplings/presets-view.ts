// The presets of the couplings, the measures of the motion, and the phase clock.
import { html, nothing } from "lit";
import type { Reading } from "../engine/protocol";
import type { SettingsStore } from "../settings/settings-store";
import type { Playback } from "../stage/playback";
import "../terms/term";
import { partColour } from "../ui/palette";
import { View } from "../ui/view";
import type { BodyStore } from "./body-store";
import { measuresText } from "./measures-text";
import type { ModelStore } from "./model-store";
import "./phase-clock";
import type { PhasesStore } from "./phases-store";
import { START_PRESETS } from "./presets";
import "./presets-view.css";
import { partStyle } from "../ui/styled";
import { READING_TEXT } from "./reading-text";

/** More presets than this are shown in one row that scrolls. */
const ONE_ROW = START_PRESETS.length;

export class PresetsView extends View {
  declare model: ModelStore;
  declare settings: SettingsStore;
  declare body: BodyStore;
  declare phases: PhasesStore;
  declare playback: Playback;

  protected override stores() {
    return [this.model, this.settings, this.body];
  }

  #buttons() {
    const { model } = this;
    const now = model.preset;
    return model.presets.map(
      (preset) => html`
      <button type="button" class="preset" aria-pressed=${preset === now || preset.id === now?.id ? "true" : "false"}
        data-testid="preset-${preset.id}" @click=${() => model.takePreset(preset)}>${preset.name}</button>`,
    );
  }

  #measured() {
    const { reports, isCurrent } = this.body;
    if (!reports) return nothing;
    const names = (this.model.model?.info.parts ?? []).map(({ name }) => name);
    const { parts, step, trouble } = measuresText(reports.now, reports.learned, names);
    const end = [
      step && html`<span data-testid="measured-step">${step}</span>`,
      trouble && html`<strong class="bad" data-testid="measured-trouble">${trouble}</strong>`,
    ];
    return html`
      <p class="measured" role="status" data-testid="measured" data-current=${isCurrent ? "yes" : "no"}>
        <span><pg-term of="measured" text="Measured"></pg-term>, compared with as learned:</span>
        ${parts.map(
          ({ part, words }) => html`
          <span class="limbs" data-testid="measured-${part}" style=${partStyle(partColour(part))}><i class="swatch"></i>${names[part]} ${words}</span>`,
        )}
        ${end}
      </p>`;
  }

  protected override render() {
    const { model } = this;
    if (model.presets.length === 0) return nothing;
    return html`
      <div class="presets" role="group" aria-label="Presets" ?data-many=${model.presets.length > ONE_ROW}>${this.#buttons()}</div>
      <div class="effect">
        <p data-testid="preset-sentence">${model.preset?.sentence ?? ownText(this.settings.values.reading)}</p>
        ${this.#measured()}
        <pg-phase-clock .phases=${this.phases} .playback=${this.playback}></pg-phase-clock>
      </div>`;
  }
}
customElements.define("pg-presets", PresetsView);

function ownText(reading: Reading): string {
  return `Couplings of your own, the experts ${READING_TEXT[reading]}.`;
}
