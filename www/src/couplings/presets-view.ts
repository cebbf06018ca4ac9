// The presets of the couplings.
import { html } from "lit";
import type { SettingsStore } from "../settings/settings-store";
import { View } from "../ui/view";
import type { ModelStore } from "./model-store";
import "./presets-view.css";

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
      <div class="presets" role="group" aria-label="Presets">${model.presets.map(
        (preset) => html`
        <button type="button" class="preset" aria-pressed=${preset === now || preset.id === now?.id ? "true" : "false"}
          title=${preset.meaning} data-testid="preset-${preset.id}" @click=${() => model.takePreset(preset)}>${preset.name}</button>`,
      )}</div>`;
  }
}
customElements.define("pg-presets", PresetsView);
