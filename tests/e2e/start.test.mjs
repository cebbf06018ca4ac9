// A motion that starts from any training frame, compared with the npm package.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { after, before, it } from "node:test";
import { at } from "../../scripts/run.mjs";
import { openCouplingsTable, openSite, ready, saved } from "./site.mjs";
import { coupledInfo } from "../node/package.mjs";

/** @type {typeof import("vcgpdm")} */
const { Clip, Model, Trainer, TrainingSet } = createRequire(import.meta.url)(
  at("crate/wasm/pkg/node/vcgpdm.js"),
);

/** @type {Awaited<ReturnType<typeof openSite>>} */
let site;
before(async () => {
  site = await openSite();
});
after(() => site?.close());

/** A model of two sequences, trained for a few iterations. */
function document() {
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

it("starts from any frame of any sequence, and a link contains the frame", async () => {
  const { page, problems, leave } = await site.visit();
  await ready(page);
  // The file of the page's first model has only the first frames.
  assert.equal(await page.getByTestId("start-frame").count(), 0);
  const text = document();
  await page
    .locator("input[type=file][accept*=json]")
    .first()
    .setInputFiles({ name: "two.model.json", mimeType: "application/json", buffer: Buffer.from(text) });
  await openCouplingsTable(page);
  const frame = page.getByTestId("start-frame");
  await frame.waitFor();
  await page.getByRole("combobox", { name: "Start as in" }).selectOption("1");
  await page.getByTestId("scrub").fill("50");
  await frame.fill("30");
  // The motion is back at its start.
  assert.equal(await page.getByTestId("scrub").inputValue(), "0");

  const model = Model.fromJson(text);
  const rollout = model.rollout({ frames: 300, sequence: 1, frame: 30 });
  const { name, text: csv } = await saved(page, "save-latents");
  assert.match(name, /-from-31-10s\.latents\.csv$/);
  const rows = csv.trim().split("\r\n").slice(1);
  for (const k of [0, 1, 299]) {
    const latents = rows[k]?.split(",").slice(2, 4).map(Number);
    assert.deepEqual(latents, [...rollout.latents(0).slice(2 * k, 2 * k + 2)]);
  }
  await page.waitForFunction(() => /frame=30/.test(location.hash) && /start=1/.test(location.hash));
  await frame.focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(
    await frame.getAttribute("aria-valuetext"),
    `Frame 32 of ${coupledInfo(model).startFrames[1]}`,
  );
  assert.deepEqual(problems, []);
  await leave();
});
