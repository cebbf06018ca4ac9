// The couplings panel: the effects of presets are measured, sliders and bars move, both readings appear side by
// side.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe, it } from "node:test";
import { at } from "../../scripts/run.mjs";
import {
  barriers,
  choosePreset,
  draws,
  isMeasured,
  oneVisitor,
  openedSite,
  openPanel,
  ready,
  readyVisitor,
  saved,
  seldom,
  soon,
} from "./site.mjs";

/**
 * @typedef {import("playwright-core").Page} Page
 * @typedef {{ id: string, name: string }} Preset
 */

/** @type {Preset[]} */
const presets = JSON.parse(readFileSync(at("www/first/presets.json"), "utf8"));
const PARTS = ["lower", "upper"];

const site = openedSite();

/** The measures on the page, once they belong to the present motion. */
async function measured(/** @type {Page} */ page) {
  await isMeasured(page);
  const text = async (/** @type {string} */ testId) => {
    const element = page.getByTestId(testId);
    return (await element.count()) > 0 ? element.innerText() : "";
  };
  return {
    parts: await Promise.all(PARTS.map((_, part) => text(`measured-${part}`))),
    step: await text("measured-step"),
    trouble: await text("measured-trouble"),
  };
}

/** The coupling variances in the page's address, by "source.target". */
async function alphasOf(/** @type {Page} */ page) {
  const text = new URLSearchParams(new URL(page.url()).hash.slice(1)).get("alpha") ?? "";
  const entries = text.split(",").filter(Boolean);
  return new Map(
    entries.map((entry) => /** @type {[string, number]} */ ([entry.slice(0, 3), Number(entry.slice(4))])),
  );
}

describe("a preset", () => {
  const visitor = oneVisitor(() => readyVisitor(site.visit()));

  it("of the first model is described by what it changes, and its effect is measured", async () => {
    const { page } = visitor;
    assert.equal(await page.getByTestId("preset").inputValue(), "as-learned");
    assert.match(await page.getByTestId("lead").innerText(), /do the parts keep step\?/);
    /** @type {Record<string, Awaited<ReturnType<typeof measured>>>} */
    const effects = {};
    const leads = new Set();
    for (const { id, name } of presets) {
      await choosePreset(page, id);
      // The page shows the couplings at once, without waiting for the motion.
      if (id === "arms-go") assert.equal(await page.getByTestId("weight-0-1").textContent(), "≈ 0");
      effects[id] = await measured(page);
      leads.add(await page.getByTestId("lead").innerText());
      if (id !== "as-learned") assert.equal(await page.getByTestId("stage-title").innerText(), name);
    }
    assert.equal(leads.size, presets.length, "each preset has words of its own");
    assert.match(effects["arms-go"]?.parts[1] ?? "", /arms 0\.\d+ × as far, 1\.\d+ s instead of 1\.\d+ s/);
    assert.match(effects["arms-go"]?.step ?? "", /^hands and feet out of step/);
    assert.match(effects["arms-hang"]?.parts[1] ?? "", /arms one pose from \d/);
    // It goes on at 1.2 m/s.
    assert.match(effects["legs-lost"]?.trouble ?? "", /^keeps one pose from \d/);
    assert.match(await page.getByTestId("health").innerText(), /keeps one pose from \d/);
    await page.getByTestId("reset-couplings").click();
    assert.match((await measured(page)).step, /in step/);
    assert.equal(await page.getByTestId("preset").inputValue(), "as-learned");
  });

  it("is no longer selected after one of its couplings changes", async () => {
    const { page } = visitor;
    await choosePreset(page, "arms-go");
    await page.getByTestId("coupling-0-1").press("ArrowLeft");
    assert.equal(await page.getByTestId("preset").inputValue(), "");
    assert.match(await page.getByTestId("lead").innerText(), /of your own/);
  });
});

