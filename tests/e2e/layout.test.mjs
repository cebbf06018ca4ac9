// Layout: no element is cut off, covers another or scrolls into empty space, in windows of all sizes.
import assert from "node:assert/strict";
import { after, before, describe, it } from "node:test";
import { barriers, oneVisitor, openSite, ready } from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof openSite>>} */
let site;
before(async () => {
  site = await openSite();
});
after(() => site?.close());

const size = (/** @type {Page} */ page) =>
  page.evaluate(() => {
    const { scrollWidth, scrollHeight, clientWidth, clientHeight } = document.documentElement;
    return { scrollWidth, scrollHeight, clientWidth, clientHeight };
  });

/** Pairs of texts in the table of couplings that cover each other. */
const overprints = (/** @type {Page} */ page) =>
  page.evaluate(() => {
    const seen = [...document.querySelectorAll(".couplings th, .couplings .numbers > span")]
      .map((element) => {
        const range = document.createRange();
        range.selectNodeContents(element);
        return { text: element.textContent?.trim() ?? "", box: range.getBoundingClientRect() };
      })
      .filter(({ box }) => box.width > 0);
    return seen.flatMap((a, i) =>
      seen
        .slice(i + 1)
        .filter(
          (b) =>
            Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left) > 1 &&
            Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top) > 2,
        )
        .map((b) => `${a.text} / ${b.text}`),
    );
  });

describe("embedded", () => {
  const visitor = oneVisitor(() => site.visit({ query: "?embed" }));
  for (const [width, height] of /** @type {[number, number][]} */ ([
    [900, 600],
    [390, 500],
  ])) {
    it(`shows its clock at ${width}x${height}, and no text covers another`, async () => {
      const { page } = visitor;
      await page.setViewportSize({ width, height });
      await page.waitForSelector("html[data-engine=ready]");
      const play = await page.getByTestId("play").boundingBox();
      assert.ok(play && play.y + play.height <= height, `play at ${play?.y}`);
      assert.deepEqual(await overprints(page), []);
      const { scrollWidth } = await size(page);
      assert.ok(scrollWidth <= width, `${scrollWidth} pixels wide`);
      const title = await page.getByTestId("stage-title").boundingBox();
      const stage = await page.getByTestId("stage").boundingBox();
      // The head of the figure is a quarter of the picture below its top.
      assert.ok(
        title && stage && title.y + title.height < stage.y + 0.25 * stage.height,
        "the title is above the head of the figure",
      );
    });
  }
});

describe("a window of 1440x900", () => {
  const visitor = oneVisitor(() => site.visit({ viewport: { width: 1440, height: 900 } }));

  it("shows all couplings of the first model, with the measures", async () => {
    const { page } = visitor;
    await ready(page);
    for (const preset of ["as-learned", "untrained-advice"]) {
      await page.getByTestId(`preset-${preset}`).click();
      await page.locator("[data-testid=measured][data-current=yes]").waitFor();
      const [needed = Infinity, space = 0] = await page
        .locator("#panel-couplings")
        .evaluate((panel) => [panel.scrollHeight, panel.clientHeight]);
      assert.ok(needed <= space, `${preset}: ${needed} of ${space} pixels`);
    }
  });

  it("shows next to the figure that it stands still, and the stage does not move", async () => {
    const { page } = visitor;
    const before = await page.getByTestId("stage").boundingBox();
    await page.getByTestId("preset-legs-lost").click();
    const card = await page.getByTestId("health").boundingBox();
    const stage = await page.getByTestId("stage").boundingBox();
    assert.deepEqual(stage, before);
    // The figure is in the middle and has at most a fifth of the width.
    assert.ok(
      card && stage && card.x + card.width <= stage.x + 0.4 * stage.width,
      `${card?.width} of ${stage?.width}`,
    );
    await page.getByTestId("preset-as-learned").click();
    await page.getByTestId("health").waitFor({ state: "detached" });
  });

  it("disables saving where the stage is not visible", async () => {
    const { page } = visitor;
    await page.getByTestId("view-primitives").click();
    await page.locator("[data-testid=save]:disabled").waitFor();
    await page.getByTestId("view-play").click();
    await page.locator("[data-testid=save]:enabled").waitFor();
  });

  it("keeps the labels of the table in large type, after a reload too", async () => {
    const { page } = visitor;
    const before = await page.getByTestId("stage").boundingBox();
    await page.keyboard.press("p");
    await page.waitForURL(/large=1/);
    await page.reload();
    await ready(page);
    assert.ok(await page.locator("html").evaluate((root) => root.hasAttribute("data-large")));
    assert.ok(await page.locator(".couplings thead small").first().isVisible());
    assert.deepEqual(await overprints(page), []);
    // The figure keeps its height, and all couplings are visible.
    const stage = await page.getByTestId("stage").boundingBox();
    assert.ok(
      before && stage && stage.height > 0.85 * before.height,
      `${stage?.height}, ${before?.height} before`,
    );
    const [needed = Infinity, space = 0] = await page
      .locator("#panel-couplings")
      .evaluate((panel) => [panel.scrollHeight, panel.clientHeight]);
    assert.ok(needed <= space, `${needed} of ${space} pixels`);
  });
});

