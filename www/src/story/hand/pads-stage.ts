// The pads of the view Draw on the stage of the story, and beside them the latent loop of each hand.
import { html, nothing } from "lit";
import type { DrawingStore, Pad } from "../../drawing/drawing-store";
import "../../drawing/drawing.css";
import "../../drawing/pad-view";
import { SeriesView } from "../../series/series-view";
import "./pads-stage.css";

export class PadsStage extends SeriesView {
  declare store: DrawingStore;
  declare pads: readonly Pad[];
  /** Whether the program that draws latent spaces has arrived. */
  declare plots: boolean;
  static override properties = { pads: { attribute: false }, plots: { attribute: false } };

  protected override stores() {
    return [this.store];
  }

  protected override get shown() {
    return this.store.model;
  }

  #plot(pad: Pad) {
    const part = this.store.drawn?.pads.indexOf(pad) ?? -1;
    return this.plots && part >= 0
      ? html`<pg-latent-plot .bodyPart=${part} .model=${this.store.model} .space=${this.space}></pg-latent-plot>`
      : nothing;
  }

  protected override render() {
    return html`${this.pads.map((pad) => html`<pg-pad .store=${this.store} .pad=${pad}></pg-pad>${this.#plot(pad)}`)}`;
  }
}
customElements.define("pg-pads-stage", PadsStage);