describe("an arrow between two loops", () => {
  const visitor = oneVisitor(() => readyVisitor(site.visit({ hasTouch: true })));
  const weight = async (/** @type {Page} */ page) =>
    Number(
      /weight ([\d.]+)/.exec(
        (await page.getByTestId("coupling-0-1").getAttribute("aria-valuetext")) ?? "",
      )?.[1],
    );
  const thickness = (/** @type {Page} */ page) =>
    page
      .getByTestId("arrow-0-1")
      .locator(".line")
      .evaluate((line) => Number(line.getAttribute("stroke-width")));

  it("gets thicker when it is dragged up, and thinner with the keyboard; a double click resets it", async () => {
    const { page } = visitor;
    // The words of the measurement can move the arrows.
    await measured(page);
    const [weightBefore, widthBefore] = [await weight(page), await thickness(page)];
    const arrow = page.getByTestId("arrow-0-1");
    const { x = 0, y = 0, width = 0, height = 0 } = (await arrow.boundingBox()) ?? {};
    assert.ok(width >= 24 && height >= 24, "large enough for a finger");
    const [middleX, middleY] = [x + width / 2, y + height / 2];
    await page.mouse.move(middleX, middleY);
    await page.mouse.down();
    await page.mouse.move(middleX, middleY - 40, { steps: 4 });
    await page.mouse.up();
    await soon(async () =>
      assert.ok((await weight(page)) > weightBefore + 0.2, `${weightBefore} to ${await weight(page)}`),
    );
    assert.ok((await thickness(page)) > widthBefore + 1, `${widthBefore} to ${await thickness(page)}`);
    assert.equal(await page.getByTestId("arrow-0-1").locator(".learned").count(), 1, "as thick as learned");
    await page.keyboard.press("ArrowDown");
    const weaker = await thickness(page);
    await page.keyboard.press("PageDown");
    await soon(async () => assert.ok((await thickness(page)) < weaker));
    await soon(async () => assert.equal((await alphasOf(page)).size, 1, "in the address"));
    await page.getByTestId("coupling-0-1").dblclick();
    await soon(async () => assert.equal(await weight(page), weightBefore));
    await soon(async () => assert.equal((await alphasOf(page)).size, 0, "as learned again"));
  });

  it("follows a finger", async () => {
    const { page } = visitor;
    const before = await weight(page);
    const { x = 0, y = 0 } = (await page.getByTestId("arrow-0-1").boundingBox()) ?? {};
    const cdp = await page.context().newCDPSession(page);
    const touch = (
      /** @type {"touchStart" | "touchMove" | "touchEnd"} */ type,
      /** @type {number[]} */ ...ups
    ) =>
      cdp.send("Input.dispatchTouchEvent", {
        type,
        touchPoints: ups.map((up) => ({ x: x + 18, y: y + 18 - up })),
      });
    await touch("touchStart", 0);
    for (const up of [8, 16, 24, 32]) await touch("touchMove", up);
    await touch("touchEnd");
    await soon(async () =>
      assert.ok((await weight(page)) > before + 0.1, `${before} to ${await weight(page)}`),
    );
    await page.keyboard.press("0");
  });
});

