// The Lab in two languages: its frame, the stage and the tab Listen.
import assert from "node:assert/strict";
import { after, before, describe, it } from "node:test";
import { barriers, openSite, ready } from "./site.mjs";

/** @type {Awaited<ReturnType<typeof openSite>>} */
let site;
before(async () => {
  site = await openSite();
});
after(() => site?.close());

describe("the Lab in German", () => {
  for (const viewport of [
    { width: 1280, height: 720 },
    { width: 390, height: 844 },
  ])
    it(`fits, and says what it measures: ${viewport.width} x ${viewport.height}`, async () => {
      const { page, problems, leave } = await site.visit({ locale: "de-DE", viewport });
      await ready(page);
      await page.getByTestId("preset-arms-go").click();
      await page.getByText("nicht im Gleichschritt").first().waitFor();
      assert.match(await page.getByTestId("measured").innerText(), /schwingt 0,8\d × so weit/);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), viewport.width);
      assert.deepEqual(await barriers(page), []);
      assert.deepEqual(problems, []);
      await leave();
    });

  it("follows the switch, and keeps the couplings", async () => {
    const { page, problems, leave } = await site.visit({ locale: "en-GB" });
    await ready(page);
    await page.getByTestId("preset-arms-go").click();
    await page.getByTestId("language").click();
    await page.getByRole("tab", { name: "Schleifen" }).waitFor();
    assert.equal(await page.locator("html").getAttribute("lang"), "de");
    assert.equal(await page.getByTestId("preset-arms-go").getAttribute("aria-pressed"), "true");
    await page.getByTestId("language").click();
    await page.getByRole("tab", { name: "Loops" }).waitFor();
    assert.deepEqual(problems, []);
    await leave();
  });
});
