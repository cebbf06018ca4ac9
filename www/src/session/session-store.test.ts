import { beforeEach, describe, expect, it, vi } from "vitest";
import type { SessionStore } from "./session-store";
import { clip, FakeBrowser, nothing, run } from "./visit.fake";

let browser: FakeBrowser;
beforeEach(() => {
  browser = new FakeBrowser();
});

const offered = ({ offers }: SessionStore) => offers.map(({ visit, contents }) => `${visit}: ${contents}`);
const first = ({ offers: [offer] }: SessionStore) => offer ?? expect.fail();
const stored = () => [...browser.database.records.keys()];
/** Lets the other tabs look again. */
const settled = () => new Promise((resolve) => setTimeout(resolve, 0));

describe("a visit", () => {
  it("that holds nothing leaves no record", async () => {
    await browser.leave("a", {});
    expect(stored()).toEqual([]);
  });

  it("writes only what has changed, and removes what is gone", async () => {
    const { database } = browser;
    const { visit, store } = await browser.open("a");
    const walk = clip("walk");
    visit.now = { ...nothing, clips: [walk], runs: [run(1, 5), run(2, 5)] };
    // Within a millisecond nothing about the visit has changed.
    const clock = vi.spyOn(Date, "now").mockReturnValue(1000);
    await store.keepNow();
    expect(database.written.sort()).toEqual(["about", "clips", "file 1", "run 1", "run 2"]);
    visit.now = { ...visit.now, runs: [run(2, 6)] };
    clock.mockReturnValue(2000);
    await store.keepNow();
    clock.mockRestore();
    const found = [...(database.records.get("a")?.keys() ?? [])].sort();
    expect(found).toEqual(["about", "clips", "file 1", "run 2"]);
    expect(database.written.sort()).toEqual(["about", "run 1", "run 2"]);
  });

  it("says once that the storage is full, and is written as soon as it is not", async () => {
    const { visit, store } = await browser.open("a");
    visit.now = { ...nothing, model: "{}", results: "{}" };
    await store.keepNow();
    visit.now = { ...nothing, model: "{ }" };
    // Chromium's own message is empty.
    browser.database.problem = new DOMException("", "QuotaExceededError");
    await store.keepNow();
    await store.keepNow();
    expect(visit.errors).toHaveLength(1);
    expect(visit.errors[0]).toMatch(
      /cannot be kept: .*does not store it: its storage for this page is full\./,
    );
    expect(store.keeps).toBe(false);
    browser.database.problem = null;
    await store.keepNow();
    expect(store.keeps).toBe(true);
    const records = browser.database.records.get("a");
    expect([records?.get("model"), records?.has("results")]).toEqual(["{ }", false]);
  });

  it("names a problem of the browser that has no message", async () => {
    const { visit, store } = await browser.open("a");
    visit.now = { ...nothing, model: "{}" };
    browser.database.problem = new DOMException("", "InvalidStateError");
    await store.keepNow();
    expect(visit.errors[0]).toMatch(/does not store it: InvalidStateError\./);
  });
});

describe("the next visit", () => {
  it("is offered what was left, and has it when it asks for it", async () => {
    const runs = [run(3, 2), run(1, 4)];
    const [, chosen = null] = runs;
    await browser.leave("a", { clips: [clip("walk")], runs, chosen, fragment: "latent=2", results: "{}" });
    const { visit, store } = await browser.open("b");
    expect(offered(store)).toEqual(["a: a clip, 2 trainings and a comparison"]);
    expect([visit.taken, browser.database.filesRead]).toEqual([null, []]);
    await store.bringBack(first(store));
    expect(visit.taken?.runs.map(({ id, steps }) => [id, steps.length])).toEqual([
      [3, 2],
      [1, 4],
    ]);
    const found = [visit.taken?.chosen?.id, visit.taken?.fragment, visit.taken?.results];
    expect(found).toEqual([1, "latent=2", "{}"]);
    const [walk] = visit.taken?.clips ?? [];
    expect(walk && "file" in walk.source && (await walk.source.file.text())).toBe("HIERARCHY");
    expect([offered(store), stored()]).toEqual([[], ["b"]]);
  });

  it("is offered every visit that was left, the newest first", async () => {
    await browser.leave("a", { clips: [clip("walk"), clip("run")] }, 1000);
    await browser.leave("c", { model: "{}" }, 3000);
    await browser.leave("b", { clips: [clip("jump")] }, 2000);
    const { store } = await browser.open("d");
    expect(store.offers.map(({ at, contents }) => [at, contents])).toEqual([
      [3000, "a model"],
      [2000, "a clip"],
      [1000, "2 clips"],
    ]);
    expect(stored().sort()).toEqual(["a", "b", "c"]);
  });

  it("has the library of primitives again, saved or not", async () => {
    const library = { text: "{}", title: "mine.json", unsaved: true };
    await browser.leave("a", { library });
    const { visit, store } = await browser.open("b");
    expect(offered(store)).toEqual(["a: a library of primitives"]);
    await store.bringBack(first(store));
    expect(visit.taken?.library).toEqual(library);
    visit.now = { ...visit.now, library: null };
    await store.keepNow();
    expect(browser.database.records.get("b")?.has("library")).toBe(false);
  });

  it("can forget one visit, and only that one: the others and its own stay stored", async () => {
    await browser.leave("a", { model: "{}" }, 1000);
    await browser.leave("b", { results: "{}" }, 2000);
    const { visit, store } = await browser.open("c");
    visit.now = { ...nothing, clips: [clip("walk")] };
    await store.keepNow();
    await store.forget(first(store));
    expect([offered(store), stored().sort()]).toEqual([["a: a model"], ["a", "c"]]);
    expect(store.keeps).toBe(true);
  });

  it("can have everything forgotten, and is not stored from then on", async () => {
    await browser.leave("a", { model: "{}" });
    const { visit, store } = await browser.open("b");
    // So that the earlier visit stays stored.
    visit.problems = ["A clip is missing."];
    await store.bringBack(first(store));
    await store.forgetAll();
    visit.now = { ...nothing, model: "{}" };
    await store.keepNow();
    expect([offered(store), stored(), store.keeps]).toEqual([[], [], false]);
  });
});

