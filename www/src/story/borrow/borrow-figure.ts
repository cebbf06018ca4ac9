// The large figure of the library, without the words of the Lab.
import { html } from "lit";
import { WalkView } from "../../primitives/walk-view";

export class BorrowFigure extends WalkView {
  static override properties = { ...WalkView.properties, label: {} };
  declare label: string;

  protected override render() {
    return html`<canvas class="stage-canvas" tabindex="0" role="img" data-testid="borrow-figure" aria-label=${this.label}></canvas>`;
  }
}
customElements.define("pg-borrow", BorrowFigure);
