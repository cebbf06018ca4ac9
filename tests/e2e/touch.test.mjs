// The wheel of the live motion under a finger: a turn moves the part and does not scroll the page.
import assert from "node:assert/strict";
import { openedSite, ready, seldom, soon } from "./site.mjs";

const site = openedSite();

seldom.it("turns under a finger: the part follows, stands, and goes on without it", async () => {
  const { page } = await site.visit({
    ...{ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true },
    moving: true,
  });
  await ready(page);
  await page.getByTestId("live-on").tap();
  const wheel = page.getByTestId("wheel");
  await wheel.waitFor();
  await wheel.scrollIntoViewIfNeeded();
  /** The newest frame, the phase of the legs in it (turns), and the part that the wheel drives. */
  const newest = () =>
    page.locator("pg-live").evaluate((view) => {
      const { trace, driven } = /** @type {any} */ (view).live;
      const { frame, phases } = trace.at(-1);
      return { frame, legs: phases[0], driven };
    });
  const frames = async (/** @type {number} */ count) => {
    const end = (await newest()).frame + count;
    await soon(async () => assert.ok((await newest()).frame >= end, "the motion goes on"));
  };
  /** Turns between two phases, at most half a turn. */
  const apart = (/** @type {number} */ a, /** @type {number} */ b) => a - b - Math.round(a - b);

  const box = await wheel.boundingBox();
  assert.ok(box);
  const scrolled = () => page.evaluate(() => scrollY);
  const top = await scrolled();
  const cdp = await page.context().newCDPSession(page);
  const finger = (/** @type {"touchStart" | "touchMove"} */ type, /** @type {number} */ turns) => {
    const [x, y] = [Math.sin(2 * Math.PI * turns), -Math.cos(2 * Math.PI * turns)];
    const at = (/** @type {number} */ middle, /** @type {number} */ to) => middle + 0.4 * box.width * to;
    const touchPoints = [{ x: at(box.x + box.width / 2, x), y: at(box.y + box.height / 2, y) }];
    return cdp.send("Input.dispatchTouchEvent", { type, touchPoints });
  };

  await finger("touchStart", 0);
  await frames(6);
  const held = await newest();
  assert.equal(held.driven, 0);
  await frames(12);
  assert.ok(Math.abs(apart((await newest()).legs, held.legs)) < 0.02, "the legs stand still");
  for (let k = 1; k <= 12; k++) await finger("touchMove", k / 24);
  await frames(6);
  const turned = Math.abs(apart((await newest()).legs, held.legs));
  assert.ok(Math.abs(turned - 0.5) < 0.04, `half a turn of the wheel is ${turned} turns`);
  assert.equal(await scrolled(), top, "the page does not scroll");
  await cdp.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await soon(async () => assert.equal((await newest()).driven, null));
  const { legs } = await newest();
  await frames(8);
  assert.ok(Math.abs(apart((await newest()).legs, legs)) > 0.05, "the legs go on");
});
