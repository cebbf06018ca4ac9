// Links that bring a model: in themselves, or in a file of the page's host.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe, it } from "node:test";
import { at } from "../../scripts/run.mjs";
import { barriers, openedSite, ready, saved, seldom, soon } from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

/** A model that is not the page's own: it has all its digits. */
const model = {
  name: "mine.json",
  mimeType: "application/json",
  buffer: readFileSync(at("www/first/model.json")),
};

/** A visitor with this model on the stage, one coupling changed, and a camera of their own. */
async function visitorWithMine() {
  const visitor = await site.visit({ settings: "alpha=0.1:3" });
  const { page } = visitor;
  await ready(page);
  await page.getByTestId("open-model").setInputFiles(model);
  // Another model has couplings of its own.
  await page.waitForURL(/#view=play$/);
  // The page may still write the address of the opened model.
  await soon(async () => {
    await page.evaluate(() => Object.assign(location, { hash: "alpha=0.1:0.05&camera=0.5,0.3,1.2" }));
    await page.waitForURL(/#model=[0-9a-f]{8}&alpha=0\.1:0\.05$/, { timeout: 3000 });
  });
  return visitor;
}

/** The fragment of the link with the model in it. */
async function linkOf(/** @type {Page} */ page) {
  await page.getByTestId("save").click();
  await page.getByTestId("share").click();
  const withModel = page.getByTestId("with-model");
  await withModel.setChecked(true);
  const address = page.getByTestId("code-address");
  await soon(async () => assert.match(`${await address.getAttribute("href")}`, /packed=/));
  return new URL(`${await address.getAttribute("href")}`).hash.slice(1);
}

/** The numbers of the table of joint positions. */
async function positions(/** @type {Page} */ page) {
  const { text } = await saved(page, "save-positions");
  const rows = text.trim().split("\r\n").slice(1);
  return rows.flatMap((row) => row.split(",").slice(2).map(Number));
}

const apart = (/** @type {number[]} */ a, /** @type {number[]} */ b) => {
  assert.equal(a.length, b.length);
  return Math.max(...a.map((value, i) => Math.abs(value - (b[i] ?? Number.NaN))));
};

/** The link of a document that is right in length and check number. */
async function packedText(/** @type {string} */ text) {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate"));
  const data = Buffer.from(await new Response(stream).arrayBuffer()).toString("base64url");
  return `1.${data.length}.${data}`;
}

describe("a link with the model in it", () => {
  let link = "";
  let frame = "";
  /** @type {number[]} */
  let moved = [];

  it("is made by Share, which says that it is too long for a QR code, and shows one without the model", async () => {
    const { page } = await visitorWithMine();
    moved = await positions(page);
    link = await linkOf(page);
    assert.match(link, /^camera=0\.5,0\.3,1\.2&alpha=0\.1:0\.05&packed=1\.\d+\.[\w-]+$/);
    assert.ok(link.length < 30_000, `${link.length} characters`);
    assert.match(
      await page.getByTestId("no-code").innerText(),
      /2\d,\d{3} characters.*at most 2,331 characters/,
    );
    frame = await page.getByTestId("frame-line").inputValue();
    assert.deepEqual(await barriers(page), []);
    await page.getByTestId("with-model").setChecked(false);
    await page.locator(".code-picture").waitFor();
    assert.match(`${await page.getByTestId("code-address").getAttribute("href")}`, /#(?!.*packed)/);
  });

  it("opens for another visitor, who sees the same motion from the same side, without a further request", async () => {
    const { page } = await site.visit({ settings: link });
    await ready(page);
    await page.waitForLoadState("networkidle");
    const asked = await page.evaluate(() => performance.getEntriesByType("resource").map(({ name }) => name));
    const ownFiles =
      /\/some\/where\/(assets\/[\w/-]+\.(js|css|wasm)|unserved\.js|favicon\.svg|manifest\.webmanifest)$/;
    assert.deepEqual(
      asked.filter((address) => !ownFiles.test(address)),
      [],
    );
    assert.ok(asked.length > 10);
    const far = apart(await positions(page), moved);
    // Experts inferred again from rounded sums.
    assert.ok(far > 0 && far < 2e-3, `${far} m apart`);
    const again = await linkOf(page);
    assert.equal(again, link);
  });

  seldom.it("moves in a sandboxed frame of another page", async () => {
    assert.match(
      frame,
      /^<iframe src="[^"]+\?embed#[^"]+" title="[^"]+" [^>]*sandbox="allow-scripts allow-same-origin">/,
    );
    const { page } = await site.visit({ story: true });
    await page.setContent(`<!doctype html><title>A page</title>${frame}`);
    const inner = page.frameLocator("iframe");
    await inner.locator("html[data-engine=ready]").waitFor({ timeout: 30_000 });
    await inner.getByTestId("coupling-0-1").waitFor();
    assert.equal(await inner.locator("pg-header").count(), 0);
    const [, child] = page.frames();
    const address = new URL(child?.url() ?? "");
    assert.match(address.hash, /alpha=0\.1:0\.05&packed=1\./);
  });

  it("says what is wrong when it is cut off, in German too, and changes nothing when it is followed", async () => {
    const { page } = await site.visit({ settings: "alpha=0.1:3", locale: "de" });
    await ready(page);
    const before = await positions(page);
    await page.evaluate((cut) => Object.assign(location, { hash: cut }), link.slice(0, -500));
    const notice = page.locator("pg-notices");
    await notice.getByText(/Erwartet sind [\d.]+ Zeichen eines gepackten Modells, gefunden [\d.]+/).waitFor();
    assert.deepEqual(await positions(page), before);
    await page.waitForURL(/#(view=play&)?(model=[0-9a-f]{8}&)?alpha=0\.1:3$/);
  });

  seldom.it("of a newer version gets the words of the reader of models", async () => {
    const document = JSON.parse(readFileSync(at("www/first/model.json"), "utf8"));
    const newer = await packedText(JSON.stringify({ ...document, version: 99 }));
    const { page } = await site.visit({ settings: `packed=${newer}` });
    await ready(page);
    const notice = page.locator("pg-notices");
    assert.match(await notice.innerText(), /The model of this link was not opened\s+.*99/);
    assert.ok((await positions(page)).length > 1000);
  });
});

describe("a model without couplings on the stage", () => {
  const KINDS = /** @type {const} */ ([
    ["tmp", "TMP"],
    ["dmp-rhythmic", "DMP (rhythmic)"],
    ["map-cgpdm", "MAP CGPDM"],
  ]);
  const documentOf = (/** @type {string} */ kind) => at(`crate/vcgpdm/tests/library/documents/${kind}.json`);
  const shows = (/** @type {Page} */ page, /** @type {string} */ name) =>
    page
      .getByTestId("stage-title")
      .getByText(`Made by a ${name}`, { exact: true })
      .waitFor({ timeout: 30_000 });

  seldom.it("is what Save and Share carry, to another visitor too", async () => {
    const mine = await site.visit({ settings: "alpha=0.1:3" });
    await ready(mine.page);
    /** @type {{ name: string, link: string, moved: number[] }[]} */
    const made = [];
    for (const [kind, name] of KINDS) {
      await mine.page.getByTestId("open-model").setInputFiles(documentOf(kind));
      await shows(mine.page, name);
      const { name: file, text } = await saved(mine.page, "save-model");
      assert.deepEqual([file, text], [`${kind}.model.json`, readFileSync(documentOf(kind), "utf8")]);
      const moved = await positions(mine.page);
      const link = await linkOf(mine.page);
      assert.match(link, /^(?!.*alpha)(.*&)?packed=1\.\d+\.[\w-]+$/);
      made.push({ name, link, moved });
      await mine.page.keyboard.press("Escape");
    }
    assert.deepEqual(mine.problems, []);
    await mine.leave();

    const [first] = made;
    const other = await site.visit({ settings: first?.link ?? "" });
    for (const { name, link, moved } of made) {
      await other.page.evaluate((hash) => Object.assign(location, { hash }), link);
      await shows(other.page, name);
      const far = apart(await positions(other.page), moved);
      assert.ok(far < 1e-3, `${name}: ${far} m apart`);
      assert.equal(await linkOf(other.page), link);
      await other.page.keyboard.press("Escape");
    }
    await other.page.getByRole("button", { name: "Back to the model" }).click();
    await other.page.waitForURL(/#(?!.*packed)/);
    assert.deepEqual(other.problems, []);
    await other.leave();
  });
});

describe("a link to a file", () => {
  seldom.it("is offered with its QR code where the model makes the link too long for one", async () => {
    const { page } = await visitorWithMine();
    const moved = await positions(page);
    await linkOf(page);
    const [name, address] = [page.getByTestId("model-file"), page.getByTestId("short-address")];
    assert.match(await name.inputValue(), /^07_01-2-parts-[0-9a-f]{8}\.model\.json$/);
    await name.fill("models/a walk");
    await page.getByText(/Expected the name of a JSON file on the host of this page/).waitFor();
    assert.equal(await page.locator(".code-short .code-picture").count(), 0);
    await name.fill("models/walk.json");
    await page.locator(".code-short .code-picture").waitFor();
    const link = new URL(`${await address.getAttribute("href")}`).hash.slice(1);
    assert.equal(link, "camera=0.5,0.3,1.2&model=models/walk.json&alpha=0.1:0.05");
    const file = await saved(page, "save-short");
    assert.equal(file.name, "walk.json");
    assert.deepEqual(await barriers(page), []);
    await page.route("**/models/walk.json", (route) => route.fulfill({ body: file.bytes }));
    await address.click();
    await page.waitForURL(/#model=models\/walk\.json&alpha=0\.1:0\.05$/);
    assert.deepEqual(await positions(page), moved);
  });

  seldom.it("opens the model of the page's own host", async () => {
    const { page } = await site.visit({ settings: "model=first/model.json&alpha=0.1:0.05" });
    await ready(page);
    assert.ok((await positions(page)).length > 1000);
    assert.equal(await page.locator("pg-notices .notice").count(), 0);
    await page.keyboard.press("q");
    const address = `${await page.getByTestId("code-address").getAttribute("href")}`;
    assert.match(address, /model=first\/model\.json&alpha=0\.1:0\.05$/);
    await page.locator(".code-picture").waitFor();
  });

  seldom.it("asks no other host, and says what was expected", async () => {
    const { page } = await site.visit({ settings: "model=https://example.org/x.json" });
    await ready(page);
    await page
      .getByText(/Expected the name of a JSON file on the host of this page, found “https:\/\/example/)
      .waitFor();
  });
});
