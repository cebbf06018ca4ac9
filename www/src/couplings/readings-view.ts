// What changed couplings do to the experts: one reading of them, or both side by side.
import { html } from "lit";
import type { Reading } from "../engine/protocol";
import type { SettingsStore } from "../settings/settings-store";
import "../terms/term";
import { icon } from "../ui/icons";
import { View } from "../ui/view";
import type { ModelStore } from "./model-store";
import type { ReadingsStore } from "./readings-store";
import "./readings-view.css";

const WORDS: Record<Reading, string> = {
  "re-inferred": "What the same clips would have taught each part’s predictions under these couplings.",
  "as learned": "Only the weights change: each part predicts as before, and counts for more or less.",
};

/** What docs/couplings.md found. */
const BESIDE =
  "Left: training made the experts as a team, and one left alone does only its share. Right: as the same clips teach one that was always alone.";

export class ReadingsView extends View {
  declare model: ModelStore;
  declare settings: SettingsStore;
  declare readings: ReadingsStore;

  protected override stores() {
    return [this.model, this.settings, this.readings];
  }

  protected override render() {
    const { model, readings } = this;
    const { reading } = this.settings.values;
    const { isBeside } = readings;
    const choice = (of: Reading, testId: string) => html`
      <button type="button" aria-pressed=${of === reading ? "true" : "false"} data-testid=${testId}
        @click=${() => model.couplings.setReading(of)}>${of}</button>`;
    return html`
      <fieldset class="readings">
        <legend>When a slider moves, the <pg-term of="expert" text="experts"></pg-term> are
          <pg-term of="reading" text="as learned or re-inferred"></pg-term></legend>
        <div class="segments">
          ${choice("re-inferred", "reading-inferred")}
          ${choice("as learned", "reading-learned")}
        </div>
        <p>${isBeside ? BESIDE : WORDS[reading]}</p>
        <div class="after">
          <button type="button" class="small" aria-pressed=${isBeside ? "true" : "false"} data-testid="readings-beside" ?disabled=${!model.model}
            @click=${() => readings.show(!isBeside)}>Both side by side</button>
          <button type="button" class="small" data-testid="reset-couplings" ?disabled=${!model.couplings.altered} @click=${() => model.couplings.resetAll()}>
            ${icon("reset")} Reset all <kbd>0</kbd></button>
        </div>
      </fieldset>`;
  }
}
customElements.define("pg-readings", ReadingsView);
