// The presets of the couplings.
import { html } from "lit";
import type { SettingsStore } from "../settings/settings-store";
import { View } from "../ui/view";
import type { ModelStore } from "./model-store";
import "./presets-view.css";
import { lab } from "../words/lab";
import { presetWords } from "./presets";

export class PresetsView extends View {
  declare model: ModelStore;
  declare settings: SettingsStore;

  protected override stores() {
    return [this.model, this.settings];
  }

  protected override render() {
    const { model } = this;
    const now = model.preset;
    return html`
      <div class="presets" role="group" aria-label=${lab().presets.label}>${model.presets.map(
        (preset) => html`
        <button type="button" class="preset" aria-pressed=${preset === now || preset.id === now?.id ? "true" : "false"}
          title=${presetWords(preset).meaning} data-testid="preset-${preset.id}" @click=${() => model.takePreset(preset)}>${presetWords(preset).name}</button>`,
      )}</div>`;
  }
}
customElements.define("pg-presets", PresetsView);
