// The couplings of a model of tables, and what a changed one does to the experts.
import { html, nothing } from "lit";
import { couplingCell } from "../couplings/coupling-cell";
import "../couplings/couplings.css";
import { couplingsTable } from "../couplings/couplings-table";
import { weightOf } from "../couplings/shares";
import type { Couplings, Reading } from "../engine/protocol";
import type { SeriesStore } from "./series-store";

const READINGS: [Reading, string, string][] = [
  [
    "re-inferred",
    "re-inferred",
    "Under changed couplings the experts are inferred again from what the training left of the data",
  ],
  ["as learned", "as learned", "The experts stay as learned; only how much each counts is changed"],
];

export function seriesCouplings(model: SeriesStore) {
  const { known, alpha, altered } = model;
  if (!known || !alpha) {
    return html`<p class="hint">A model of this kind has no couplings and no latent spaces: only its curves are shown.</p>`;
  }
  return html`
    ${couplingsTable({
      parts: known.info.parts.map(({ name }) => name),
      cell: (source, target) => cell(model, alpha, source, target),
    })}
    <div class="button-row">
      <span class="segments" role="group" aria-label="What a changed coupling means">
        ${READINGS.map(
          ([
            reading,
            words,
            meaning,
          ]) => html`<button title=${meaning} aria-pressed=${model.reading === reading ? "true" : "false"}
            @click=${() => model.setReading(reading)}>${words}</button>`,
        )}</span>
      <button class="small" data-testid="series-reset" ?disabled=${!altered} @click=${() => model.resetCouplings()}>All as learned</button>
    </div>
    ${model.problem ? html`<p class="bad" role="alert">${model.problem}</p>` : nothing}`;
}

function cell(model: SeriesStore, alpha: Couplings, source: number, target: number) {
  const { info } = model.known ?? {};
  const name = (part: number) => info?.parts[part]?.name ?? "";
  const now = alpha[source]?.[target] ?? 1;
  const learned = info?.alpha?.[source]?.[target] ?? 1;
  return couplingCell({
    source,
    target,
    names: [name(source), name(target)],
    alpha: now,
    before: learned,
    learned: true,
    weight: weightOf(alpha, source, target),
    changed: now !== learned,
    change: (value) => model.setCoupling(source, target, value),
    reset: () => model.resetCoupling(source, target),
  });
}
