// Which tab has which visit: a lock for each, which the browser takes back however the tab ends.
import type { VisitLocks } from "./session-store";

const PREFIX = "vcgpdm visit ";

export function browserLocks(): VisitLocks {
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
