// The offer to bring back what an earlier visit has left.
import { html, nothing } from "lit";
import { View } from "../ui/view";
import type { SessionStore } from "./session-store";

const WHEN = new Intl.DateTimeFormat("en", { dateStyle: "long", timeStyle: "short" });

export class SessionView extends View {
  declare session: SessionStore;

  protected override stores() {
    return [this.session];
  }

  protected override render() {
    const { offer, busy } = this.session;
    if (!offer) return nothing;
    return html`<p class="banner" role="status" data-testid="earlier-visit">From your visit of ${WHEN.format(offer.at)}: ${offer.what}.
      <button class="small" data-testid="bring-back" ?disabled=${busy} @click=${() => void this.session.bringBack()}>Bring back</button>
      <button class="small" data-testid="forget-visit" ?disabled=${busy} @click=${() => void this.session.forgetAll()}>Forget</button></p>`;
  }
}
customElements.define("pg-session", SessionView);
