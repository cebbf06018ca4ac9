// The choice of the reading of changed couplings: one of them, or both side by side.
import { html } from "lit";
import type { Reading } from "../engine/protocol";
import type { SettingsStore } from "../settings/settings-store";
import { withTerms } from "../terms/term";
import { icon } from "../ui/icons";
import { View } from "../ui/view";
import type { ModelStore } from "./model-store";
import type { ReadingsStore } from "./readings-store";
import "./readings-view.css";
import { lab } from "../words/lab";

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
    const words = lab().readings;
    const choice = (choice: Reading, testId: string) => html`
      <button type="button" aria-pressed=${choice === reading ? "true" : "false"} data-testid=${testId}
        @click=${() => model.couplings.setReading(choice)}>${words.text[choice]}</button>`;
    return html`
      <fieldset class="readings">
        <legend>${withTerms(words.label)}
          <pg-term of="reading" text="?" about=${words.about}></pg-term></legend>
        <div class="choices">
          <div class="segments">
            ${choice("re-inferred", "reading-inferred")}
            ${choice("as-learned", "reading-learned")}
          </div>
          <button type="button" class="small" aria-pressed=${bothShown ? "true" : "false"} data-testid="readings-beside" ?disabled=${!model.model}
            @click=${() => readings.show(!bothShown)}>${words.bothButton}</button>
          <button type="button" class="small" data-testid="reset-couplings" ?disabled=${!model.couplings.altered} @click=${() => model.couplings.resetAll()}>
            ${icon("reset")} ${words.resetAll} <kbd>0</kbd></button>
        </div>
        <p>${bothShown ? words.both : model.couplings.altered ? words.meaning[reading] : ""}</p>
      </fieldset>`;
  }
}
customElements.define("pg-readings", ReadingsView);
