// The texts of the page: the first screen, explanations of terms, and the method.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { barriers, oneVisitor, openedSite, openPanel, ready, readyVisitor, seldom } from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

describe("the first screen", () => {
  const visitor = oneVisitor(() => readyVisitor(site.visit()));

  it("describes the motion on the stage: the model, a clip, the model again", async () => {
    const { page } = visitor;
    const lead = page.getByTestId("lead");
    const caption = page.locator(".stage-caption");
    await openPanel(page, "learn");
    assert.match((await lead.textContent()) ?? "", /keep step/);
    assert.match(await caption.innerText(), /Made by the model\s+A rollout, learned from 3 clips/);
    assert.match(await page.getByTestId("progress").innerText(), /ticked sample clips and their body/);
    await page.getByText("Samples, made by a program").click();
    await page
      .getByRole("button", { name: /^Show / })
      .first()
      .click();
    assert.match((await lead.textContent()) ?? "", /This is a clip/);
    assert.match(await caption.innerText(), /not the model/);
    await page.getByRole("button", { name: "Back to the model" }).click();
    assert.match((await lead.textContent()) ?? "", /keep step/);
  });

  it("explains terms by keyboard, and Escape returns the focus", async () => {
    const { page } = visitor;
    await openPanel(page, "more");
    const alpha = page.locator("pg-more .term[data-term=alpha]");
    await alpha.focus();
    await page.keyboard.press("Enter");
    const card = page.getByRole("dialog", { name: /coupling variance/ });
    await card.waitFor();
    assert.ok(
      await card.evaluate((element) => element === document.activeElement),
      "a screen reader reads it",
    );
    assert.match(await card.innerText(), /the smaller it is, the more that prediction counts/);
    assert.deepEqual(await barriers(page), []);
    await page.keyboard.press("Escape");
    await card.waitFor({ state: "hidden" });
    assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("data-term")), "alpha");
  });
});

describe("a term", () => {
  seldom.it("is explained by touch on a phone, within the window, in the dark too", async () => {
    const { page, leave } = await site.visit({ ...PHONE, colorScheme: "dark" });
    await ready(page);
    for (const tab of /** @type {const} */ (["more", "learn", "numbers"])) {
      await openPanel(page, tab);
      const terms = page.locator(".lab > .panel .term:visible");
      await terms.first().waitFor();
      for (const term of [terms.first(), terms.last()]) {
        await term.tap();
        const card = page.locator(".term-card");
        await card.waitFor();
        const box = await card.boundingBox();
        assert.ok(
          box && box.x >= 0 && box.y >= 0 && box.x + box.width <= 390 && box.y + box.height <= 844,
          tab,
        );
        await page.keyboard.press("Escape");
      }
    }
    await leave();
  });

  it("is explained in every view", async () => {
    const { page, leave } = await site.visit({ settings: "view=compare" });
    await page.getByTestId("compare").waitFor();
    const names = await page
      .locator(".term")
      .evaluateAll((terms) => terms.map((term) => term.getAttribute("data-term")));
    for (const wanted of ["map", "tmp", "dmp", "bases", "fold", "inducing-point"])
      assert.ok(names.includes(wanted), wanted);
    await leave();
  });
});

describe("the method", () => {
  it("has equations, links each symbol to its control, and lists references", async () => {
    const { page } = await site.visit();
    await ready(page);
    await page.getByTestId("help").click();
    await page.getByRole("button", { name: /^The method/ }).click();
    await page.locator("pg-method math").first().waitFor();
    assert.match(page.url(), /view=method/);
    assert.deepEqual(await barriers(page), []);
    assert.match(await page.getByTestId("bibtex").innerText(), /10\.3390\/e20100724/);
    const places = await page
      .locator("[data-place]")
      .evaluateAll((all) => all.map((one) => one.getAttribute("data-place")));
    for (const place of new Set(places)) {
      await page.locator(`[data-place="${place}"]`).first().click();
      const focused = () => document.activeElement?.closest("main:not(.on-demand)") !== null;
      assert.ok(await page.evaluate(focused), `${place} leads to a control`);
      // Back before the address has changed would lead past the method.
      await page.waitForURL((url) => !url.hash.includes("view=method"));
      await page.goBack();
      await page.locator("pg-method math").first().waitFor();
    }
  });

  it("fits a phone", async () => {
    const { page, leave } = await site.visit({ ...PHONE, settings: "view=method" });
    await page.locator("pg-method math").first().waitFor();
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390);
    await leave();
  });
});
