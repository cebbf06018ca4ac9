// The frame of a table of couplings: a row for each part that decides, a column for each that it decides
// about.
import { html, nothing, type TemplateResult } from "lit";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";

export interface CouplingsTable {
  /** The names of the parts. */
  parts: readonly string[];
  /** A cell, `<td>`. */
  cell(source: number, target: number): TemplateResult;
  /** What stands above the cells of a part. */
  above?: (target: number) => TemplateResult;
}

export function couplingsTable({ parts, cell, above }: CouplingsTable) {
  const head = (part: number) =>
    html`<span class="part-name" style=${partStyle(partColour(part))}><i class="swatch"></i>${parts[part] ?? ""}</span>`;
  return html`
    <div class="table-box">
      <table class="couplings" data-parts=${parts.length}>
        <thead>
          <tr>
            <td><small>who decides</small></td>
            ${parts.map((_, target) => html`<th scope="col"><small>about</small> ${head(target)}</th>`)}
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
