// The offers to bring back what earlier visits left.
import { html, nothing } from "lit";
import { View } from "../ui/view";
import type { Offer, SessionStore } from "./session-store";
import { sessionWords } from "../words/session";
import { contentsText } from "./records";

/** The number of visits that are always visible. */
const NEWEST = 3;

export class SessionView extends View {
  declare session: SessionStore;

  protected override stores() {
    return [this.session];
  }

  protected override render() {
    const { session } = this;
    const { offers, unreadable, busy } = session;
    const words = sessionWords();
    const [newest, older] = [offers.slice(0, NEWEST), offers.slice(NEWEST)];
    return html`
      ${newest.map((offer) => this.#offer(offer))}
      ${
        older.length === 0
          ? nothing
          : html`<details class="banner"><summary>${words.earlier(older.length)}</summary>${older.map((offer) => this.#offer(offer))}</details>`
      }
      ${
        unreadable === 0
          ? nothing
          : html`<p class="banner" role="status" data-testid="unreadable-visit">
            ${words.unreadable(unreadable)}
            <button class="small" ?disabled=${busy} @click=${() => void session.forgetUnreadable()}>${words.forgetVisit}</button></p>`
      }`;
  }

  #offer(offer: Offer) {
    const { session } = this;
    const { at, counts, whole, taken } = offer;
    const words = sessionWords();
    return html`<p class="banner" role="status" data-testid="earlier-visit">${words.offer(at === null ? null : words.when(at), contentsText(counts))}
      ${whole ? nothing : words.notWhole}
      ${
        taken
          ? words.taken
          : html`<button class="small" data-testid="bring-back" ?disabled=${session.busy} @click=${() => void session.bringBack(offer)}>${words.bringBack}</button>
            <button class="small" data-testid="forget-visit" ?disabled=${session.busy} @click=${() => void session.forget(offer)}>${words.forgetVisit}</button>`
      }</p>`;
  }
}
customElements.define("pg-session", SessionView);
