// A table of couplings: a row for each part that decides, a column for each part that it decides about.
import { html } from "lit";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { type CouplingSlider, couplingSlider } from "./coupling-slider";
import type { CouplingsStore } from "./couplings-store";
import { lab } from "../words/lab";

export interface CouplingsTable extends Pick<CouplingSlider, "trained" | "prefix"> {
  couplings: CouplingsStore;
  /** The names of the parts. */
  parts: readonly string[];
}

export function couplingsTable({ couplings, parts, ...how }: CouplingsTable) {
  const words = lab().couplings;
  const head = (part: number) =>
    html`<span class="part-name" style=${partStyle(partColour(part))}><i class="swatch"></i>${parts[part] ?? ""}</span>`;
  const cell = (source: number, target: number) => {
    const names = [parts[source] ?? "", parts[target] ?? ""] as const;
    return html`<td>${couplingSlider({ couplings, source, target, names, ...how })}</td>`;
  };
  return html`
    <div class="table-box">
      <table class="couplings" data-parts=${parts.length}>
        <thead>
          <tr>
            <td><small>${words.decides}</small></td>
            ${parts.map((_, target) => html`<th scope="col"><small>${words.about}</small> ${head(target)}</th>`)}
          </tr>
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
