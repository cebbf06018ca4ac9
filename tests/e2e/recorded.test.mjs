// Movements of real people: their models on the stage, and clips that the models made, to train on.
import assert from "node:assert/strict";
import { after, before, it } from "node:test";
import { barriers, openSite, openPanel, ready } from "./site.mjs";

/** @type {Awaited<ReturnType<typeof openSite>>} */
let site;
before(async () => {
  site = await openSite();
});
after(() => site?.close());

it("opens a model of a recorded run, and trains on clips that the model of the walk made", async () => {
  const { page, problems, leave } = await site.visit({
    settings: "tab=learn&fps=15&iterations=15&dynamics=6&poses=8",
  });
  await ready(page);
  await openPanel(page, "learn");
  await page.getByTestId("real-people").locator("summary").click();
  const run = page.getByTestId("recorded-run");
  await run.waitFor({ timeout: 60_000 });
  assert.match(await page.getByTestId("real-people").innerText(), /NSF EIA-0196217/);
  const titles = await page.getByTestId("model-clips").locator(".clip-title").allInnerTexts();
  assert.deepEqual(titles, [
    ...["Walk 1", "Walk 2"].map((title) => `${title}, by a model of CMU 35`),
    "Jumping jacks 1, by a model of CMU",
    ...["Run 1", "Run 2"].map((title) => `${title}, by a model of CMU 35`),
    "Wave 1, by a model of CMU 141",
  ]);
  assert.deepEqual(await barriers(page), []);

  const model = () =>
    page.evaluate(() => /** @type {any} */ (document.querySelector("pg-page")).app.model.id);
  const first = await model();
  await run.click();
  await page.waitForFunction(
    (first) => /** @type {any} */ (document.querySelector("pg-page")).app.model.id !== first,
    first,
  );
  const opened = await model();
  const joints = () =>
    page.evaluate(
      () => /** @type {any} */ (document.querySelector("pg-page")).app.model.model.info.joints.length,
    );
  assert.equal(await joints(), 31);

  // The made walks have another body.
  for (const title of titles.slice(0, 2)) await page.getByLabel(`Train on ${title}`).check();
  const ticked = () =>
    page.evaluate(() =>
      /** @type {any} */ (document.querySelector("pg-page")).app.clips.ticked.map(
        (/** @type {{ title: string }} */ { title }) => title,
      ),
    );
  assert.deepEqual(await ticked(), titles.slice(0, 2));
  assert.equal(await page.getByTestId("clash").count(), 0);
  await page.getByTestId("train").click();
  await page.waitForFunction(
    (opened) => /** @type {any} */ (document.querySelector("pg-page")).app.model.id !== opened,
    opened,
    { timeout: 120_000 },
  );
  assert.equal(await joints(), 31);
  assert.deepEqual(problems, []);
  await leave();
});
