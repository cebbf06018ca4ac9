// The visits that are going on in the tabs of this browser: each holds a lock, which the browser takes back
// however the tab ends.
import type { OpenVisits } from "./session-store";

const PREFIX = "vcgpdm visit ";

export const openVisits: OpenVisits = {
  enter(visit) {
    void navigator.locks?.request(PREFIX + visit, () => new Promise(() => {}));
  },
  async all() {
    const { held = [] } = (await navigator.locks?.query()) ?? {};
    return held.flatMap(({ name }) => (name?.startsWith(PREFIX) ? [name.slice(PREFIX.length)] : []));
  },
};
