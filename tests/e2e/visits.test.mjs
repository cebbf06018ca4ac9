// Several visits in one browser: tabs that end together, records that are damaged, and browsers that store
// nothing.
import assert from "node:assert/strict";
import { it } from "node:test";
import { bvh } from "./clips.mjs";
import { drop, openedSite, ready, revisit, seldom } from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

/** Opens clips of these names. */
async function openClips(/** @type {Page} */ page, /** @type {string[]} */ ...names) {
  await drop(page, Object.fromEntries(names.map((name) => [`${name}.bvh`, bvh()])));
  for (const name of names) await page.getByTestId("own-clips").getByText(name, { exact: true }).waitFor();
}

/** Waits until visits are stored; the button to forget them comes then. */
const stores = (/** @type {Page} */ page) => page.getByTestId("forget").waitFor();

const keepNow = (/** @type {Page} */ page) =>
  page.evaluate(() => /** @type {any} */ (document.querySelector("pg-page")).session.keepNow());

/** The page in another tab of the same browser. */
async function otherTab(/** @type {Page} */ page) {
  const other = await page.context().newPage();
  await other.goto(page.url());
  await ready(other);
  await stores(other);
  return other;
}

const offers = async (/** @type {Page} */ page) =>
  (await page.getByTestId("earlier-visit").allInnerTexts()).map((text) => text.replace(/^.*?: |\..*$/gs, ""));

/** The keys in one of the browser's databases. */
const keysIn = (/** @type {Page} */ page, /** @type {string} */ name, /** @type {string} */ store) =>
  page.evaluate(
    async ([name = "", store = ""]) => {
      const database = await new Promise((resolve) => {
        const opening = indexedDB.open(name);
        opening.onsuccess = () => resolve(opening.result);
      });
      const keys = await new Promise((resolve) => {
        const reading = database.transaction(store).objectStore(store).getAllKeys();
        reading.onsuccess = () => resolve(reading.result);
      });
      database.close();
      return /** @type {any[]} */ (keys);
    },
    [name, store],
  );

const records = (/** @type {Page} */ page) => keysIn(page, "vcgpdm", "records");

/** Puts records into the browser's database. */
const put = (/** @type {Page} */ page, /** @type {[key: any, value: any][]} */ entries) =>
  page.evaluate(async (entries) => {
    const database = await new Promise((resolve) => {
      const opening = indexedDB.open("vcgpdm");
      opening.onsuccess = () => resolve(opening.result);
    });
    await new Promise((resolve) => {
      const writing = database.transaction("records", "readwrite");
      for (const [key, value] of entries) writing.objectStore("records").put(value, key);
      writing.oncomplete = resolve;
    });
    database.close();
  }, entries);

seldom.describe("two tabs that end together", () => {
  it("lose nothing: both visits are offered in both tabs of the next start, and each comes back once", async () => {
    const { page: a, problems, leave } = await site.visit();
    await ready(a);
    await stores(a);
    const b = await otherTab(a);
    await openClips(a, "first", "second");
    await openClips(b, "third");
    await Promise.all([keepNow(a), keepNow(b)]);
    const idle = await a.context().newPage();
    await Promise.all([a.close(), b.close()]);

    await idle.goto(a.url());
    await ready(idle);
    await stores(idle);
    const c = idle;
    const d = await otherTab(c);
    for (const tab of [c, d]) {
      await tab.getByTestId("earlier-visit").nth(1).waitFor();
      assert.deepEqual((await offers(tab)).sort(), ["2 clips", "a clip"]);
    }
    assert.equal((await records(c)).length, 7, "opening the page removes no record");

    await c.getByTestId("earlier-visit").filter({ hasText: "2 clips" }).getByTestId("bring-back").click();
    await c.getByTestId("own-clips").getByText("second").waitFor();
    const taken = d.getByTestId("earlier-visit").filter({ hasText: "2 clips" });
    await taken.getByText("Another tab has it.").waitFor();
    assert.equal(await taken.getByTestId("bring-back").count(), 0);
    await d.getByTestId("bring-back").click();
    await d.getByTestId("own-clips").getByText("third").waitFor();
    await c.getByTestId("earlier-visit").getByText("Another tab has it.").waitFor();
    assert.deepEqual(problems, []);
    await leave();
  });

  it("forget one visit at its own button, and keep the others", async () => {
    const { page: a, leave } = await site.visit();
    await ready(a);
    await stores(a);
    const b = await otherTab(a);
    await openClips(a, "first", "second");
    await openClips(b, "third");
    await Promise.all([keepNow(a), keepNow(b)]);
    await b.close();
    await revisit(a);
    await a.getByTestId("earlier-visit").filter({ hasText: "a clip" }).getByTestId("forget-visit").click();
    await a.getByTestId("earlier-visit").nth(1).waitFor({ state: "detached" });
    assert.deepEqual(await offers(a), ["2 clips"]);
    await openClips(a, "fourth");
    await keepNow(a);
    await revisit(a);
    await a.getByTestId("earlier-visit").nth(1).waitFor();
    assert.deepEqual((await offers(a)).sort(), ["2 clips", "a clip"]);
    await leave();
  });
});

