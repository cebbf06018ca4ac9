// The keeping of visits in a browser. Loaded when the page has nothing else to do.
import { openVisits } from "./open-visits";
import { SessionStore, type Visit } from "./session-store";
import { browserShelf } from "./shelf";
import "./session-view";

/** Fails where the browser keeps nothing. */
export async function openSession(visit: Visit): Promise<SessionStore> {
  const session = new SessionStore(visit, await browserShelf(), openVisits);
  await session.begin();
  const leave = () => void (document.visibilityState === "hidden" && session.keepNow());
  document.addEventListener("visibilitychange", leave);
  return session;
}
