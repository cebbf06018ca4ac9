// A table of couplings: a row for each part that decides, a column for each part that it decides about.
import { html, nothing, type TemplateResult } from "lit";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { type CouplingCell, couplingCell } from "./coupling-cell";
import type { CouplingsStore } from "./couplings-store";
import { lab } from "../words/lab";

export interface CouplingsTable extends Partial<Pick<CouplingCell, "trained" | "prefix">> {
  couplings: CouplingsStore;
  /** The names of the parts. */
  parts: readonly string[];
  /** Drawn above the cells of a part. */
  above?: (target: number) => TemplateResult;
}

export function couplingsTable({ couplings, parts, above, trained = true, prefix = "" }: CouplingsTable) {
  const words = lab().couplings;
  const head = (part: number) =>
    html`<span class="part-name" style=${partStyle(partColour(part))}><i class="swatch"></i>${parts[part] ?? ""}</span>`;
  const cell = (source: number, target: number) => {
    const names: CouplingCell["names"] = [parts[source] ?? "", parts[target] ?? ""];
    return couplingCell({ couplings, source, target, names, trained, prefix });
  };
  return html`
    <div class="table-box">
      <table class="couplings" data-parts=${parts.length}>
        <thead>
          <tr>
            <td><small>${words.decides}</small></td>
            ${parts.map((_, target) => html`<th scope="col"><small>${words.about}</small> ${head(target)}</th>`)}
          </tr>
          ${above ? html`<tr><td></td>${parts.map((_, target) => html`<td>${above(target)}</td>`)}</tr>` : nothing}
        </thead>
        <tbody>
          ${parts.map(
            (_, source) => html`
            <tr>
              <th scope="row">${head(source)}</th>
              ${parts.map((__, target) => cell(source, target))}
            </tr>`,
          )}
        </tbody>
      </table>
    </div>`;
}