seldom.describe("Forget everything", () => {
  it("removes the answers of participants, but not of one who answers in another tab", async () => {
    const { page: a, leave } = await site.visit({ settings: "view=perception" });
    const participants = () => keysIn(a, "vcgpdm answers", "participations");
    const begin = async (/** @type {Page} */ page) => {
      await page.getByTestId("begin").and(page.locator(":enabled")).click();
      await page.locator("dialog[open]").waitFor();
    };
    await begin(a);
    const [first] = await participants();
    await a.getByTestId("run-leave").click();
    await begin(a);
    const [active] = (await participants()).filter((key) => key !== first);
    const b = await otherTab(a);
    await b.getByTestId("forget").click();
    await b.getByTestId("confirm-yes").click();
    const undo = b.getByTestId("undo-forget");
    await undo.waitFor();
    assert.match(await b.getByTestId("forgotten").innerText(), /^Forgotten: 0 answers of a participant/);
    assert.deepEqual(await participants(), [active]);
    assert.equal((await keysIn(a, "vcgpdm answers", "studies")).length, 1);
    await undo.click();
    await b.getByTestId("forget").waitFor();
    assert.deepEqual((await participants()).sort(), [first, active].sort());
    await leave();
  });
});

seldom.describe("damaged records", () => {
  it("are skipped with a sentence, and the other visits offered", async () => {
    const { page } = await site.visit();
    await ready(page);
    await stores(page);
    await openClips(page, "mine");
    await keepNow(page);
    const [[visit] = []] = await records(page);
    const about = { clips: 0, runs: 1, models: 0, results: 0, fragment: "", firstBones: false };
    await put(page, [
      ["a key of another program", 1],
      [[5, "about"], {}],
      [["junk", "about"], "x"],
      [["other version", "visit"], { version: 7, clips: [] }],
      [["timeless", "about"], { ...about, at: 1e20, order: [], chosen: null }],
      [["timeless", "model"], "{}"],
      [["half", "about"], { ...about, at: 1_700_000_000_000, order: [3], chosen: 3 }],
      [["half", "run 3"], { id: 3, state: "running" }],
      [["half", "results"], "{}"],
      [[visit, "run 9"], null],
    ]);
    await revisit(page);
    await page.getByTestId("earlier-visit").nth(2).waitFor();
    assert.deepEqual((await offers(page)).sort(), ["a clip", "a comparison", "a model"]);
    assert.equal(await page.getByText("The rest of it cannot be read.").count(), 3);
    await page.getByTestId("unreadable-visit").getByText("2 earlier visits cannot be read").waitFor();
    await page.getByText("From an earlier visit: a model.").waitFor();
    await page.getByTestId("earlier-visit").filter({ hasText: "a clip" }).getByTestId("bring-back").click();
    await page.getByTestId("own-clips").getByText("mine").waitFor();
    // The model is none: words, and its visit stays offered at the next start.
    await page.getByTestId("earlier-visit").filter({ hasText: "a model" }).getByTestId("bring-back").click();
    await page.getByTestId("notice").filter({ hasText: "Not all of the earlier visit" }).waitFor();
    await page.getByTestId("unreadable-visit").getByRole("button").click();
    await page.getByTestId("unreadable-visit").waitFor({ state: "detached" });

    await page.getByTestId("forget").click();
    await page.getByTestId("confirm-yes").click();
    await page.getByTestId("undo-forget").waitFor();
    assert.deepEqual(await records(page), []);
  });
});

seldom.describe("a tab that ends in the middle of a write", () => {
  it("leaves no half visit", async () => {
    const { page, leave } = await site.visit();
    await ready(page);
    const tab = await otherTab(page);
    const session = await page.context().newCDPSession(tab);
    let tell = () => {};
    const hangs = new Promise((resolve) => {
      tell = () => resolve(undefined);
    });
    await tab.exposeFunction("tellTest", () => tell());
    // The tab writes two records of the visit and then hangs.
    await tab.evaluate(() => {
      const { put } = IDBObjectStore.prototype;
      let count = 0;
      IDBObjectStore.prototype.put = function (...record) {
        const request = put.apply(this, record);
        count += 1;
        if (count === 2) {
          /** @type {any} */ (window).tellTest();
          for (const end = performance.now() + 60_000; performance.now() < end; );
        }
        return request;
      };
    });
    await drop(tab, { "first.bvh": bvh(), "second.bvh": bvh() });
    await hangs;
    await Promise.race([session.send("Page.crash").catch(() => {}), tab.waitForEvent("crash")]);
    assert.deepEqual(await records(page), []);
    await leave();
  });
});

seldom.describe("a browser that stores nothing", () => {
  for (const [what, hide] of /** @type {[string, () => void][]} */ ([
    ["has no database", () => Reflect.deleteProperty(window, "indexedDB")],
    [
      "refuses its database",
      () => {
        IDBFactory.prototype.open = () => {
          throw new DOMException("The operation is insecure.", "SecurityError");
        };
      },
    ],
  ])) {
    it(`and ${what} still opens clips and studies`, async () => {
      const { page } = await site.visit();
      await page.context().addInitScript(hide);
      await page.reload();
      await ready(page);
      await openClips(page, "mine");
      await page.getByTestId("view-perception").click();
      await page.getByTestId("study-title").waitFor();
      await page.getByTestId("view-play").click();
      assert.equal(await page.getByTestId("forget").count(), 0);
    });
  }

  it("says so when its storage is full, with the reason", async () => {
    const { page, leave } = await site.visit();
    await ready(page);
    await stores(page);
    const session = await page.context().newCDPSession(page);
    await session.send("Storage.overrideQuotaForOrigin", {
      origin: new URL(page.url()).origin,
      quotaSize: 1000,
    });
    await openClips(page, "mine");
    await keepNow(page);
    await page
      .getByTestId("notice")
      .filter({ hasText: /does not store it: its storage for this page is full\./ })
      .waitFor();
    await leave();
  });
});
