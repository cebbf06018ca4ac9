// The couplings panel: the effects of presets are measured, sliders and bars move, both readings appear side by
// side.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, describe, it } from "node:test";
import { at } from "../../scripts/run.mjs";
import {
  barriers,
  draws,
  oneVisitor,
  openCouplingsTable,
  openSite,
  ready,
  readyVisitor,
  saved,
  soon,
} from "./site.mjs";

/**
 * @typedef {import("playwright-core").Page} Page
 * @typedef {{ id: string, name: string }} Preset
 */

/** @type {Preset[]} */
const presets = JSON.parse(readFileSync(at("www/first/presets.json"), "utf8"));
const PARTS = ["lower", "upper"];

/** @type {Awaited<ReturnType<typeof openSite>>} */
let site;
before(async () => {
  site = await openSite();
});
after(() => site?.close());

/** The measures on the page, once they belong to the present motion. */
async function measured(/** @type {Page} */ page) {
  const words = page.locator("[data-testid=measured][data-current=yes]");
  await words.waitFor();
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
  await page.waitForTimeout(600);
  const text = new URLSearchParams(new URL(page.url()).hash.slice(1)).get("alpha") ?? "";
  const entries = text.split(",").filter(Boolean);
  return new Map(
    entries.map((entry) => /** @type {[string, number]} */ ([entry.slice(0, 3), Number(entry.slice(4))])),
  );
}

describe("a preset", () => {
  const visitor = oneVisitor(() => readyVisitor(site.visit()));

  it("of the first model is described by what it changes and by its measured effect", async () => {
    const { page } = visitor;
    assert.equal(await page.getByTestId("preset-as-learned").getAttribute("aria-pressed"), "true");
    /** @type {Record<string, string>} */
    const leads = {};
    for (const preset of presets) {
      const button = page.getByTestId(`preset-${preset.id}`);
      await button.click();
      assert.equal(await button.getAttribute("aria-pressed"), "true", preset.name);
      assert.equal(await page.locator(".preset[aria-pressed=true]").count(), 1);
      const { step, trouble } = await measured(page);
      const lead = await page.getByTestId("lead").innerText();
      const meaning = await button.getAttribute("title");
      assert.ok(meaning && lead.includes(meaning), preset.name);
      if (preset.id !== "as-learned")
        assert.ok(lead.toLowerCase().includes((trouble || step).split(";")[0] ?? "?"), `${step}: ${lead}`);
      leads[preset.id] = lead;
    }
    assert.match(leads["arms-go"] ?? "", /Upper swings .* slower .*Hands and feet out of step\./);
    assert.match(leads["arms-hang"] ?? "", /Upper keeps one pose from \d/);
    // It goes on at 1.2 m/s.
    assert.match(leads["legs-lost"] ?? "", /The figure keeps one pose from \d/);
    assert.match(await page.getByTestId("health").innerText(), /keeps one pose from \d/);
  });

  it("can be tried from the head of the page, and its measured effect is the answer", async () => {
    const { page } = visitor;
    await page.getByTestId("preset-as-learned").click();
    assert.match(await page.getByTestId("lead").innerText(), /Let the arms go: do they keep step\?/);
    const weight = page.getByTestId("weight-0-1");
    await page.getByTestId("lead-try").click();
    // The page shows the couplings at once, without waiting for the motion.
    assert.equal(await weight.textContent(), "≈ 0");
    assert.match((await measured(page)).step, /out of step/);
    assert.match(await page.getByTestId("lead").innerText(), /Hands and feet out of step/);
    assert.equal(await page.getByTestId("stage-title").innerText(), "Let the arms go");
    await page.getByTestId("lead-back").click();
    assert.match((await measured(page)).step, /in step/);
    assert.match(await page.getByTestId("lead").innerText(), /never recorded/);
  });

  it("is no longer selected after one of its couplings changes", async () => {
    const { page } = visitor;
    await page.getByTestId("preset-arms-go").click();
    await page.getByTestId("knob-0-1").press("ArrowLeft");
    assert.equal(await page.locator(".preset[aria-pressed=true]").count(), 0);
    assert.match(await page.getByTestId("lead").innerText(), /of your own/);
  });
});

