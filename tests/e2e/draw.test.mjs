// Drawings of one hand and of two, by keyboard and by pointer, and the model that goes on with them.
import assert from "node:assert/strict";
import { it } from "node:test";
import {
  barriers,
  changes,
  countTones,
  ACCESSIBLE,
  keepsNobodyOut,
  openedSite,
  ready,
  readyVisitor,
  saved,
  soon,
  squares,
} from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

const learned = (/** @type {Page} */ page, /** @type {number} */ hands) =>
  page.waitForFunction(
    (hands) =>
      document.querySelectorAll("pg-drawing pg-latent-plot").length === hands &&
      /goes on|does not go on/.test(document.querySelector("[data-testid=draw-words]")?.textContent ?? ""),
    hands,
    { timeout: 60_000 },
  );

it("a model goes on with one hand, then with two, whose couplings can be changed", async () => {
  const { page, problems, leave } = await site.visit({ settings: "view=draw", seen: true });
  await ready(page);
  await page.getByTestId("pad-0").focus();
  await squares(page);
  await learned(page, 1);
  assert.equal(
    await page.getByTestId("draw-words").textContent(),
    "The model draws: it goes on as your hand did.",
  );
  assert.ok(await changes(page.getByTestId("pad-0")), "the pen moves");

  // Before its end is reached, the rollout goes on from the frame now.
  const frame = (/** @type {number} */ left) =>
    page.evaluate((left) => {
      const { clock } = /** @type {any} */ (document.querySelector("pg-drawing")).store.model;
      if (left > 0) clock.seek(clock.lastFrame - left);
      return clock.frame;
    }, left);
  assert.ok((await frame(20)) > 300);
  await soon(async () => assert.ok((await frame(0)) < 100));

  const box = (await page.getByTestId("pad-1").boundingBox()) ?? assert.fail();
  const at = (/** @type {number} */ turn) =>
    /** @type {const} */ ([
      box.x + box.width * (0.5 + 0.3 * Math.cos(turn)),
      box.y + box.height * (0.5 + 0.2 * Math.sin(turn)),
    ]);
  await page.mouse.move(...at(0));
  await page.mouse.down();
  for (let i = 0; i < 120; i++) await page.mouse.move(...at(i / 8));
  await page.mouse.up();
  await learned(page, 2);
  const rolled = () =>
    page.evaluate(() =>
      Array.from(/** @type {any} */ (document.querySelector("pg-drawing")).store.model.rollout.values).join(),
    );
  const before = await rolled();
  await page.locator("pg-drawing [data-testid=coupling-1-1]").fill("-3");
  await soon(async () => assert.notEqual(await rolled(), before));
  await page.getByTestId("series-reset").click();
  await soon(async () => assert.equal(await rolled(), before));
  await page.getByTestId("back-0").click();
  await soon(async () => assert.notEqual(await rolled(), before));

  // A tone for each hand.
  const tones = await countTones(page);
  await page.getByTestId("sound").click();
  await soon(async () => assert.equal(await tones(), 2));

  const play = page.getByTestId("draw-play");
  await play.click();
  await soon(async () => assert.equal(await play.getAttribute("aria-label"), "Play"));
  const loop = page.locator("pg-drawing .plot").first();
  const bare = await loop.screenshot();
  await page.getByTestId("futures").click();
  await page.getByTestId("other-futures").waitFor();
  await soon(async () => assert.ok(!(await loop.screenshot()).equals(bare), "futures are drawn"));

  const drawing = await saved(page, "save-drawing");
  assert.match(drawing.text, /^time,left_x,left_y,right_x,right_y\n0\.000,/);
  const model = await saved(page, "save-drawing-model");
  assert.deepEqual(
    JSON.parse(model.text).parts?.map((/** @type {{ name: string }} */ { name }) => name),
    ["left", "right"],
  );
  assert.deepEqual(await barriers(page), []);

  // A link sends the drawing with a line, and another visitor's page learns it again.
  await page.getByTestId("says").fill("Can you stop <b>my</b> left hand?");
  await page.getByTestId("send").click();
  await page.getByTestId("code").waitFor();
  const link = new URL((await page.getByTestId("code-address").getAttribute("href")) ?? "");
  await page.keyboard.press("Escape");
  const other = await site.visit({ settings: link.hash.slice(1) });
  await learned(other.page, 2);
  assert.equal(await other.page.getByTestId("said").innerText(), "“Can you stop <b>my</b> left hand?”");
  assert.equal(new URL(other.page.url()).hash, link.hash, "the link stays as it was sent");
  assert.deepEqual(other.problems, []);
  await other.leave();

  await page.getByTestId("draw-clear").click();
  await page.getByTestId("draw-example").waitFor();
  await soon(async () => assert.doesNotMatch(page.url(), /hand=/));
  const pad = page.getByTestId("pad-0");
  await pad.click();
  await page.getByText("That was too little").waitFor();
  assert.deepEqual(problems, []);
  await leave();
});

it(
  ACCESSIBLE,
  keepsNobodyOut(
    () => readyVisitor(site.visit({ settings: "view=draw" })),
    async (page, fits) => {
      await fits("empty");
      await page.getByTestId("draw-example").click();
      await learned(page, 2);
      await fits("two hands");
    },
  ),
);
