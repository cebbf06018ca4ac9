// The offers to bring back what earlier visits left.
import { html, nothing } from "lit";
import { View } from "../ui/view";
import type { Offer, SessionStore } from "./session-store";

/** The number of visits that are always visible. */
const NEWEST = 3;
const WHEN = new Intl.DateTimeFormat("en", { dateStyle: "long", timeStyle: "short" });

export class SessionView extends View {
  declare session: SessionStore;

  protected override stores() {
    return [this.session];
  }

  protected override render() {
    const { session } = this;
    const { offers, unreadable, busy } = session;
    const [newest, older] = [offers.slice(0, NEWEST), offers.slice(NEWEST)];
    return html`
      ${newest.map((offer) => this.#offer(offer))}
      ${
        older.length === 0
          ? nothing
          : html`<details class="banner"><summary>Earlier visits: ${older.length} more</summary>${older.map((offer) => this.#offer(offer))}</details>`
      }
      ${
        unreadable === 0
          ? nothing
          : html`<p class="banner" role="status" data-testid="unreadable-visit">
            ${unreadable === 1 ? "An earlier visit" : `${unreadable} earlier visits`} cannot be read: damaged, or of another version of this page.
            <button class="small" ?disabled=${busy} @click=${() => void session.forgetUnreadable()}>Forget</button></p>`
      }`;
  }

  #offer(offer: Offer) {
    const { session } = this;
    const { at, contents, whole, taken } = offer;
    const visit = at === null ? "an earlier visit" : `your visit of ${WHEN.format(at)}`;
    return html`<p class="banner" role="status" data-testid="earlier-visit">From ${visit}: ${contents}.
      ${whole ? nothing : "The rest of it cannot be read."}
      ${
        taken
          ? "Another tab has it."
          : html`<button class="small" data-testid="bring-back" ?disabled=${session.busy} @click=${() => void session.bringBack(offer)}>Bring back</button>
            <button class="small" data-testid="forget-visit" ?disabled=${session.busy} @click=${() => void session.forget(offer)}>Forget</button>`
      }</p>`;
  }
}
customElements.define("pg-session", SessionView);
