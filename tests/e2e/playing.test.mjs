// The clock, and couplings with their motion.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import {
  draws,
  oneVisitor,
  openedSite,
  ready,
  readyVisitor,
  recolour,
  saved,
  seldom,
  soon,
} from "./site.mjs";

const site = openedSite();

describe("the clock", () => {
  it("plays, pauses, steps and scrubs", async () => {
    const { page } = await site.visit({ moving: true });
    await ready(page);
    await page.keyboard.press("Space");
    await page.getByRole("button", { name: "Play", exact: true }).waitFor();
    const scrub = page.getByTestId("scrub");
    await scrub.fill("20");
    await page.getByRole("button", { name: "One frame forward" }).click();
    assert.equal(await scrub.inputValue(), "21");
    await page.getByRole("button", { name: "One frame back" }).click();
    assert.equal(await scrub.inputValue(), "20");
    await page.getByTestId("play").click();
    await soon(async () => assert.ok(Number(await scrub.inputValue()) >= 25));
    const length = page.getByTestId("length");
    await length.fill("60");
    await length.blur();
    assert.equal(await length.inputValue(), "40");
    assert.equal(await page.getByTestId("length-limit").innerText(), "At most 40.");
    await length.fill("10");
    await length.blur();
    assert.equal(await page.getByTestId("length-limit").innerText(), "");
  });
});

describe("the stage", () => {
  // The list of media whose `matches` every picture read got no event: the stage stayed light on a dark page.
  seldom.it("turns dark with the system while the figure moves", async () => {
    const { page } = await site.visit({ seen: true, moving: true });
    await ready(page);
    const background = () =>
      page.getByTestId("stage").evaluate((canvas) => {
        const gl = /** @type {HTMLCanvasElement} */ (canvas).getContext("webgl2");
        return gl ? [...gl.getParameter(gl.COLOR_CLEAR_VALUE)].slice(0, 3) : [];
      });
    const brightest = async () => Math.max(...(await background()));
    assert.ok((await brightest()) > 0.8, String(await background()));
    await recolour(page, "dark");
    for (let k = 0; k < 100 && (await brightest()) > 0.3; k++) await page.waitForTimeout(50);
    assert.ok((await brightest()) < 0.3, `a dark page has a stage of ${await background()}`);
  });

  seldom.it("keeps the camera at the same side of the walker for two minutes", async () => {
    const { page } = await site.visit();
    await ready(page);
    // Degrees between the camera and the hips in 2-minute play, the mean of each 5 seconds.
    const { angles, turned } = await page.evaluate(() => {
      const { playback, scene, stage } = /** @type {any} */ (document.querySelector("pg-stage"));
      const { joints, figure } = stage.content;
      const hip = (/** @type {string} */ side) =>
        3 * figure.nodes.findIndex((/** @type {any} */ node) => joints[node.joint] === `${side}UpLeg`);
      const [left, right] = [hip("Left"), hip("Right")];
      playback.play();
      const angles = [];
      const headings = [];
      let [sum, before] = [0, 0];
      for (let k = 0; k < 24 * 75; k++) {
        playback.advance(1 / 15);
        scene.draw(1 / 15);
        const { pose } = playback;
        const heading = Math.atan2(pose[right + 2] - pose[left + 2], pose[left] - pose[right]);
        const [x, , z] = scene.dragged(0, 100, 0);
        const apart = Math.atan2(-z, x) - heading;
        before = apart - 2 * Math.PI * Math.round((apart - before) / (2 * Math.PI));
        sum += before / 75;
        if (k % 75 < 74) continue;
        angles.push((sum * 180) / Math.PI);
        headings.push((heading * 180) / Math.PI);
        sum = 0;
      }
      return { angles, turned: Math.abs((headings.at(-1) ?? 0) - (headings[0] ?? 0)) };
    });
    assert.ok(turned > 90, `the walker turns, ${turned}`);
    for (const angle of angles) assert.ok(Math.abs(angle - (angles[0] ?? 0)) < 6, angles.join(" "));
  });

  seldom.it("reports lost graphics, and draws again when the browser restores them", async () => {
    const { page, leave } = await site.visit({ moving: true });
    await ready(page);
    await page.evaluate(() => {
      const context = document.querySelector("canvas")?.getContext("webgl2");
      const taken = context?.getExtension("WEBGL_lose_context");
      taken?.loseContext();
      Object.assign(window, { taken });
    });
    await page.getByRole("alert").filter({ hasText: "taken the 3-D graphics away" }).waitFor();
    await page.getByTestId("coupling-0-1").press("ArrowLeft");
    await page.evaluate(() => /** @type {any} */ (window).taken.restoreContext());
    await page.getByRole("alert").filter({ hasText: "3-D graphics" }).waitFor({ state: "detached" });
    await draws(page.getByTestId("stage"));
    await leave();
  });
});

describe("a coupling", () => {
  const visitor = oneVisitor(() => readyVisitor(site.visit({ moving: true })));

  it("changes its weight and the motion when its slider is dragged, and the key 0 resets it", async () => {
    const { page } = visitor;
    const slider = page.getByTestId("coupling-0-1");
    const weight = page.getByTestId("weight-0-1");
    const [asLearned, weightAsLearned] = [await saved(page, "save-motion"), await weight.textContent()];

    const box = await slider.boundingBox();
    assert.ok(box);
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(box.x + 4, y, { steps: 12 });
    await page.mouse.up();
    await page.waitForFunction(
      (before) => document.querySelector("[data-testid=weight-0-1]")?.textContent !== before,
      weightAsLearned,
    );
    const changed = await saved(page, "save-motion");
    assert.notEqual(changed.text, asLearned.text);
    assert.match(new URL(page.url()).hash, /alpha=0\.1:/);

    await page.getByTestId("reading").selectOption("as-learned");
    const kept = await saved(page, "save-motion");
    assert.notEqual(kept.text, changed.text, "experts as learned give another motion");
    await page.getByTestId("reading").selectOption("re-inferred");

    await page.keyboard.press("0");
    await page.waitForFunction(
      (before) => document.querySelector("[data-testid=weight-0-1]")?.textContent === before,
      weightAsLearned,
    );
    assert.equal((await saved(page, "save-motion")).text, asLearned.text);
  });

  it("redraws the motion while it is dragged", async (test) => {
    const { page } = visitor;
    const slider = page.getByTestId("coupling-0-1");
    await slider.focus();
    for (let i = 0; i < 30; i++) {
      await page.keyboard.press("ArrowLeft");
      await page.waitForTimeout(30);
    }
    const times = await page.evaluate(() =>
      performance.getEntriesByName("coupling-redraw").map(({ duration }) => duration),
    );
    assert.ok(times.length >= 10, `${times.length} redraws`);
    const median = times.sort((a, b) => a - b)[times.length >> 1] ?? NaN;
    test.diagnostic(`median ${median.toFixed(1)} ms from slider to new motion of 300 frames`);
    // The goal is one frame, 16 ms. The test reports the time without checking it, because the machine may
    // draw in software.
    assert.ok(median > 0, `median ${median} ms`);
  });
});
