// A link dares its receiver, whose page says when the dare is met.
import assert from "node:assert/strict";
import { it } from "node:test";
import { barriersNow, openedSite, ready, soon, seldom } from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

/** The fragment of the link of the dialog, with a dare chosen there. */
async function linkWith(/** @type {Page} */ page, /** @type {string} */ dare) {
  await page.getByTestId("code").waitFor();
  await page.getByTestId("dare").last().selectOption({ label: dare });
  if (await page.getByTestId("dare-line").count()) await page.getByTestId("dare-line").fill("Can you?");
  assert.deepEqual(await barriersNow(page), []);
  const link = new URL((await page.getByTestId("code-address").getAttribute("href")) ?? "");
  return link.hash.slice(1);
}

it("stops the arms of a body with one arrow", async () => {
  const { page } = await site.visit({ settings: "view=play&alpha=0.1:3" });
  await ready(page);
  await page.keyboard.press("q");
  const link = await linkWith(page, "Stop the arms with one arrow. The legs must walk on.");
  assert.doesNotMatch(link, /alpha/);
  const other = await site.visit({ settings: link });
  await ready(other.page);
  const card = other.page.getByTestId("exercise");
  await card.getByText("Not yet.").waitFor();
  assert.equal(await card.getByTestId("said").innerText(), "“Can you?”");
  await other.page.getByTestId("coupling-0-1").fill("-3");
  await card.getByText("You have met the dare.").waitFor();
  assert.deepEqual(await barriersNow(other.page), []);
  // A second arrow is one too many.
  await other.page.getByTestId("coupling-1-0").fill("-3");
  await card.getByText("Not yet.").waitFor();
  await other.page.getByTestId("close-exercise").click();
  await soon(async () => assert.doesNotMatch(other.page.url(), /says|exercise/));
});

seldom.it("stops one hand of a drawing with one arrow", async () => {
  // The exercise of a class has the task of the dare. Not every drawing of two hands can meet it: the example can.
  const { page } = await site.visit({ settings: "view=draw&exercise=9" });
  await ready(page);
  const drawn = (/** @type {Page} */ at) =>
    at.waitForFunction(() => document.querySelectorAll("pg-drawing pg-latent-plot").length === 2, null, {
      timeout: 60_000,
    });
  await page.getByTestId("draw-example").click();
  await drawn(page);
  await page.waitForFunction(() => /hand=01\./.test(location.hash));
  assert.equal(await page.getByTestId("dare").getAttribute("data-met"), "no");
  await page.getByTestId("says").fill("Can you?");
  await page.getByTestId("send").click();
  const link = await linkWith(page, "Stop one hand with one arrow. The other hand must draw on.");
  const other = await site.visit({ settings: link });
  await drawn(other.page);
  const dare = other.page.getByTestId("dare");
  assert.equal(await dare.getAttribute("data-met"), "no");
  // The wrong arrow, then the one that the left hand follows.
  const arrow = (/** @type {string} */ pair) =>
    other.page.locator(`pg-drawing [data-testid=coupling-${pair}]`);
  await arrow("0-0").fill("-3");
  await other.page.getByTestId("series-reset").click();
  await arrow("1-0").fill("-3");
  const done = dare.getByText("Done: one arrow stopped one hand, and the other draws on.");
  await done.waitFor({ timeout: 60_000 });
  assert.deepEqual(await barriersNow(other.page), []);
});
