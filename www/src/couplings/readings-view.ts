// The choice of the reading of changed couplings: one of them, or both side by side.
import { html } from "lit";
import type { Reading } from "../engine/protocol";
import type { SettingsStore } from "../settings/settings-store";
import "../terms/term";
import { icon } from "../ui/icons";
import { View } from "../ui/view";
import type { ModelStore } from "./model-store";
import { READING_TEXT } from "./reading-text";
import type { ReadingsStore } from "./readings-store";
import "./readings-view.css";

const WORDS: Record<Reading, string> = {
  "re-inferred": "What the same clips would have taught each part’s predictions under these couplings.",
  "as-learned": "Only the weights change: each part predicts as before, and counts for more or less.",
};

/** The finding of docs/couplings.md. */
const BOTH =
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
    const { bothShown } = readings;
    const choice = (choice: Reading, testId: string) => html`
      <button type="button" aria-pressed=${choice === reading ? "true" : "false"} data-testid=${testId}
        @click=${() => model.couplings.setReading(choice)}>${READING_TEXT[choice]}</button>`;
    return html`
      <fieldset class="readings">
        <legend><pg-term of="expert" text="Experts"></pg-term>, when a coupling changes
          <pg-term of="reading" text="?" about="What do as learned and re-inferred mean?"></pg-term></legend>
        <div class="choices">
          <div class="segments">
            ${choice("re-inferred", "reading-inferred")}
            ${choice("as-learned", "reading-learned")}
          </div>
          <button type="button" class="small" aria-pressed=${bothShown ? "true" : "false"} data-testid="readings-beside" ?disabled=${!model.model}
            @click=${() => readings.show(!bothShown)}>Both side by side</button>
          <button type="button" class="small" data-testid="reset-couplings" ?disabled=${!model.couplings.altered} @click=${() => model.couplings.resetAll()}>
            ${icon("reset")} Reset all <kbd>0</kbd></button>
        </div>
        <p>${bothShown ? BOTH : model.couplings.altered ? WORDS[reading] : ""}</p>
      </fieldset>`;
  }
}
customElements.define("pg-readings", ReadingsView);
