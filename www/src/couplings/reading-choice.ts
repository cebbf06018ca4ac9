// The choice of what changed couplings do to the experts.
import { html } from "lit";
import { type CouplingsStore, READINGS } from "./couplings-store";
import { lab } from "../words/lab";

export function readingChoice(couplings: CouplingsStore) {
  const { label, meaning, text } = lab().readings;
  const now = couplings.reading;
  const choose = (event: Event) =>
    couplings.setReading(READINGS[(event.target as HTMLSelectElement).selectedIndex] ?? "re-inferred");
  return html`
    <label class="reading" title=${meaning[now]}>${label}
      <select data-testid="reading" @change=${choose}>
        ${READINGS.map((reading) => html`<option value=${reading} .selected=${reading === now}>${text[reading]}</option>`)}
      </select></label>`;
}
