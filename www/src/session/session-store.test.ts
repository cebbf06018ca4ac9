import { beforeEach, describe, expect, it, vi } from "vitest";
import { type Holdings, readRecords } from "./records";
import { SessionStore, type Visit } from "./session-store";
import type { Shelf } from "./shelf";

class FakeShelf implements Shelf {
  readonly records = new Map<string, Map<string, unknown>>();
  full = false;
  written: string[] = [];

  visits() {
    return Promise.resolve([...this.records.keys()]);
  }
  read(visit: string) {
    return Promise.resolve(new Map(this.records.get(visit)));
  }
  write(visit: string, records: ReadonlyMap<string, unknown>) {
    if (this.full) return Promise.reject(new Error("no room"));
    this.written = [...records.keys()];
    const kept = this.records.get(visit) ?? new Map<string, unknown>();
    for (const [name, value] of records) {
      if (value === undefined) kept.delete(name);
      else kept.set(name, structuredClone(value));
    }
    this.records.set(visit, kept);
    return Promise.resolve();
  }
  forget(visit: string) {
    this.records.delete(visit);
    return Promise.resolve();
  }
}

const nothing: Holdings = {
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

const clip = (name: string) => ({
  ...{ key: `own-${name}`, id: 7, title: name, origin: "own" as const, ticked: true, first: 0, end: 90 },
  source: { name, file: new Blob(["HIERARCHY"]) },
});

const run = (id: number, iterations: number) =>
  ({
    ...{
      id,
      state: "running",
      elapsed: 1,
      ending: "",
      model: null,
      portion: 600,
      open: false,
      catchingUp: false,
    },
    settings: { seed: id },
    clips: [],
    steps: Array.from({ length: iterations }, (_, i) => ({ iteration: i + 1 })),
  }) as unknown as Holdings["runs"][number];

class FakeVisit implements Visit {
  now: Holdings = nothing;
  taken: Holdings | null = null;
  told: string[] = [];
  fails = false;

  holdings() {
    return this.now;
  }
  takeUp(holdings: Holdings) {
    if (this.fails) return Promise.reject(new Error("the engine is gone"));
    this.taken = holdings;
    this.now = holdings;
    return Promise.resolve();
  }
  tell(title: string, text: string) {
    this.told.push(`${title}: ${text}`);
  }
}

let shelf: FakeShelf;
let open: Set<string>;

function session(name: string, visit = new FakeVisit()) {
  const visits = { enter: (visit: string) => void open.add(visit), all: () => Promise.resolve([...open]) };
  return { visit, store: new SessionStore(visit, shelf, visits, name) };
}

/** A visit that held something and has been left. */
async function left(name: string, now: Partial<Holdings>) {
  const { visit, store } = session(name);
  await store.begin();
  visit.now = { ...nothing, ...now };
  await store.keepNow();
  open.delete(name);
}

beforeEach(() => {
  shelf = new FakeShelf();
  open = new Set();
});

describe("a visit", () => {
  it("with nothing to keep leaves no trace", async () => {
    await left("a", {});
    expect(shelf.records.size).toBe(0);
  });

  it("writes only what has changed, and removes what is gone", async () => {
    const { visit, store } = session("a");
    const walk = clip("walk");
    visit.now = { ...nothing, clips: [walk], runs: [run(1, 5), run(2, 5)] };
    // Within a millisecond nothing about the visit has changed.
    const clock = vi.spyOn(Date, "now").mockReturnValue(1000);
    await store.keepNow();
    expect(shelf.written.sort()).toEqual(["about", "clips", "file 1", "run 1", "run 2"]);
    visit.now = { ...visit.now, runs: [run(2, 6)] };
    clock.mockReturnValue(2000);
    await store.keepNow();
    clock.mockRestore();
    expect([...(shelf.records.get("a")?.keys() ?? [])].sort()).toEqual(["about", "clips", "file 1", "run 2"]);
    expect(shelf.written.sort()).toEqual(["about", "run 1", "run 2"]);
  });

  it("says once that there is no room, and is kept as soon as there is", async () => {
    const { visit, store } = session("a");
    visit.now = { ...nothing, model: "{}" };
    shelf.full = true;
    await store.keepNow();
    await store.keepNow();
    expect(visit.told).toHaveLength(1);
    expect(visit.told[0]).toMatch(/cannot be kept.*no room/);
    shelf.full = false;
    await store.keepNow();
    expect(shelf.records.get("a")?.get("model")).toBe("{}");
  });
});

describe("the next visit", () => {
  it("is offered what the newest one held, and has it when it asks for it", async () => {
    const runs = [run(3, 2), run(1, 4)];
    const [, chosen = null] = runs;
    await left("a", { clips: [clip("walk")], runs, chosen, fragment: "latent=2", results: "{}" });
    const { visit, store } = session("b");
    await store.begin();
    expect(store.offer?.what).toBe("a clip, 2 trainings and a comparison");
    expect(visit.taken).toBe(null);
    await store.bringBack();
    expect(visit.taken?.runs.map(({ id, steps }) => [id, steps.length])).toEqual([
      [3, 2],
      [1, 4],
    ]);
    expect([visit.taken?.chosen?.id, visit.taken?.fragment, visit.taken?.results]).toEqual([
      1,
      "latent=2",
      "{}",
    ]);
    const [known] = visit.taken?.clips ?? [];
    expect(known && "file" in known.source && (await known.source.file.text())).toBe("HIERARCHY");
    expect([store.offer, [...shelf.records.keys()]]).toEqual([null, ["b"]]);
  });

  it("has the library of primitives again, saved or not", async () => {
    const library = { text: "{}", title: "mine.json", unsaved: true };
    await left("a", { library });
    const { visit, store } = session("b");
    await store.begin();
    expect(store.offer?.what).toBe("a library of primitives");
    await store.bringBack();
    expect(visit.taken?.library).toEqual(library);
    await store.keepNow();
    visit.now = { ...visit.now, library: null };
    await store.keepNow();
    expect(shelf.records.get("b")?.has("library")).toBe(false);
  });

  it("keeps it where it cannot be taken up", async () => {
    await left("a", { model: "{}" });
    const { visit, store } = session("b");
    await store.begin();
    visit.fails = true;
    await store.bringBack();
    expect(visit.told).toEqual(["The earlier visit could not be brought back: the engine is gone"]);
    expect([store.offer?.what, store.busy, shelf.records.has("a")]).toEqual(["a model", false, true]);
  });

  it("keeps it until what it brought back is kept again", async () => {
    await left("a", { model: "{}" });
    const { visit, store } = session("b");
    await store.begin();
    visit.now = { ...visit.now, model: "{}" };
    shelf.full = true;
    await store.bringBack();
    expect([visit.taken?.model, shelf.records.has("a")]).toEqual(["{}", true]);
  });

  it("is not offered what another tab is still doing", async () => {
    const { visit, store } = session("a");
    await store.begin();
    visit.now = { ...nothing, model: "{}" };
    await store.keepNow();
    const other = session("b").store;
    await other.begin();
    expect(other.offer).toBe(null);
    await other.forgetAll();
    expect(shelf.records.has("a")).toBe(true);
  });

  it("can have everything forgotten, and then keeps nothing", async () => {
    await left("a", { model: "{}" });
    const { visit, store } = session("b");
    await store.begin();
    await store.forgetAll();
    visit.now = { ...nothing, model: "{}" };
    await store.keepNow();
    expect([store.offer, shelf.records.size]).toEqual([null, 0]);
  });
});

it("records with a missing piece are refused, by its name", () => {
  const about = { order: [4], chosen: null, fragment: "", firstBones: false };
  expect(() => readRecords(new Map<string, unknown>([["about", about]]))).toThrow(/missing \(run 4\)/);
});
