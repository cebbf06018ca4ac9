// The text below the plots about futures and uncertainty, with the seeds of the futures.
import { html, nothing } from "lit";
import "../terms/term";
import { View } from "../ui/view";
import "./outlook.css";
import { FUTURES, type OutlookStore } from "./outlook-store";

export class OutlookView extends View {
  declare outlook: OutlookStore;

  protected override stores() {
    return [this.outlook];
  }

  protected override render() {
    const { outlook } = this;
    const { seed, moments } = outlook;
    return html`
      ${
        outlook.isShown("futures")
          ? html`<p class="outlook" data-testid="futures">
              <span><pg-term of="future" text="Five futures"></pg-term>, seeds ${seed} to ${seed + FUTURES - 1}</span>
              <button class="small" data-testid="other-futures" @click=${() => outlook.drawOthers()}>Five others</button></p>`
          : nothing
      }
      ${
        outlook.isShown("uncertainty")
          ? html`<p class="outlook" data-testid="uncertainty">
              <span>Grey: <pg-term of="moment-matching" text="what a Gaussian knows"></pg-term>, ±1 and ±2 σ${moments ? "" : " (loading)"}</span></p>`
          : nothing
      }`;
  }
}
customElements.define("pg-outlook", OutlookView);
