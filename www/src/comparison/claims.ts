// The claims of the papers next to the findings of this comparison.
import { html } from "lit";
import { FigureElement } from "../figures/figure-element";
import type { Comparison } from "../engine/whole-protocol";
import { compareWords } from "../words/compare";

export class ClaimsTable extends FigureElement<Comparison> {
  protected get heading() {
    return compareWords().claims.heading;
  }
  protected readonly file = "claims-of-the-papers";

  protected missing({ claims }: Comparison): string | null {
    return claims.length === 0 ? compareWords().claims.none : null;
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
    const words = compareWords().claims;
    // A narrow page shows the rows as blocks, which then need their roles.
    return html`
      <table class="claims-table" role="table">
        <thead role="rowgroup"><tr role="row">${words.heads.map((head) => html`<th scope="col" role="columnheader">${head}</th>`)}</tr></thead>
        <tbody role="rowgroup">${claims.map(
          ({ claim, place, criterion, found, answer }) => html`
          <tr role="row"><th scope="row" role="rowheader" lang="en">${claim} <small>(${place})</small></th>
            <td role="cell" class="found"><span lang="en">${found}</span> <small>${words.criterion} <span lang="en">${criterion}.</span></small></td>
            <td role="cell" class="holds"><span class=${answer}>${words.answers[answer]}</span></td></tr>`,
        )}</tbody>
      </table>
      <figcaption>${words.caption}</figcaption>`;
  }
}
customElements.define("comparison-claims", ClaimsTable);