describe("Forget everything", () => {
  it("counts the clips and trainings of all visits that it removes, but those of other tabs", async () => {
    await browser.leave("a", { clips: [clip("walk")], runs: [run(1, 2)] });
    await browser.leave("b", { clips: [clip("run"), clip("jump")] });
    const other = await browser.open("c");
    other.visit.now = { ...nothing, model: "{}" };
    await other.store.keepNow();
    const { visit, store } = await browser.open("d");
    visit.now = { ...nothing, runs: [run(1, 2)] };
    expect(store.forgettable).toEqual({ contents: "3 clips and 2 trainings", earlierVisits: 2 });
  });

  it("is undone: earlier visits are offered again, and this visit is stored again", async () => {
    await browser.leave("a", { clips: [clip("walk")] }, Date.now() - 1000);
    const { visit, store } = await browser.open("b");
    visit.now = { ...nothing, model: "{}", clips: [clip("run")] };
    await store.keepNow();
    const undo = await store.forgetAll();
    expect([offered(store), stored(), store.keeps]).toEqual([[], [], false]);
    await undo();
    expect([offered(store), stored().sort(), store.keeps]).toEqual([["a: a clip"], ["a", "b"], true]);
    visit.now = { ...visit.now, model: "{ }" };
    await store.keepNow();
    browser.end("b");
    const next = await browser.open("c");
    expect(offered(next.store)).toEqual(["b: a clip and a model", "a: a clip"]);
    await next.store.bringBack(first(next.store));
    const [walk] = next.visit.taken?.clips ?? [];
    expect(walk && "file" in walk.source && (await walk.source.file.text())).toBe("HIERARCHY");
    expect(next.visit.taken?.model).toBe("{ }");
  });

  it("stays in force when the undo fails, and can be undone later", async () => {
    await browser.leave("a", { model: "{}" });
    const { store } = await browser.open("b");
    const undo = await store.forgetAll();
    browser.database.problem = new DOMException("", "QuotaExceededError");
    await expect(undo()).rejects.toThrow();
    expect([offered(store), store.keeps]).toEqual([[], false]);
    browser.database.problem = null;
    await undo();
    expect([offered(store), store.keeps]).toEqual([["a: a model"], true]);
  });
});

it("keeps the visit of this tab when the browser cannot forget", async () => {
  const { store } = await browser.open("a");
  browser.database.forgetAllBut = () => Promise.reject(new Error("blocked"));
  await expect(store.forgetAll()).rejects.toThrow("blocked");
  expect(store.keeps).toBe(true);
});

describe("an earlier visit stays stored", () => {
  beforeEach(() => browser.leave("a", { model: "{}" }));

  it("when the visitor keeps the work on the page instead", async () => {
    const { visit, store } = await browser.open("b");
    const other = (await browser.open("c")).store;
    visit.refuses = true;
    await store.bringBack(first(store));
    await settled();
    expect(first(other).taken).toBe(false);
    expect(visit.errors).toEqual([
      "The earlier visit could not be brought back: You keep the work on this page.",
    ]);
    expect([offered(store), store.busy, stored()]).toEqual([["a: a model"], false, ["a"]]);
    visit.refuses = false;
    await store.bringBack(first(store));
    expect(visit.taken?.model).toBe("{}");
  });

  it("when the visit that brought it back cannot be stored", async () => {
    const { visit, store } = await browser.open("b");
    browser.database.problem = new DOMException("", "QuotaExceededError");
    await store.bringBack(first(store));
    expect([visit.taken?.model, stored()]).toEqual(["{}", ["a"]]);
  });

  it("when a piece of it could not be taken up", async () => {
    const { visit, store } = await browser.open("b");
    visit.problems = ["The clip walk: out of memory."];
    await store.bringBack(first(store));
    expect(visit.errors).toEqual([
      "Not all of the earlier visit was brought back: The clip walk: out of memory.",
    ]);
    expect([offered(store), stored().sort()]).toEqual([[], ["a", "b"]]);
  });

  it("where the browser cannot tell tabs apart: another tab may still be in it", async () => {
    browser.tellTabsApart = false;
    const { visit, store } = await browser.open("b");
    await store.bringBack(first(store));
    expect([visit.taken?.model, stored().sort()]).toEqual(["{}", ["a", "b"]]);
    // Not even when another tab says that the list has changed.
    const about = browser.database.records.get("a")?.get("about");
    browser.database.records.set("empty", new Map([["about", about]]));
    const other = (await browser.open("d")).store;
    await other.forget({ ...first(other), visit: "c" });
    await settled();
    expect([offered(store), stored().sort()]).toEqual([[], ["a", "b", "empty"]]);
  });
});

