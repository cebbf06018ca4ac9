import { beforeEach, describe, expect, it, vi } from "vitest";
import { FakeProgram } from "../engine/whole-workers.fake";
import { type AnswerShelf, answered, isComplete, type Participation, type Row } from "./participation";
import { PerceptionStore } from "./perception-store";
import { download } from "../ui/download";
import { visitor } from "../ui/choice-dialog.fake";
import { study, trialsOf } from "./study.fake";

vi.mock("../ui/choice-dialog", () => import("../ui/choice-dialog.fake"));
vi.mock("../ui/download", () => ({ download: vi.fn() }));

class FakeShelf implements AnswerShelf {
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
    if (this.full) throw new Error("no room");
    this.participations.set(participation.key, structuredClone(participation));
    this.studies.set(participation.key, text);
  }
  async add(key: string, place: number, row: Row) {
    if (this.full) throw new Error("no room");
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

let program: FakeProgram;
let shelf: FakeShelf;
let store: PerceptionStore;

const answer = (position: number): Row => ({
  kind: "comparison",
  position,
  response: "left",
  trial_index: 7,
});
const page: Row = { page: "consent" };

/** What is left to do for who sits there. */
const left = ({ sitting }: PerceptionStore) =>
  (sitting?.steps ?? []).map((step) => (step.kind === "pair" ? step.position : step.page)).join(" ");

beforeEach(async () => {
  program = new FakeProgram();
  program.studies = { study, trials: trialsOf([2, 1]) };
  shelf = new FakeShelf();
  store = new PerceptionStore(program, shelf, async () => "study of the page");
  await store.openStudy(async () => "walks");
});

describe("a study", () => {
  it("is that of the page where none is open", async () => {
    await store.ready();
    expect(store.study?.text).toBe("walks");
    const other = new PerceptionStore(program, shelf, async () => "study of the page");
    await Promise.all([other.ready(), other.ready()]);
    expect(other.study?.text).toBe("study of the page");
  });

  it("is opened and changed, and what is no study is refused with words", async () => {
    expect(store.study?.info.title).toBe("walks");
    await store.change({ preset: "class" });
    expect(store.study?.text).toBe('walks {"preset":"class"}');
    program.studies = null;
    await store.openStudy(async () => "{}");
    expect([store.problem, store.study?.info.title, store.busy]).toEqual([
      "this is no study",
      'walks {"preset":"class"}',
      false,
    ]);
    await store.openStudy(() => Promise.reject(new Error("no such file")));
    expect(store.problem).toBe("no such file");
  });

  it("that was changed or made here makes no place for another before the visitor was asked", async () => {
    visitor.arrives("keep");
    await store.openStudy(async () => "runs");
    expect(visitor.asked).toEqual([]);
    await store.change({ preset: "class" });
    await store.openStudy(async () => "walks");
    expect([store.study?.text, visitor.asked.length]).toEqual(['runs {"preset":"class"}', 1]);
    store.saveStudy();
    expect(vi.mocked(download)).toHaveBeenCalledOnce();
    await store.openStudy(async () => "made", true);
    expect([store.study?.text, visitor.asked.length]).toEqual(["made", 1]);
    visitor.arrives("discard");
    await store.openStudy(async () => "walks");
    expect([store.study?.text, store.unsaved, visitor.asked.length]).toEqual(["walks", null, 1]);
  });
});

describe("a participant", () => {
  it("answers, and each row is kept when it comes, in its place", async () => {
    await store.begin(" anna-3 ", false);
    expect(left(store)).toBe("consent instructions 0 1 pause 2 end");
    expect(store.sitting?.columns).toMatchObject({ participant: "anna-3", study: study.hash, sitting: 1 });
    await store.keep(page);
    await store.keep(answer(0));
    const [kept] = await shelf.all();
    expect(kept?.rows.map(({ trial_index }) => trial_index)).toEqual([0, 1]);
    expect(kept && answered(kept)).toBe(1);
    expect(store.sitting?.participation.rows).toHaveLength(2);
  });

  it("goes on in the next visit where the closed tab stopped, with the same trials of the same study", async () => {
    await store.begin("", false);
    for (const row of [page, answer(0), answer(1)]) await store.keep(row);
    // The tab is closed.
    shelf.held.clear();
    const next = new PerceptionStore(program, shelf, async () => "study of the page");
    await next.arrive();
    const [kept] = next.kept;
    expect([kept?.trials, kept && answered(kept), kept && isComplete(kept)]).toEqual([3, 2, false]);
    expect(kept?.participant).toMatch(/^[2-9a-z]{6}$/);
    await next.resume(kept?.key ?? "");
    expect(next.sitting?.study.title).toBe("walks");
    expect(left(next)).toBe("instructions 2 end");
    // Nothing but a page was answered in the second sitting before the last trial.
    expect(next.sitting?.columns).toMatchObject({ seed: kept?.seed });
    await next.keep({ ...answer(2), sitting: 1 });
    expect((await shelf.all())[0]?.rows.map(({ trial_index }) => trial_index)).toEqual([0, 1, 2, 3]);
    next.stand();
    const [done] = next.kept;
    expect([next.sitting, done && isComplete(done)]).toEqual([null, true]);
    await next.resume(done?.key ?? "");
    expect(next.sitting).toBe(null);
  });

  it("counts how often somebody has sat down to it", async () => {
    await store.begin("", false);
    await store.keep({ ...page, sitting: 1 });
    store.stand();
    await store.resume(store.kept[0]?.key ?? "");
    expect(store.sitting?.columns.sitting).toBe(2);
  });

  it("loses nothing where the browser has no room: the visit goes on, and says so", async () => {
    shelf.full = true;
    await store.begin("", true);
    await store.keep(answer(0));
    expect(store.unkept).toBe("no room");
    expect(store.kept[0]?.rows).toHaveLength(1);
    store.stand();
    await store.resume(store.kept[0]?.key ?? "");
    expect(left(store)).toBe("instructions 1 pause 2 end");
    shelf.full = false;
    await store.keep(answer(1));
    expect(store.unkept).toBe("");
  });

  it("is forgotten when the visitor says so", async () => {
    await store.begin("", false);
    store.stand();
    await store.forget(store.kept[0]?.key ?? "");
    expect([store.kept, await shelf.all()]).toEqual([[], []]);
  });

  it("is told from another of the same name", async () => {
    for (let time = 0; time < 3; time++) {
      await store.begin("anna", false);
      store.stand();
    }
    expect(store.kept.map(({ participant }) => participant).sort()).toEqual(["anna", "anna-2", "anna-3"]);
  });

  it("is not in two tabs at once, and the other goes on where this one stopped", async () => {
    await store.begin("anna", false);
    const other = new PerceptionStore(program, shelf, async () => "study of the page");
    await other.arrive();
    const key = other.kept[0]?.key ?? "";
    await other.resume(key);
    expect([other.sitting, other.problem]).toEqual([null, "Another tab of this browser goes on with it."]);
    await store.keep(answer(0));
    store.stand();
    await other.resume(key);
    expect(left(other)).toBe("instructions 1 pause 2 end");
  });

  it("is not there twice at once", async () => {
    await store.begin("a", false);
    await store.begin("b", false);
    expect(store.kept.map(({ participant }) => participant)).toEqual(["a"]);
  });
});