describe("an arrow on the body", () => {
  const visitor = oneVisitor(() => readyVisitor(site.visit({ hasTouch: true })));
  const weight = async (/** @type {Page} */ page) =>
    Number(
      /weight ([\d.]+)/.exec((await page.getByTestId("knob-0-1").getAttribute("aria-valuetext")) ?? "")?.[1],
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
    const knob = page.getByTestId("knob-0-1");
    const { x = 0, y = 0, width = 0, height = 0 } = (await knob.boundingBox()) ?? {};
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
    const described = page.getByTestId("described");
    await soon(async () =>
      assert.match(await described.innerText(), /^lower drives upper: weight 0\.\d+ \(learned/),
    );
    await page.keyboard.press("ArrowDown");
    const weaker = await thickness(page);
    await page.keyboard.press("PageDown");
    await soon(async () => assert.ok((await thickness(page)) < weaker));
    await knob.dblclick();
    await soon(async () => assert.equal(await weight(page), weightBefore));
    await soon(async () => assert.equal((await alphasOf(page)).size, 0, "as learned again"));
  });

  it("follows a finger", async () => {
    const { page } = visitor;
    const before = await weight(page);
    const { x = 0, y = 0 } = (await page.getByTestId("knob-0-1").boundingBox()) ?? {};
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

describe("sliders and dividers", () => {
  const visitor = oneVisitor(async () => {
    const visitor = await readyVisitor(site.visit());
    await openCouplingsTable(visitor.page);
    return visitor;
  });

  it("move by keyboard: a slider moves its share in the bar and shows when it has no effect", async () => {
    const { page } = visitor;
    const [slider, weight] = [page.getByTestId("coupling-0-1"), page.getByTestId("weight-0-1")];
    const divider = page.getByTestId("divider-1-0");
    const before = Number(await weight.innerText());
    await slider.focus();
    for (let i = 0; i < 20; i++) await page.keyboard.press("ArrowRight");
    const after = Number(await weight.innerText());
    assert.ok(after > before + 0.05, `${before} to ${after}`);
    assert.equal(await divider.getAttribute("aria-valuenow"), (100 * after).toFixed(0));
    const paleness = () =>
      page
        .locator("td:has(> .slider [data-testid=coupling-0-1]) .fill")
        .evaluate((fill) => getComputedStyle(fill).opacity);
    const full = Number(await paleness());
    await page.keyboard.press("Home");
    assert.equal(await weight.innerText(), "≈ 0");
    assert.ok(Number(await paleness()) < full / 2);
    assert.match((await slider.getAttribute("aria-valuetext")) ?? "", /weight ≈ 0/);
    await page.keyboard.press("Delete");
    assert.equal(Number(await weight.innerText()), before);
    assert.equal((await alphasOf(page)).size, 0, "as learned again");
  });

  it("move by pointer: a divider moves weight between parts, with the same joint precision", async () => {
    const { page } = visitor;
    const learned = await Promise.all(
      [0, 1].map(async (j) => Number(await page.getByTestId(`alpha-${j}-1`).innerText())),
    );
    const bar = await page.getByTestId("shares-1").boundingBox();
    const handle = await page.getByTestId("divider-1-0").boundingBox();
    assert.ok(bar && handle);
    const y = bar.y + bar.height / 2;
    await page.mouse.move(handle.x + handle.width / 2, y);
    await page.mouse.down();
    await page.mouse.move(bar.x + 0.5 * bar.width, y, { steps: 4 });
    await page.mouse.up();
    const shares = await Promise.all(
      [0, 1].map(async (j) => Number(await page.getByTestId(`weight-${j}-1`).innerText())),
    );
    assert.ok(
      shares.every((share) => Math.abs(share - 0.5) < 0.03),
      shares.join(),
    );
    const alphas = await alphasOf(page);
    assert.deepEqual([...alphas.keys()].sort(), ["0.1", "1.1"]);
    const combined = (/** @type {number[]} */ values) =>
      1 / values.reduce((sum, value) => sum + 1 / value, 0);
    const [before, after] = [combined(learned), combined([...alphas.values()])];
    // The page writes the learned couplings with two digits.
    assert.ok(Math.abs(after / before - 1) < 0.03, `${before} and ${after}`);
    await page.getByTestId("shares-1").dblclick({ position: { x: 3, y: 12 } });
    assert.equal((await alphasOf(page)).size, 0, "a double click resets it");
  });

  it("move by keyboard: a divider, to its ends too, with a text for screen readers", async () => {
    const { page } = visitor;
    const divider = page.getByTestId("divider-1-0");
    const now = async () => Number(await divider.getAttribute("aria-valuenow"));
    const before = await now();
    await divider.focus();
    await page.keyboard.press("ArrowRight");
    assert.equal(await now(), before + 1);
    await page.keyboard.press("PageUp");
    assert.equal(await now(), before + 11);
    await page.keyboard.press("Home");
    assert.match((await divider.getAttribute("aria-valuetext")) ?? "", /^lower ≈ 0, upper 1\.00$/);
    await page.keyboard.press("Delete");
    assert.equal(await now(), before);
    // The measures are pale until they belong to the present motion.
    await measured(page);
    assert.deepEqual(await barriers(page), []);
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
  it("walk side by side on request, follow the couplings, and give the stage back", async () => {
    const { page, problems, leave } = await site.visit({ moving: true });
    await ready(page);
    await page.getByTestId("preset-arms-go").click();
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
    assert.match(await page.locator(".readings").innerText(), /Left: .*Right: /s);
    await page.getByTestId("knob-1-1").press("ArrowLeft");
    await measured(page);
    assert.deepEqual(await barriers(page), []);
    await button.click();
    await canvas.waitFor({ state: "detached" });
    assert.ok(await page.getByTestId("stage").isVisible());
    assert.deepEqual(problems, []);
    await leave();
  });
});
