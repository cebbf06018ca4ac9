// The outlook: its store, its drawing and its text, with the seeds of the futures. Loaded on demand.
import { html, nothing } from "lit";
import { withTerms } from "../terms/term";
import { View } from "../ui/view";
import { lab } from "../words/lab";
import type { Behind } from "./latent-drawing";
import { drawFutures, drawMoments, drawPicture } from "./outlook-drawing";
import { FUTURES, type OutlookStore } from "./outlook-store";
import "./outlook.css";

export { OutlookStore } from "./outlook-store";

/** The drawing behind the path; null if there is nothing to draw. */
export function behindPath(outlook: OutlookStore): Behind | null {
  const { futures, moments } = outlook;
  if (futures.length === 0 && !moments && !outlook.isShown("certainty")) return null;
  return (draw, plane, part, frame) => {
    drawPicture(draw, plane, part, outlook);
    const own = moments?.[part];
    if (own) drawMoments(draw, plane, frame, own);
    drawFutures(draw, plane, part, frame, futures);
  };
}

class OutlookView extends View {
  declare outlook: OutlookStore;

  protected override stores() {
    return [this.outlook];
  }

  protected override render() {
    const { outlook } = this;
    const { seed, moments } = outlook;
    const words = lab().loops;
    return html`
      ${
        outlook.isShown("futures")
          ? html`<p class="outlook" data-testid="futures">
              <span>${withTerms(words.fiveFutures(seed, seed + FUTURES - 1))}</span>
              <button class="small" data-testid="other-futures" @click=${() => outlook.drawOthers()}>${words.fiveOthers}</button></p>`
          : nothing
      }
      ${
        outlook.isShown("uncertainty")
          ? html`<p class="outlook" data-testid="uncertainty">
              <span>${withTerms(words.gaussian(!moments))}</span></p>`
          : nothing
      }`;
  }
}
customElements.define("pg-outlook", OutlookView);
