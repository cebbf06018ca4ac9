// Stores visits in the browser. Loaded when the page has nothing else to do.
import { SessionStore, type Visit, type Offer, type VisitLocks } from "./session-store";
import { browserDatabase } from "./visit-database";
import "./forget-view";
import { html, nothing } from "lit";
import { View } from "../ui/view";
import { sessionWords } from "../words/sections";
import { contentsText } from "./records";

const PREFIX = "vcgpdm visit ";

function browserLocks(): VisitLocks {
  const { locks } = navigator;
  const channel = new BroadcastChannel("vcgpdm visits");
  return {
    // Only pages from https or from this machine have locks.
    tellTabsApart: Boolean(locks),
    hold: (visit) =>
      new Promise((resolve, reject) => {
        if (!locks) return resolve(() => {});
        locks
          .request(PREFIX + visit, { ifAvailable: true }, (lock) => {
            if (lock) return new Promise<void>((release) => resolve(release));
            resolve(null);
            return undefined;
          })
          .catch(reject);
      }),
    async heldVisits() {
      const { held = [] } = (await locks?.query()) ?? {};
      return held.flatMap(({ name }) => (name?.startsWith(PREFIX) ? [name.slice(PREFIX.length)] : []));
    },
    announce: () => channel.postMessage(null),
    listen: (changed) => channel.addEventListener("message", changed),
  };
}

/** The number of visits that are always visible. */
const NEWEST = 3;

class SessionView extends View {
  declare session: SessionStore;

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

/** Fails when the browser stores nothing. */
export async function openSession(visit: Visit): Promise<SessionStore> {
  const name = `${Date.now()} ${Math.random()}`;
  const session = new SessionStore(visit, await browserDatabase(), browserLocks(), name);
  await session.begin();
  await reloaded(session);
  sessionStorage.setItem(OF_TAB, name);
  document.addEventListener("visibilitychange", () => {
    if (document.visibilityState === "hidden") void session.keepNow();
  });
  return session;
}

/** The name under which a tab keeps its visit, until it is closed. */
const OF_TAB = "vcgpdm visit";

/** After a reload of the tab, its own visit comes back by itself. */
async function reloaded(session: SessionStore): Promise<void> {
  const before = sessionStorage.getItem(OF_TAB);
  const [navigation] = performance.getEntriesByType("navigation");
  const own = session.offers.find(({ visit, taken }) => visit === before && !taken);
  if (!own || (navigation as PerformanceNavigationTiming | undefined)?.type !== "reload") return;
  // A visit whose return ends the page is only offered the next time.
  sessionStorage.removeItem(OF_TAB);
  await session.bringBack(own);
}
