// Parts by hand: the joints of each part, and the names of the parts.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { barriers, openedSite, ready, seldom } from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

const names = (/** @type {Page} */ page) => page.locator("pg-parts-editor .part-names input");
const message = (/** @type {Page} */ page) => page.locator("pg-parts-editor").getByRole("status");
const partOf = (/** @type {Page} */ page, joint = "") => page.getByLabel(`Part of ${joint}`, { exact: true });

/** The colour of the mark before the words of each row. */
const colours = (/** @type {Page} */ page, rows = "") =>
  page
    .locator(`${rows} .swatch`)
    .evaluateAll((all) => all.map((one) => getComputedStyle(one).backgroundColor));

describe("parts by hand", () => {
  it("have different names: a repeated name is refused, with a message until the next change", async () => {
    const { page } = await site.visit({ settings: "tab=learn" });
    await ready(page);
    await page.getByTestId("setting-parts").selectOption("hand");
    await names(page).nth(1).waitFor();
    const first = await names(page).nth(0).inputValue();
    const second = await names(page).nth(1).inputValue();
    for (const { name, why } of [
      { name: first, why: `Another part is called “${first}”.` },
      { name: " ", why: "A part needs a name." },
    ]) {
      await names(page).nth(1).fill(name);
      await names(page).nth(1).press("Enter");
      await message(page).filter({ hasText: why }).waitFor();
      assert.equal(await names(page).nth(1).inputValue(), second);
    }
    assert.deepEqual(await barriers(page), []);
    await page.getByTestId("add-part").click();
    await names(page).nth(2).waitFor();
    assert.equal(await message(page).innerText(), "");
  });

  seldom.it("have one colour each; a part without joints has no colour and is left out", async () => {
    const { page } = await site.visit({ settings: "tab=learn" });
    await ready(page);
    await page.getByTestId("setting-parts").selectOption("hand");
    await page.getByTestId("add-part").click();
    const empty = page.getByText("No joints: left out of training");
    await empty.waitFor();
    const [lower, upper, none] = await colours(page, "pg-parts-editor .part-names");
    // All joints below follow, also a joint with an earlier choice of its own.
    const [root, below] = await page
      .locator("pg-parts-editor select")
      .evaluateAll((all) => all.map((select) => select.getAttribute("aria-label")?.replace("Part of ", "")));
    await partOf(page, below).selectOption("1");
    await partOf(page, root).selectOption("2");
    await empty.nth(1).waitFor();
    assert.equal(await partOf(page, below).inputValue(), "2");
    assert.deepEqual(await colours(page, "pg-parts-editor .part-names"), [none, none, lower]);
    assert.deepEqual(await colours(page, ".part-row"), [lower]);
    assert.deepEqual([...new Set(await colours(page, ".joint-tree"))], [lower]);
    assert.notEqual(upper, lower);
  });

  seldom.it("get the names of the page when a link gives two parts the same name", async () => {
    const { page } = await site.visit({
      settings: "tab=learn&parts=hand&split=a:0-4;a:5-99",
    });
    await ready(page);
    await names(page).first().waitFor();
    const row = page.locator(".part-row li");
    const given = await names(page).evaluateAll((all) =>
      all.map((input) => /** @type {HTMLInputElement} */ (input).value),
    );
    assert.equal(given.length, await row.count());
    assert.equal(new Set(given).size, given.length);
    await names(page).first().fill("body");
    await names(page).first().press("Enter");
    await row.filter({ hasText: "body" }).waitFor();
  });
});
