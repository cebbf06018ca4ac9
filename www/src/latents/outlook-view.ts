// The text below the plots about futures and uncertainty, with the seeds of the futures.
import { html, nothing } from "lit";
import { withTerms } from "../terms/term";
import { View } from "../ui/view";
import "./outlook.css";
import { FUTURES, type OutlookStore } from "./outlook-store";
import { lab } from "../words/lab";

export class OutlookView extends View {
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
