// A motion that starts from any training frame, or from a clip that was not trained on, compared with the npm
// package.
import assert from "node:assert/strict";
import { it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { openPanel, openedSite, ready, saved, seldom } from "./site.mjs";
import { coupledInfo } from "../node/package.mjs";

const { Clip, Model, Trainer, TrainingSet } = builtPackage();

const site = openedSite();

/** A model of two sequences, trained for a few iterations. */
function twoSequences() {
  const clips = new TrainingSet();
  for (const sample of ["walk-1", "walk-2"]) clips.add(Clip.sample(sample).cut(0, 120));
  const { parts = [] } =
    Clip.sample("walk-1")
      .info()
      .presets.find(({ id }) => id === "lower-upper") ?? {};
  const settings = {
    latent: 2,
    dynamicsIps: 6,
    poseIps: 6,
    order: 2,
    framesPerSecond: 30,
    seed: 1,
    maxIterations: 8,
  };
  const trainer = new Trainer(clips, { ...settings, parts });
  while (!trainer.step().done);
  return trainer.model().toJson();
}

/** Opens the model of two sequences, and where its motion begins. */
async function openDocument(/** @type {import("playwright-core").Page} */ page) {
  const text = twoSequences();
  await page
    .locator("input[type=file][accept*=json]")
    .first()
    .setInputFiles({ name: "two.model.json", mimeType: "application/json", buffer: Buffer.from(text) });
  await openPanel(page, "more");
  await page.getByTestId("start-frame").waitFor();
  return text;
}

/** The latents of the first part in the saved motion, [frame][dimension], and the name of the file. */
async function savedLatents(/** @type {import("playwright-core").Page} */ page) {
  const { name, text } = await saved(page, "save-latents");
  const rows = text.trim().split("\r\n").slice(1);
  return { name, latents: rows.map((row) => row.split(",").slice(2, 4).map(Number)) };
}

it("starts from any frame of any sequence, and a link contains the frame", async () => {
  const { page } = await site.visit();
  await ready(page);
  await openPanel(page, "more");
  // The file of the page's first model has only the first frames.
  assert.equal(await page.getByTestId("start-frame").count(), 0);
  const text = await openDocument(page);
  const frame = page.getByTestId("start-frame");
  await page.getByRole("combobox", { name: "Start as in" }).selectOption("1");
  await page.getByTestId("scrub").fill("50");
  await frame.fill("30");
  // The motion is back at its start.
  assert.equal(await page.getByTestId("scrub").inputValue(), "0");

  const model = Model.fromJson(text);
  const rollout = model.rollout({ frames: 300, sequence: 1, frame: 30 });
  const { name, latents } = await savedLatents(page);
  assert.match(name, /-from-31-10s\.latents\.csv$/);
  for (const k of [0, 1, 299]) assert.deepEqual(latents[k], [...rollout.latents(0).slice(2 * k, 2 * k + 2)]);
  await page.waitForFunction(() => /frame=30/.test(location.hash) && /start=1/.test(location.hash));
  await frame.focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(
    await frame.getAttribute("aria-valuetext"),
    `Frame 32 of ${coupledInfo(model).startFrames[1]}`,
  );
});

seldom.it("starts with a clip that was not trained on, under any couplings", async () => {
  const { page } = await site.visit();
  await ready(page);
  const model = Model.fromJson(await openDocument(page));
  const select = page.getByRole("combobox", { name: "Start as in" });
  const groups = await select
    .locator("optgroup")
    .evaluateAll((groups) => groups.map((group) => [...group.children].map((option) => option.textContent)));
  assert.equal(groups[0]?.length, 2);
  assert.ok(groups[1]?.includes("Walk, trial 5") && !groups[1].includes("Walk, trial 1"), String(groups[1]));

  const shown = async (/** @type {import("vcgpdm").RolloutOptions} */ options) => {
    await page.waitForFunction(() => {
      const { model } = /** @type {any} */ (document.querySelector("pg-picture")).app;
      return JSON.stringify(model.rollout.request) === JSON.stringify(model.rolloutRequest());
    });
    const expected = model.rollout({ frames: 300, ...options }).latents(0);
    const rows = Array.from({ length: 300 }, (_, k) => [...expected.slice(2 * k, 2 * k + 2)]);
    const { name, latents } = await savedLatents(page);
    assert.deepEqual(latents, rows);
    return name;
  };
  await select.selectOption("Walk, trial 5");
  await page.locator("select[aria-label='Start as in'][aria-busy=false]").waitFor();
  assert.match((await page.getByTestId("clip-start").textContent()) ?? "", /first 0\.5 s/);
  const start = model.infer(Clip.sample("walk-5"), 15);
  assert.match(await shown({ start }), /-as-walk-trial-5-10s\.latents\.csv$/i);
  assert.equal(await page.getByTestId("start-frame").count(), 0);

  // A slider still acts. The motion on the stage starts with the clip, and so does its outline.
  const slider = page.getByTestId("coupling-1-0");
  await slider.focus();
  await page.keyboard.press("Home");
  await page.waitForFunction(
    () => /** @type {any} */ (document.querySelector("pg-stage")).stage.ghost !== null,
  );
  const { alpha, reading } = await page.evaluate(() =>
    /** @type {any} */ (document.querySelector("pg-picture")).app.model.rolloutRequest(),
  );
  assert.notDeepEqual(alpha, coupledInfo(model).alpha);
  await shown({ start, alpha, reading });

  await select.selectOption("1");
  await page.getByTestId("clip-start").waitFor({ state: "detached" });
  await page.waitForFunction(() => /start=1/.test(location.hash));
  await shown({ sequence: 1, alpha, reading });
});