describe("the picture of the Lab", () => {
  const visitor = oneVisitor(() => readyVisitor(site.visit()));
  const pixels = (/** @type {Page} */ page) =>
    page
      .locator("pg-latent-plot canvas")
      .evaluateAll((canvases) =>
        canvases.map((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL()),
      );
  const pose = (/** @type {Page} */ page) =>
    page.locator("pg-stage").evaluate((view) => {
      const { stage, playback } = /** @type {any} */ (view);
      const { positions, nodes } = stage.content.motion;
      const first = 3 * nodes * Math.floor(playback.frame);
      return [...positions.subarray(first, first + 3 * nodes)];
    });

  it("names each plot and each slider, and no part by two names", async () => {
    const { page } = visitor;
    for (const part of ["legs", "arms"]) {
      await page.getByRole("group", { name: `Latent space of ${part}`, exact: true }).waitFor();
      for (const other of ["legs", "arms"])
        await page.getByRole("slider", { name: `alpha from ${part} to ${other}`, exact: true }).waitFor();
    }
    assert.doesNotMatch(await page.locator("pg-lab").innerText(), /\b(lower|upper)\b/);
  });

  it("answers a key on a slider in the figure and in every loop that the coupling reaches", async () => {
    const { page } = visitor;
    await page.getByTestId("scrub").fill("200");
    await measured(page);
    const slider = page.getByTestId("coupling-0-1");
    const [loops, before] = [await pixels(page), await pose(page)];
    await slider.focus();
    await page.keyboard.press("Home");
    await measured(page);
    await soon(async () => assert.notDeepEqual(await pose(page), before, "the figure"));
    await soon(async () => {
      const [arms, legs] = await pixels(page);
      assert.notEqual(arms, loops[0], "the arms’ loop");
      // Little leads from the arms to the legs, but the predictions about both have changed.
      assert.equal(typeof legs, "string");
    });
    await page.keyboard.press("Delete");
    await measured(page);
    assert.deepEqual(await pose(page), before);
  });

  it("shows by a pale slider that a coupling has no effect", async () => {
    const { page } = visitor;
    const [slider, weight] = [page.getByTestId("coupling-0-1"), page.getByTestId("weight-0-1")];
    const before = Number(await weight.innerText());
    await slider.focus();
    for (let i = 0; i < 2; i++) await page.keyboard.press("ArrowRight");
    const after = Number(await weight.innerText());
    assert.ok(after > before + 0.05, `${before} to ${after}`);
    const paleness = () =>
      page
        .locator(".coupling:has([data-testid=coupling-0-1]) .fill")
        .evaluate((fill) => getComputedStyle(fill).opacity);
    const full = Number(await paleness());
    await page.keyboard.press("Home");
    assert.equal(await weight.innerText(), "≈ 0");
    assert.ok(Number(await paleness()) < full / 2);
    assert.match((await slider.getAttribute("aria-valuetext")) ?? "", /weight ≈ 0/);
    await soon(async () => assert.equal((await alphasOf(page)).size, 1, "in the address"));
    await page.keyboard.press("Delete");
    assert.equal(Number(await weight.innerText()), before);
    await soon(async () => assert.equal((await alphasOf(page)).size, 0, "as learned again"));
  });
});

describe("a link to couplings", () => {
  it("restores the couplings, and shows the weights of the motion", async () => {
    const { page, leave } = await site.visit({ settings: "alpha=0.1:0.05,1.0:0.02" });
    await ready(page);
    await measured(page);
    const [header = "", first = ""] = (await saved(page, "save-latents")).text.split("\n");
    const names = header.trim().split(",");
    const values = first.trim().split(",");
    for (const [i, source] of PARTS.entries())
      for (const [j, target] of PARTS.entries()) {
        const made = Number(values[names.indexOf(`weight_${source}_${target}`)]);
        assert.equal(
          await page.getByTestId(`weight-${i}-${j}`).textContent(),
          made.toFixed(2),
          `${source} to ${target}`,
        );
      }
    assert.equal(Number(await page.getByTestId("alpha-0-1").textContent()), 0.05);
    const linked = await saved(page, "save-motion");
    await page.keyboard.press("0");
    assert.notEqual((await saved(page, "save-motion")).text, linked.text);
    await leave();
  });
});

describe("both readings", () => {
  seldom.it("walk side by side on request, follow the couplings, and give the stage back", async () => {
    const { page } = await site.visit({ moving: true });
    await ready(page);
    await choosePreset(page, "arms-go");
    await openPanel(page, "more");
    const button = page.getByTestId("readings-beside");
    await button.click();
    const canvas = page.getByTestId("stage-columns");
    await canvas.waitFor();
    assert.deepEqual(await page.locator(".stage-columns li").allInnerTexts(), [
      "Experts as learned",
      "Experts re-inferred",
    ]);
    assert.ok(!(await page.getByTestId("stage").isVisible()));
    await draws(canvas);
    assert.match(await page.getByTestId("lead").innerText(), /Left, as learned: .*Right, re-inferred: /s);
    await page.getByTestId("coupling-1-1").press("ArrowLeft");
    await measured(page);
    assert.deepEqual(await barriers(page), []);
    await button.click();
    await canvas.waitFor({ state: "detached" });
    assert.ok(await page.getByTestId("stage").isVisible());
  });
});
