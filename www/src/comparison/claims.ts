// The claims of the papers next to the findings of this comparison.
import { html } from "lit";
import { FigureElement } from "../figures/figure-element";
import type { Comparison } from "../engine/whole-protocol";

export class ClaimsTable extends FigureElement<Comparison> {
  protected readonly heading = "What the papers say";
  protected readonly file = "claims-of-the-papers";

  protected missing({ claims }: Comparison): string | null {
    return claims.length === 0
      ? "No claim of the papers can be checked with the models scored so far."
      : null;
  }

  protected table({ claims }: Comparison) {
    return {
      header: ["the papers say", "place", "our criterion", "we find", "holds here (yes, no or undecided)"],
      rows: claims.map(({ claim, place, criterion, found, answer }) => [
        claim,
        place,
        criterion,
        found,
        answer,
      ]),
    };
  }

  protected figure({ claims }: Comparison) {
    // A narrow page shows the rows as blocks, which then need their roles.
    return html`
      <table class="claims-table" role="table">
        <thead role="rowgroup"><tr role="row"><th scope="col" role="columnheader">The papers say</th><th scope="col" role="columnheader">We find</th><th scope="col" role="columnheader">Holds here</th></tr></thead>
        <tbody role="rowgroup">${claims.map(
          ({ claim, place, criterion, found, answer }) => html`
          <tr role="row"><th scope="row" role="rowheader">${claim} <small>(${place})</small></th>
            <td role="cell" class="found">${found} <small>Our criterion: ${criterion}.</small></td>
            <td role="cell" class="holds"><span class=${answer}>${answer}</span></td></tr>`,
        )}</tbody>
      </table>
      <figcaption>Errors are held against each other trial by trial; the intervals cover 95 %. Yes and no are said only where the whole interval says so.</figcaption>`;
  }
}
customElements.define("comparison-claims", ClaimsTable);
