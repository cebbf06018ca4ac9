import { beforeEach, describe, expect, it, vi } from "vitest";
import { HeldWorkers } from "../engine/held.fake";
import { type AnswerDatabase, answered, isComplete, type Participation, type Row } from "./participation";
import { PerceptionStore } from "./perception-store";
import { download } from "../ui/download";
import { visitor } from "../unsaved/choice-dialog.fake";
import { studyText } from "./study.fake";

vi.mock("../unsaved/choice-dialog", () => import("../unsaved/choice-dialog.fake"));
vi.mock("../ui/download", () => ({ download: vi.fn() }));

class FakeDatabase implements AnswerDatabase {
  readonly participations = new Map<string, Participation>();
  readonly studies = new Map<string, string>();
  readonly rows = new Map<string, Row[]>();
  readonly held = new Set<string>();
  full = false;

  async all() {
    return [...this.participations.values()].map((about) => ({
      ...about,
      rows: this.rows.get(about.key) ?? [],
    }));
  }
  async study(key: string) {
    return this.studies.get(key) ?? null;
  }
  async begin(participation: Participation, text: string) {
    if (this.full) throw new Error("the storage is full");
    this.participations.set(participation.key, structuredClone(participation));
    this.studies.set(participation.key, text);
  }
  async add(key: string, place: number, row: Row) {
    if (this.full) throw new Error("the storage is full");
    const rows = this.rows.get(key) ?? [];
    rows[place] = structuredClone(row);
    this.rows.set(key, rows);
  }
  async forget(key: string) {
    this.participations.delete(key);
  }
  async hold(key: string) {
    if (this.held.has(key)) return null;
    this.held.add(key);
    return () => void this.held.delete(key);
  }
}

let workers: HeldWorkers;
let database: FakeDatabase;
let store: PerceptionStore;

const answer = (position: number): Row => ({
  kind: "comparison",
  position,
  response: "left",
  trial_index: 7,
});
const page: Row = { page: "consent" };

/** The steps that the active participant has left. */
const left = ({ active }: PerceptionStore) =>
  (active?.steps ?? []).map((step) => (step.kind === "pair" ? step.position : step.page)).join(" ");

beforeEach(async () => {
  workers = new HeldWorkers();
  database = new FakeDatabase();
  store = new PerceptionStore(workers, database, async () => studyText("study of the page"));
  await store.openStudy(async () => studyText("walks"));
});

describe("a study", () => {
  it("comes with the page when no other is open", async () => {
    await store.ready();
    expect(store.study?.text).toBe(studyText("walks"));
    const other = new PerceptionStore(workers, database, async () => studyText("study of the page"));
    await Promise.all([other.ready(), other.ready()]);
    expect(other.study?.text).toBe(studyText("study of the page"));
  });

  it("is opened and changed, and a text that is no study is refused with the reason", async () => {
    expect(store.study?.info.title).toBe("walks");
    await store.change({ preset: "class" });
    const changed = store.study?.text;
    expect([changed === studyText("walks"), store.study?.info.design.comparisons]).toEqual([false, 52]);
    await store.openStudy(async () => "{}");
    expect(store.problem).toMatch(/^expected a study/);
    expect([store.study?.text === changed, store.busy]).toEqual([true, false]);
    await store.openStudy(() => Promise.reject(new Error("no such file")));
    expect(store.problem).toBe("no such file");
  });

  it("that was changed or made here is not replaced before the visitor is asked", async () => {
    visitor.arrives("keep");
    await store.openStudy(async () => studyText("runs"));
    expect(visitor.asked).toEqual([]);
    await store.change({ preset: "class" });
    await store.openStudy(async () => studyText("walks"));
    expect([store.study?.info.title, visitor.asked.length]).toEqual(["runs", 1]);
    const seen: unknown[] = [];
    const stop = store.on(() => seen.push(store.unsaved));
    store.saveStudy();
    expect([vi.mocked(download).mock.calls.length, seen]).toEqual([1, [null]]);
    stop();
    await store.openStudy(async () => studyText("made"), true);
    expect([store.study?.info.title, visitor.asked.length]).toEqual(["made", 1]);
    visitor.arrives("discard");
    await store.openStudy(async () => studyText("walks"));
    expect([store.study?.info.title, store.unsaved, visitor.asked.length]).toEqual(["walks", null, 1]);
  });
});

