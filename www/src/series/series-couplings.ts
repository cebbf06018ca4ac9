// The couplings of a model of tables, and the effect of changed couplings on the experts.
import { html, nothing } from "lit";
import "../couplings/couplings.css";
import { couplingsTable } from "../couplings/couplings-table";
import { readingText } from "../couplings/reading-text";
import type { Reading } from "../engine/protocol";
import type { SeriesStore } from "./series-store";

const READINGS: [Reading, string][] = [
  [
    "re-inferred",
    "Under changed couplings the experts are inferred again from what the training left of the data",
  ],
  ["as-learned", "The experts stay as learned; only how much each counts is changed"],
];

export function seriesCouplings(model: SeriesStore) {
  const { opened, couplings } = model;
  if (!opened?.info.alpha) {
    return html`<p class="hint">A model of this kind has no couplings and no latent spaces: only its curves are shown.</p>`;
  }
  return html`
    ${couplingsTable({
      couplings,
      parts: opened.info.parts.map(({ name }) => name),
    })}
    <div class="button-row">
      <span class="segments" role="group" aria-label="What a changed coupling means">
        ${READINGS.map(
          ([
            reading,
            meaning,
          ]) => html`<button title=${meaning} aria-pressed=${couplings.reading === reading ? "true" : "false"}
            @click=${() => couplings.setReading(reading)}>${readingText(reading)}</button>`,
        )}</span>
      <button class="small" data-testid="series-reset" ?disabled=${!couplings.altered} @click=${() => couplings.resetAll()}>All as learned</button>
    </div>
    ${model.problem ? html`<p class="bad" role="alert">${model.problem}</p>` : nothing}`;
}
