// Without a network: every view and worker works after the first visit. A new version waits until the visitor
// asks for it.
import assert from "node:assert/strict";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, it } from "node:test";
import { dist } from "../../scripts/site.mjs";
import { LONG, openSite, ready, seldom } from "./site.mjs";

/** A copy of the built page, which a test may change. */
const folder = mkdtempSync(join(tmpdir(), "vcgpdm-offline-"));
/** @type {Awaited<ReturnType<typeof openSite>>} */
let site;

before(async () => {
  cpSync(dist, folder, { recursive: true });
  site = await openSite({ folder });
});
after(async () => {
  await site?.close();
  rmSync(folder, { recursive: true });
});

/** Waits until the service worker serves this page; all files are stored by then. */
const servedOffline = (/** @type {import("playwright-core").Page} */ page) =>
  page.waitForFunction(() => navigator.serviceWorker.controller?.state === "activated", null, {
    timeout: 60_000,
  });

seldom.describe("after the first visit", () => {
  it("everything works without a network", async () => {
    const { page, problems, leave } = await site.visit({
      serviceWorkers: "allow",
      idle: true,
      settings: `tab=learn&trainings=1&${LONG}`,
    });
    await ready(page);
    await servedOffline(page);
    await page.context().setOffline(true);
    await page.reload();
    await ready(page);

    // The live motion comes first: the model of a training ends it.
    await page.getByTestId("live-on").click();
    await page.getByTestId("live").waitFor();
    await page.getByTestId("train").click();
    await page.getByTestId("cancel").waitFor();
    await page.waitForFunction(() => /\d/.test(document.querySelector("pg-bound-chart")?.textContent ?? ""));
    await page.getByTestId("cancel").click();
    await page.getByTestId("help").click();
    await page.locator("dialog[open]").waitFor();
    await page.keyboard.press("Escape");
    for (const [view, element] of [
      ["compare", "pg-comparison"],
      ["primitives", "pg-gallery"],
      ["synthetic", "pg-synthetic"],
    ]) {
      await page.getByTestId(`view-${view}`).click();
      await page.locator(/** @type {string} */ (element)).waitFor();
    }
    for (const chapter of [1, 2]) {
      await page.evaluate((chapter) => Object.assign(location, { hash: `story=${chapter}` }), chapter);
      await page
        .locator(`.story[data-state=open] #story-chapters [aria-current=step][href="#story=${chapter}"]`)
        .waitFor({ state: "attached" });
    }
    await page.evaluate(() => Object.assign(location, { hash: "teach" }));
    await page.locator(".teach[data-state=open]").waitFor();
    assert.deepEqual(problems, []);
    await leave();
  });

  it("a new version waits until the visitor asks for it", async () => {
    const { page, problems, leave } = await site.visit({
      serviceWorkers: "allow",
      idle: true,
      settings: `tab=learn&${LONG}`,
    });
    await ready(page);
    await servedOffline(page);

    const service = join(folder, "service.js");
    const index = join(folder, "index.html");
    const old = readFileSync(service, "utf8");
    const text = readFileSync(index, "utf8");
    writeFileSync(index, text.replace("<title>", "<title>New: "));
    writeFileSync(
      service,
      old.replace(/(url:`index\.html`,revision:`)\w+|("index\.html","revision":")\w+/, "$1$2new"),
    );
    assert.notEqual(readFileSync(service, "utf8"), old, "the list names the page");

    await page.evaluate(async () => (await navigator.serviceWorker.getRegistration())?.update());
    await page.getByTestId("new-version").waitFor({ timeout: 60_000 });
    assert.ok(!(await page.title()).startsWith("New: "), "the visitor goes on in the old one");
    await page.reload();
    assert.ok(!(await page.title()).startsWith("New: "), "after a reload too");
    await ready(page);
    await page.getByTestId("train").click();
    await page.getByTestId("cancel").waitFor();
    await page.getByTestId("new-version").click({ timeout: 60_000 });
    assert.match(await page.getByTestId("confirm").innerText(), /ends what runs here: a training/);
    await page.getByTestId("confirm-no").click();
    assert.ok(await page.getByTestId("cancel").isVisible(), "the training continues");
    await page.getByTestId("new-version").click();
    await page.getByTestId("confirm-yes").click();
    await page.waitForFunction(() => document.title.startsWith("New: "));
    await ready(page);
    assert.equal(await page.getByTestId("new-version").count(), 0);
    assert.deepEqual(problems, []);
    await leave();
  });
});
