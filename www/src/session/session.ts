// Stores visits in the browser. Loaded when the page has nothing else to do.
import { SessionStore, type Visit } from "./session-store";
import { browserDatabase } from "./visit-database";
import { browserLocks } from "./visit-locks";
import "./forget-view";
import "./session-view";

/** Fails when the browser stores nothing. */
export async function openSession(visit: Visit): Promise<SessionStore> {
  const session = new SessionStore(visit, await browserDatabase(), browserLocks());
  await session.begin();
  document.addEventListener("visibilitychange", () => {
    if (document.visibilityState === "hidden") void session.keepNow();
  });
  return session;
}
