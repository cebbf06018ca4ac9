// All figures of a comparison: <comparison-figures .comparison=${comparison}>. The event `save-failed`
// reports a file that could not be made, with a SaveFailure.
import { html } from "lit";
import { View } from "../ui/view";
import "./comparison-figures.css";
import type { Comparison } from "../engine/whole-protocol";
import "./claims";
import "./correlations";
import "./growth";
import "./models-table";
import { compareWords } from "../words/compare";

export type { SaveFailure } from "../figures/figure-element";

export class ComparisonFigures extends View {
  static override properties = { comparison: { attribute: false } };
  declare comparison: Comparison | null;

  constructor() {
    super();
    this.comparison = null;
  }

  protected override stores() {
    return [];
  }

  protected override render() {
    const { comparison } = this;
    const found = comparison && [comparison.models, comparison.growth, comparison.claims];
    if (!found?.some((list) => list.length > 0)) {
      return html`<p class="empty">${compareWords().empty}</p>`;
    }
    return html`
      <div class="figures">
        <comparison-models .data=${comparison}></comparison-models>
        <comparison-correlations .data=${comparison}></comparison-correlations>
        <comparison-growth .data=${comparison}></comparison-growth>
        <comparison-claims .data=${comparison}></comparison-claims>
      </div>`;
  }
}
customElements.define("comparison-figures", ComparisonFigures);

declare global {
  interface HTMLElementTagNameMap {
    "comparison-figures": ComparisonFigures;
  }
}
