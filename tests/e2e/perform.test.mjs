// What a visitor makes live: two keys as the feet, a recording, a model of it.
import assert from "node:assert/strict";
import { barriers, countTones, openedSite, ready, saved, seldom } from "./site.mjs";

const site = openedSite();

seldom.it("walks by two keys, and what was done becomes a clip and a model", async (test) => {
  const { page } = await site.visit({ moving: true });
  await ready(page);
  const began = Date.now();
  await page.locator("#open-more").click();
  const tones = await countTones(page);
  await page.getByTestId("sound").click();
  await page.getByTestId("live-on").click();
  await page.getByTestId("feet").click();
  await page.waitForFunction(() => /** @type {any} */ (document.querySelector("pg-perform")).waits === false);
  await page.getByTestId("record").click();
  /** Where the body stands, in metres. */
  const place = () =>
    page.locator("pg-perform").evaluate((view) => {
      const [x, , z] = /** @type {any} */ (view).playback.pose;
      return [x, z];
    });
  const way = async (/** @type {() => Promise<unknown>} */ act) => {
    const [x, z] = await place();
    await act();
    const [a, b] = await place();
    return Math.hypot(a - x, b - z);
  };
  const walked = await way(async () => {
    for (let step = 0; step < 8; step++) {
      await page.keyboard.press(step % 2 === 0 ? "f" : "j");
      await page.waitForTimeout(600);
    }
  });
  assert.ok(walked > 2, `eight steps are ${walked} m`);
  assert.ok((await tones()) > 4, `eight steps are ${await tones()} clicks`);
  await page.waitForTimeout(1500);
  const stood = await way(() => page.waitForTimeout(500));
  assert.ok(stood < 0.02, `the body glides ${stood} m while nobody steps`);
  await page.keyboard.press("f");
  await page.keyboard.press("f");
  await page.getByTestId("perform").getByText("no step of this cycle").waitFor();
  assert.deepEqual(await barriers(page), []);
  await page.getByTestId("record").click();
  await page.getByTestId("train-performed").click();
  await page.waitForFunction(() => {
    const { model } = /** @type {any} */ (document.querySelector("pg-lab")).app.model;
    return model.info.sequences[0].name.startsWith("performed 1");
  });
  const seconds = (Date.now() - began) / 1000;
  test.diagnostic(`from the button to a model of the own walk: ${seconds.toFixed(0)} s`);
  assert.ok(seconds < 30);
  await page.getByRole("button", { name: "Show performed 1" }).click();
  const note = page.locator(".stage-caption span").first();
  assert.match(await note.innerText(), /^Made by you, live .* two fingers as the feet/);
  const { name, text } = await saved(page, "save-motion");
  assert.match(name, /^performed-1-live-from-.+\.bvh$/);
  assert.match(text, /^HIERARCHY/);
  const account = JSON.parse((await saved(page, "save-account")).text);
  assert.equal(account.motion, name);
  assert.match(account.made, /^Made by you, live from the model .* two fingers as the feet/);
});