describe("with several tabs", () => {
  it("a visit that goes on in another tab is neither offered nor forgotten", async () => {
    const { visit, store } = await browser.open("a");
    visit.now = { ...nothing, model: "{}" };
    await store.keepNow();
    const other = (await browser.open("b")).store;
    expect(offered(other)).toEqual([]);
    await other.forgetAll();
    expect(stored()).toEqual(["a"]);
  });

  it("a visit that begins while this tab looks for visits is not offered", async () => {
    const { database } = browser;
    const visits = database.visits.bind(database);
    database.visits = async () => {
      database.visits = visits;
      const { visit, store } = await browser.open("a");
      visit.now = { ...nothing, model: "{}" };
      await store.keepNow();
      return visits();
    };
    expect(offered((await browser.open("b")).store)).toEqual([]);
  });

  it("two visits that ended together are both offered in both tabs, and each is brought back once", async () => {
    await browser.leave("a", { clips: [clip("walk"), clip("run")] }, 1000);
    await browser.leave("b", { clips: [clip("jump")] }, 2000);
    const [one, two] = [await browser.open("c"), await browser.open("d")];
    for (const { store } of [one, two]) expect(offered(store)).toEqual(["b: a clip", "a: 2 clips"]);
    const [b = expect.fail(), a = expect.fail()] = one.store.offers;
    await one.store.bringBack(b);
    await settled();
    expect(two.store.offers.map(({ visit, taken }) => [visit, taken])).toEqual([
      ["b", true],
      ["a", false],
    ]);
    // Pressed before the page could draw that.
    await two.store.bringBack(b);
    expect(two.visit.taken).toBe(null);
    await two.store.bringBack(a);
    expect(two.visit.taken?.clips.map(({ title }) => title)).toEqual(["walk", "run"]);
    expect([stored().sort(), two.visit.errors]).toEqual([["c", "d"], []]);
  });

  it("a visit whose tab ends while it brings the visit back is offered again", async () => {
    await browser.leave("a", { model: "{}" });
    const { visit, store } = await browser.open("b");
    visit.takeUp = () => new Promise(() => {});
    const other = (await browser.open("c")).store;
    void store.bringBack(first(store));
    await settled();
    expect(first(other).taken).toBe(true);
    browser.end("b");
    expect(offered((await browser.open("d")).store)).toEqual(["a: a model"]);
  });

  it("a visit that another tab has forgotten is not offered any more", async () => {
    await browser.leave("a", { model: "{}" });
    const [one, two] = [await browser.open("b"), await browser.open("c")];
    const offer = first(two.store);
    await one.store.forget(first(one.store));
    // Pressed before the page could draw that.
    await two.store.bringBack(offer);
    expect([offered(two.store), two.visit.taken]).toEqual([[], null]);
  });
});

describe("records that cannot be read", () => {
  it("do not keep the other visits from being offered, and stay until they are forgotten", async () => {
    browser.database.records.set("junk", new Map([["about", "x"]]));
    browser.database.records.set("more junk", new Map());
    const read = browser.database.read.bind(browser.database);
    browser.database.read = (visit, withFiles) =>
      visit === "more junk" ? Promise.reject(new Error("damaged")) : read(visit, withFiles);
    await browser.leave("a", { model: "{}" });
    const { store } = await browser.open("b");
    expect([offered(store), store.unreadable]).toEqual([["a: a model"], 2]);
    expect(stored().sort()).toEqual(["a", "junk", "more junk"]);
    await store.forgetUnreadable();
    expect([offered(store), store.unreadable, stored()]).toEqual([["a: a model"], 0, ["a"]]);
  });

  it("stay stored when the rest of their visit was brought back", async () => {
    await browser.leave("a", { model: "{}", results: "{}" });
    browser.database.records.get("a")?.set("results", 5);
    const { visit, store } = await browser.open("b");
    expect([offered(store), first(store).whole]).toEqual([["a: a model"], false]);
    await store.bringBack(first(store));
    expect([visit.taken?.model, visit.taken?.results, stored().sort()]).toEqual(["{}", null, ["a", "b"]]);
  });
});
