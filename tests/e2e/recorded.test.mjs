// Movements of real people: their models on the stage, and clips that the models made, to train on.
import assert from "node:assert/strict";
import { barriers, openPanel, openedSite, ready, seldom } from "./site.mjs";

const site = openedSite();

seldom.it("opens a model of a recorded run, and trains on clips that a model made", async () => {
  const { page } = await site.visit({
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
});

// A recording moves one part in the Lab, and the model infers the other: until the observation ends.

/** @typedef {import("playwright-core").Page} Page */

/** The numbers in the text of a part's error. */
const numbersOf = async (/** @type {Page} */ page, /** @type {number} */ part) => {
  const text = (await page.getByTestId(`completed-${part}`).textContent()) ?? "";
  return (text.match(/\d+\.\d+/g) ?? []).map(Number);
};

seldom.it("a recording gives the legs, the model infers the arms, and goes on by itself", async () => {
  const { page } = await site.visit({ settings: "tab=more" });
  await ready(page);
  const panel = page.getByTestId("completing");
  await panel.locator("summary").click();
  await page.getByTestId("complete").click();
  await page.getByTestId("completed-1").waitFor();
  const [whole = NaN, ...none] = await numbersOf(page, 1);
  assert.ok(whole > 0 && whole < 0.5, `the arms of a walk from its legs: ${whole}`);
  assert.equal(none.length, 0);
  assert.match((await page.getByTestId("stage-title").textContent()) ?? "", /One part recorded/);
  const motions = () =>
    page.locator("pg-stage").evaluate((view) => {
      const { content, ghost } = /** @type {any} */ (view).stage;
      return { kind: content.kind, figure: [...content.motion.positions], outline: [...ghost.positions] };
    });
  const seen = await motions();
  assert.equal(seen.kind, "completed");
  assert.equal(seen.figure.length, seen.outline.length);
  const apart = seen.figure.map((x, k) => Math.abs(x - (seen.outline[k] ?? 0)));
  assert.ok(Math.max(...apart) > 0.01, "the inferred arms are not the recorded ones");

  // With the keyboard: the observation ends earlier, and the arms' error afterwards is another number.
  const until = page.getByTestId("completing-until");
  await until.focus();
  await page.keyboard.press("Home");
  await page.waitForFunction(() =>
    /afterwards/.test(document.querySelector("[data-testid=completed-1]")?.textContent ?? ""),
  );
  assert.equal((await numbersOf(page, 1)).length, 2);

  // The arms give, the legs are inferred.
  await page.getByTestId("given-1").click();
  await page.getByTestId("completed-0").waitFor();

  // Other couplings complete the recording again, and the model's own motion is one press away.
  await page.getByTestId("complete").click();
  await page.waitForFunction(
    () => /** @type {any} */ (document.querySelector("pg-stage")).stage.content.kind === "model",
  );
  assert.equal(await page.getByTestId("completed-0").count(), 0);
});
