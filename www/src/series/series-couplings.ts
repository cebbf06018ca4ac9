// The couplings of a model of tables, and the effect of changed couplings on the experts.
import { html, nothing } from "lit";
import { couplingsTable } from "../couplings/couplings-table";
import { readingText } from "../couplings/reading-text";
import type { Reading } from "../engine/protocol";
import type { SeriesStore } from "./series-store";
import { seriesWords } from "../words/series";

const READINGS: readonly Reading[] = ["re-inferred", "as-learned"];

export function seriesCouplings(model: SeriesStore) {
  const { opened, couplings } = model;
  const words = seriesWords();
  if (!opened?.info.alpha) {
    return html`<p class="hint">${words.noCouplings}</p>`;
  }
  return html`
    ${couplingsTable({
      couplings,
      parts: opened.info.parts.map(({ name }) => name),
    })}
    <div class="button-row">
      <span class="segments" role="group" aria-label=${words.changed}>
        ${READINGS.map(
          (
            reading,
          ) => html`<button title=${words.readings[reading]} aria-pressed=${couplings.reading === reading ? "true" : "false"}
            @click=${() => couplings.setReading(reading)}>${readingText(reading)}</button>`,
        )}</span>
      <button class="small" data-testid="series-reset" ?disabled=${!couplings.altered} @click=${() => couplings.resetAll()}>${words.reset}</button>
    </div>
    ${model.problem ? html`<p class="bad" role="alert">${model.problem}</p>` : nothing}`;
}
