// The seventh chapter of the story: a pulled walk comes home, by button, pointer and keyboard.
import assert from "node:assert/strict";
import { openedSite, seldom, soon } from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

/** The seconds of the last way home, and the live walk's distances around it as the library computed them. */
async function wayHome(/** @type {Page} */ page) {
  const found = page.getByTestId("homecoming");
  await found.waitFor();
  const text = await found.innerText();
  const seconds = Number(await found.getAttribute("data-seconds"));
  const measured = await page.locator("pg-push-hands").evaluate((hands) => {
    const { live, body } = /** @type {any} */ (hands).chapter;
    const { from } = live.marks.at(-1);
    return { trace: live.trace, from, frameTime: body.model.model.info.frameTime };
  });
  return { text, seconds, ...measured };
}

seldom.it("measures how a pulled hand comes home, and lets the visitor pull again", async () => {
  const { page } = await site.visit({ moving: true, settings: "story=7" });
  await page.getByTestId("choice-back").waitFor();
  // Nothing can be pulled before the guess.
  assert.equal(await page.getByTestId("pull").count(), 0);
  await page.getByTestId("choice-back").click();
  const { text, seconds, trace, from, frameTime } = await wayHome(page);
  assert.match(text, /later all was on its loop again/);
  assert.ok(seconds > 0 && seconds < 4, `${seconds} s`);
  const away = trace.filter((/** @type {any} */ { frame }) => frame >= from && frame < from + 150);
  // Home is twice as far from the loop as before the pull, which is never more than this.
  const limit = 0.3;
  const farthest = Math.max(...away.map((/** @type {any} */ { distances }) => distances[1]));
  assert.ok(farthest > 2 * limit, `the arms left their loop: ${farthest}`);
  const home = away.filter((/** @type {any} */ { frame }) => (frame - from) * frameTime >= seconds - 1e-6);
  for (const { distances } of home.slice(0, 30))
    assert.ok(Math.max(...distances) <= limit + 0.005, `${distances} within ${limit}`);

  // By keyboard.
  await page.getByTestId("pull").focus();
  await page.keyboard.press("Enter");
  await page.getByTestId("homecoming").waitFor({ state: "detached" });
  await wayHome(page);

  // By pointer.
  const hand = await page.locator("pg-push-hands").evaluate((hands) => {
    const { left, top } = hands.getBoundingClientRect();
    const { x, y } = new DOMMatrix(
      getComputedStyle(/** @type {Element} */ (hands.querySelector(".push-ring"))).transform,
    ).transformPoint();
    return { x: left + x, y: top + y };
  });
  await page.mouse.move(hand.x, hand.y);
  await page.mouse.down();
  await page.mouse.move(hand.x + 90, hand.y - 90, { steps: 8 });
  await page.mouse.up();
  await page.getByTestId("homecoming").waitFor({ state: "detached" });
  await wayHome(page);

  // Be the legs: what the card says of the pull stays.
  const said = await page.getByTestId("homecoming").innerText();
  const legs = () =>
    page.locator("pg-push-hands").evaluate((hands) => {
      const { driven, trace } = /** @type {any} */ (hands).chapter.live;
      return { driven, phase: trace.at(-1).phases[0] };
    });
  await page.getByTestId("wheel").focus();
  await page.keyboard.press("ArrowLeft");
  const begun = await legs();
  assert.equal(begun.driven, 0);
  for (let k = 0; k < 5; k++) await page.keyboard.press("ArrowLeft");
  await soon(async () => {
    const turns = (await legs()).phase - begun.phase;
    assert.ok(turns - Math.round(turns) < -0.15, `back by ${turns} turns`);
  });
  await page.keyboard.press("Escape");
  assert.equal((await legs()).driven, null);
  assert.equal(await page.getByTestId("homecoming").innerText(), said);

  await page.getByTestId("chapter-next").click();
  assert.equal(await page.locator("pg-push-hands").count(), 0);
});
