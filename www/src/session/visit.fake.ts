// For tests: a database of visits, tabs that hold visits, and what a visit holds.
import type { Holdings } from "./records";
import { SessionStore, type Visit } from "./session-store";
import type { RemovedRecords, VisitDatabase } from "./visit-database";

export class FakeDatabase implements VisitDatabase {
  readonly records = new Map<string, Map<string, unknown>>();
  /** Why the browser stores nothing now. */
  problem: unknown = null;
  written: string[] = [];
  /** The visits whose files were read. */
  filesRead: string[] = [];

  async visits() {
    return [...this.records.keys()];
  }
  async read(visit: string, withFiles: boolean) {
    if (withFiles) this.filesRead.push(visit);
    const records = new Map(this.records.get(visit));
    if (!withFiles)
      for (const [name, value] of records) if (value instanceof Blob) records.set(name, new Blob());
    return records;
  }
  async write(visit: string, changes: ReadonlyMap<string, unknown>) {
    if (this.problem !== null) throw this.problem;
    this.written = [...changes.keys()];
    const records = this.records.get(visit) ?? new Map<string, unknown>();
    for (const [name, value] of changes) {
      if (value === undefined) records.delete(name);
      else records.set(name, structuredClone(value));
    }
    this.records.set(visit, records);
  }
  async forget(visit: string) {
    this.records.delete(visit);
  }
  async forgetAllBut(visits: readonly string[]) {
    const removed = [...this.records].filter(([visit]) => !visits.includes(visit));
    for (const [visit] of removed) this.records.delete(visit);
    return removed;
  }
  async restore(removed: RemovedRecords) {
    if (this.problem !== null) throw this.problem;
    for (const [visit, records] of removed) this.records.set(String(visit), records as Map<string, unknown>);
  }
}

export const nothing: Holdings = {
  fragment: "",
  clips: [],
  firstBones: false,
  runs: [],
  chosen: null,
  model: null,
  results: null,
  unsaved: { model: false, results: false },
  library: null,
};

export const clip = (name: string) => ({
  ...{ key: `own-${name}`, id: 7, title: name, origin: "own" as const, ticked: true, first: 0, end: 90 },
  source: { name, file: new Blob(["HIERARCHY"]) },
});

const step = { bound: -5, best: -4, fraction: 0.5, setbacks: { jittered: 0, turnedBack: 0 } };
const numbers = { latent: 3, dynamicsIps: 8, poseIps: 8, order: 2, framesPerSecond: 30, maxIterations: 9 };

export const run = (id: number, iterations: number) =>
  ({
    ...{ id, state: "running", elapsed: 1, ending: "", portion: 600, open: false, catchingUp: false },
    settings: { ...numbers, seed: id, parts: [{ name: "lower", joints: [1, 2] }] },
    clips: [],
    model: { text: "{}", latents: [new Float64Array(6)], health: null, error: null },
    steps: Array.from({ length: iterations }, (_, i) => ({ ...step, iteration: i + 1 })),
  }) as unknown as Holdings["runs"][number];

export class FakeVisit implements Visit {
  now: Holdings = nothing;
  taken: Holdings | null = null;
  errors: string[] = [];
  /** Fails before anything is taken up. */
  refuses = false;
  /** The pieces that cannot be taken up. */
  problems: string[] = [];

  holdings() {
    return this.now;
  }
  async takeUp(holdings: Holdings) {
    if (this.refuses) throw new Error("You keep the work on this page.");
    this.taken = holdings;
    this.now = holdings;
    return this.problems;
  }
  showError(title: string, text: string) {
    this.errors.push(`${title}: ${text}`);
  }
}

/** A browser with tabs. */
export class FakeBrowser {
  readonly database = new FakeDatabase();
  tellTabsApart = true;
  readonly #tabs = new Map<string, { visits: Set<string>; listeners: (() => void)[] }>();

  /** Opens the page in a new tab, whose visit has the tab's name. */
  async open(name: string) {
    const visit = new FakeVisit();
    const tab = { visits: new Set<string>(), listeners: [] as (() => void)[] };
    this.#tabs.set(name, tab);
    const held = () => [...this.#tabs.values()].flatMap(({ visits }) => [...visits]);
    const locks = {
      tellTabsApart: this.tellTabsApart,
      hold: async (other: string) => {
        if (!this.tellTabsApart) return () => {};
        if (held().includes(other)) return null;
        tab.visits.add(other);
        return () => void tab.visits.delete(other);
      },
      heldVisits: async () => (this.tellTabsApart ? held() : []),
      announce: () => {
        for (const [other, { listeners }] of this.#tabs)
          if (other !== name) for (const listener of listeners) listener();
      },
      listen: (listener: () => void) => void tab.listeners.push(listener),
    };
    const store = new SessionStore(visit, this.database, locks, name);
    await store.begin();
    return { visit, store };
  }

  /** Ends a tab without a word, as a crash does. */
  end(name: string): void {
    this.#tabs.delete(name);
  }

  /** A visit that held something and has ended. */
  async leave(name: string, holdings: Partial<Holdings>, at = Date.now()) {
    const { visit, store } = await this.open(name);
    visit.now = { ...nothing, ...holdings };
    const now = Date.now;
    Date.now = () => at;
    await store.keepNow();
    Date.now = now;
    this.end(name);
  }
}