describe("a participant", () => {
  it("answers, and each row is stored at once, with its place", async () => {
    await store.begin(" anna-3 ", false);
    expect(left(store)).toBe("consent instructions 0 1 pause 2 end");
    const study = store.study?.info.hash;
    expect(store.active?.columns).toMatchObject({ participant: "anna-3", study, sitting: 1 });
    await store.addRow(page);
    await store.addRow(answer(0));
    const [participation] = await database.all();
    expect(participation?.rows.map(({ trial_index }) => trial_index)).toEqual([0, 1]);
    expect(participation && answered(participation)).toBe(1);
    expect(store.active?.participation.rows).toHaveLength(2);
    // A row that comes after the participant has left belongs to nobody.
    store.leave();
    await store.addRow(answer(1));
    expect((await database.all())[0]?.rows).toHaveLength(2);
  });

  it("continues in the next visit where the closed tab stopped, with the same trials of the same study", async () => {
    await store.begin("", false);
    for (const row of [page, answer(0), answer(1)]) await store.addRow(row);
    // The tab is closed.
    database.held.clear();
    const next = new PerceptionStore(workers, database, async () => studyText("study of the page"));
    await next.loadStored();
    const [participation] = next.participations;
    expect([
      participation?.trials,
      participation && answered(participation),
      participation && isComplete(participation),
    ]).toEqual([3, 2, false]);
    expect(participation?.participant).toMatch(/^[2-9a-z]{6}$/);
    await next.resume(participation?.key ?? "");
    expect(next.active?.study.title).toBe("walks");
    expect(left(next)).toBe("instructions 2 end");
    // Before the last trial the second session had only a page of text.
    expect(next.active?.columns).toMatchObject({ seed: participation?.seed });
    await next.addRow({ ...answer(2), sitting: 1 });
    expect((await database.all())[0]?.rows.map(({ trial_index }) => trial_index)).toEqual([0, 1, 2, 3]);
    next.leave();
    const [done] = next.participations;
    expect([next.active, done && isComplete(done)]).toEqual([null, true]);
    await next.resume(done?.key ?? "");
    expect(next.active).toBe(null);
  });

  it("has a number of sessions", async () => {
    await store.begin("", false);
    await store.addRow({ ...page, sitting: 1 });
    store.leave();
    await store.resume(store.participations[0]?.key ?? "");
    expect(store.active?.columns.sitting).toBe(2);
  });

  it("continues when the storage is full, and the page says that answers are not stored", async () => {
    database.full = true;
    await store.begin("", true);
    await store.addRow(answer(0));
    expect(store.storageProblem).toBe("the storage is full");
    expect(store.participations[0]?.rows).toHaveLength(1);
    store.leave();
    await store.resume(store.participations[0]?.key ?? "");
    expect(left(store)).toBe("instructions 1 pause 2 end");
    database.full = false;
    await store.addRow(answer(1));
    expect(store.storageProblem).toBe("");
  });

  it("is forgotten when the visitor says so", async () => {
    await store.begin("", false);
    store.leave();
    await store.forget(store.participations[0]?.key ?? "");
    expect([store.participations, await database.all()]).toEqual([[], []]);
  });

  it("gets a number when the name is taken", async () => {
    for (let time = 0; time < 3; time++) {
      await store.begin("anna", false);
      store.leave();
    }
    const found = store.participations.map(({ participant }) => participant).sort();
    expect(found).toEqual(["anna", "anna-2", "anna-3"]);
  });

  it("is active in one tab only, and another tab continues where this one stopped", async () => {
    await store.begin("anna", false);
    const other = new PerceptionStore(workers, database, async () => studyText("study of the page"));
    await other.loadStored();
    const key = other.participations[0]?.key ?? "";
    await other.resume(key);
    expect([other.active, other.problem]).toEqual([null, "Another tab of this browser goes on with it."]);
    await store.addRow(answer(0));
    store.leave();
    await other.resume(key);
    expect(left(other)).toBe("instructions 1 pause 2 end");
  });

  it("is one at a time", async () => {
    await store.begin("a", false);
    await store.begin("b", false);
    expect(store.participations.map(({ participant }) => participant)).toEqual(["a"]);
  });
});