describe("five parts by hand, trained several times", () => {
  it("fit their panels, and the document fits the window", async () => {
    const split = "hips:0;left leg:1-4;right leg:5-8;trunk:9-14;arms:15-99";
    const settings = `parts=hand&split=${split}&iterations=10&fps=10&latent=1&dynamics=2&poses=2&trainings=3`;
    const { page, problems, leave } = await site.visit({ viewport: { width: 1440, height: 900 }, settings });
    await ready(page);
    await page.getByTestId("train").click();
    await page.getByTestId("train").waitFor({ timeout: 120_000 });
    const { scrollHeight, scrollWidth } = await size(page);
    assert.ok(scrollHeight <= 900 && scrollWidth <= 1440, `${scrollWidth}x${scrollHeight}`);
    const [wide = Infinity, space = 0] = await page
      .locator("#panel-couplings .table-box")
      .evaluate((box) => [box.scrollWidth, box.clientWidth]);
    assert.ok(wide <= space, `the table needs ${wide} of ${space} pixels`);
    assert.equal(await page.locator(".couplings thead th").count(), 5);
    assert.ok(await page.locator(".couplings thead small").first().isVisible(), "predicts");
    const cut = await page.evaluate(() => {
      const side = document.querySelector(".side");
      const right = (side?.getBoundingClientRect().left ?? 0) + (side?.clientWidth ?? 0);
      return ["[data-testid=clear-runs]", "[data-testid=bound]"].filter(
        (name) => (document.querySelector(name)?.getBoundingClientRect().right ?? Infinity) > right,
      );
    });
    assert.deepEqual(cut, []);
    assert.deepEqual(await overprints(page), []);
    // On a phone only the table scrolls, in its box.
    await page.setViewportSize({ width: 390, height: 844 });
    assert.ok((await size(page)).scrollWidth <= 390, "the table widens the page");
    assert.deepEqual(problems, []);
    await leave();
  });
});

describe("targets", () => {
  it("are at least 24 pixels large, or have that much space", async () => {
    const { page, leave } = await site.visit();
    await ready(page);
    for (const [view, element] of /** @type {[string, string][]} */ ([
      ["play", "pg-stage"],
      ["compare", "[data-testid=compare]"],
      ["synthetic", "pg-synthetic .panel-head"],
      ["method", "pg-method math"],
    ])) {
      await page.evaluate((hash) => Object.assign(location, { hash }), view === "play" ? "" : `view=${view}`);
      await page.locator(element).first().waitFor();
      const small = await barriers(page, ["target-size", "scrollable-region-focusable"]);
      assert.deepEqual(small, [], view);
    }
    await leave();
  });
});
