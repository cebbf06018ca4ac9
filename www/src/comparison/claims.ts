// What the papers say beside what this comparison finds.
import { html } from "lit";
import { FigureElement } from "../figures/figure-element";
import type { Comparison } from "../engine/whole-protocol";

const yes = (holds: boolean) => (holds ? "yes" : "no");

export class ClaimsTable extends FigureElement<Comparison> {
  protected readonly heading = "What the papers say";
  protected readonly file = "claims-of-the-papers";

  protected missing({ claims }: Comparison): string | null {
    return claims.length === 0 ? "No claim of the papers can be checked with the models scored so far." : null;
  }

  protected table({ claims }: Comparison) {
    return {
      header: ["the papers say", "we find", "holds here (yes or no)"],
      rows: claims.map(({ claim, found, holds }) => [claim, found, yes(holds)]),
    };
  }

  protected figure({ claims }: Comparison) {
    return html`
      <table class="claims-table">
        <thead><tr><th scope="col">The papers say</th><th scope="col">We find</th><th scope="col">Holds here</th></tr></thead>
        <tbody>${claims.map(
          ({ claim, found, holds }) => html`
          <tr><th scope="row">${claim}</th><td>${found}</td><td class="holds"><span class=${yes(holds)}>${yes(holds)}</span></td></tr>`,
        )}</tbody>
      </table>`;
  }
}
customElements.define("comparison-claims", ClaimsTable);
