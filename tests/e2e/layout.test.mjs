// Layout: no element is cut off, covers another or scrolls into empty space, in windows of all sizes.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { Clip, Trainer, TrainingSet } from "../../crate/wasm/pkg/node/vcgpdm.js";
import {
  barriers,
  barriersBy,
  choosePreset,
  isMeasured,
  often,
  oneVisitor,
  openPanel,
  openedSite,
  ready,
  readyVisitor,
  resize,
  seldom,
} from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const PANELS = /** @type {const} */ (["none", "learn", "more", "numbers"]);

const site = openedSite();

const size = (/** @type {Page} */ page) =>
  page.evaluate(() => {
    const { scrollWidth, scrollHeight, clientWidth, clientHeight } = document.documentElement;
    return { scrollWidth, scrollHeight, clientWidth, clientHeight };
  });

/** Pairs of elements whose texts cover each other. */
const overprints = (/** @type {Page} */ page, /** @type {string} */ selector) =>
  page.evaluate((selector) => {
    const seen = [...document.querySelectorAll(selector)]
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
  }, selector);

/** A model with `count` parts. Its motion does not matter. */
function modelOf(/** @type {number} */ count) {
  const names = ["hips", "left leg", "right leg", "trunk", "arms"];
  const joints = Clip.sample("walk-1").info().joints.length;
  const first = [0, 1, 5, 9, 15].slice(0, count);
  const parts = first.map((from, i) => ({
    name: names[i] ?? "",
    joints: Array.from({ length: (first[i + 1] ?? joints) - from }, (_, k) => from + k),
  }));
  const clips = new TrainingSet();
  clips.add(Clip.sample("walk-1").cut(0, 90));
  const sizes = { latent: 2, dynamicsIps: 4, poseIps: 4, order: 2 };
  const trainer = new Trainer(clips, { ...sizes, framesPerSecond: 15, seed: 1, maxIterations: 2, parts });
  while (!trainer.step().done);
  return trainer.model().toJson();
}

const open = async (/** @type {Page} */ page, /** @type {string} */ text) => {
  const title = await page.getByTestId("stage-title").elementHandle();
  assert.ok(title);
  await page
    .getByTestId("open-model")
    .setInputFiles({ name: "parts.model.json", mimeType: "application/json", buffer: Buffer.from(text) });
};

const box = async (/** @type {import("playwright-core").Locator} */ element) =>
  (await element.boundingBox()) ?? assert.fail("not visible");

/** Elements that are not wholly within the window and the panels around them. */
const cut = (/** @type {Page} */ page, /** @type {string} */ selector) =>
  page.locator(selector).evaluateAll((elements) =>
    elements.flatMap((element) => {
      const { left, top, right, bottom } = element.getBoundingClientRect();
      // Three loops and more scroll in their column.
      const around = (element.closest(".loops") ?? document.documentElement).getBoundingClientRect();
      const [high, low] = [Math.max(0, around.top), Math.min(innerHeight, around.bottom)];
      const isWhole = right > left && top >= high - 1 && bottom <= low + 1 && right <= innerWidth + 1;
      return isWhole ? [] : [`${element.className}: ${top}-${bottom} of ${high}-${low}`];
    }),
  );

describe("the Lab", () => {
  const visitor = oneVisitor(() => readyVisitor(site.visit({ viewport: { width: 1280, height: 720 } })));

  it("never scrolls, whatever panel is open and however many parts the model has", async () => {
    const { page } = visitor;
    for (const count of often() ? [1, 2, 5] : [1, 2, 3, 4, 5]) {
      await open(page, modelOf(count));
      await page.waitForFunction(
        (count) => document.querySelectorAll("pg-stage .stage-legend li").length === count,
        count,
      );
      for (const panel of PANELS) {
        await openPanel(page, panel);
        const where = `${count} parts, ${panel}`;
        const { scrollWidth, scrollHeight } = await size(page);
        assert.ok(scrollWidth <= 1280 && scrollHeight <= 720, `${where}: the page scrolls`);
        const [figure, loop] = await Promise.all([
          box(page.getByTestId("stage")),
          box(page.locator(".plot").first()),
        ]);
        assert.ok(figure.width >= 300 && figure.height >= 0.6 * 720, `${where}: ${figure.width} wide`);
        assert.ok(
          loop.width >= 200 && loop.height >= 110,
          `${where}: a plot of ${loop.width}x${loop.height}`,
        );
      }
      await openPanel(page, "none");
      assert.equal(await page.locator("pg-latent-plot").count(), count);
      // With more parts the sliders of one part are visible at a time.
      assert.equal(await page.locator("pg-coupling").count(), count === 2 ? 4 : count);
      if (count < 3) assert.deepEqual(await cut(page, ".plot, pg-coupling"), [], `${count} parts`);
    }
  });

  it("says for a model of one part that nothing is coupled, and offers no reading", async () => {
    const { page } = visitor;
    await open(page, modelOf(1));
    await page.getByTestId("lead").getByText("This model has one part").waitFor();
    assert.equal(await page.getByTestId("reading").count(), 0);
  });
});

/** The words that are visible. */
const wordsOn = (/** @type {Page} */ page) =>
  page.evaluate(() => {
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const texts = [];
    while (walker.nextNode()) {
      const { parentElement: parent, textContent } = walker.currentNode;
      const range = document.createRange();
      range.selectNode(walker.currentNode);
      const { width, bottom } = range.getBoundingClientRect();
      if (parent?.checkVisibility({ visibilityProperty: true }) && width > 2 && bottom <= innerHeight)
        texts.push(textContent ?? "");
    }
    return texts
      .join(" ")
      .split(/\s+/)
      .filter((word) => /\p{L}/u.test(word));
  });

/** The visible controls. Inducing points are not counted: they are what a plot shows. */
const controlsOn = (/** @type {Page} */ page) =>
  page.locator("button:not(.mark), a, input, select, summary, [role=slider]").evaluateAll((controls) =>
    controls
      .filter((control) => {
        const { width, bottom } = control.getBoundingClientRect();
        return control.checkVisibility() && width > 2 && bottom <= innerHeight && !control.matches(".skip");
      })
      .map((control) => control.getAttribute("aria-label") ?? control.textContent?.trim() ?? ""),
  );

describe("the picture of the Lab", () => {
  const visitor = oneVisitor(() => readyVisitor(site.visit({ moving: true })));

  for (const [width, height] of /** @type {[number, number][]} */ ([
    [1440, 900],
    [1280, 720],
  ]))
    it(`shows figure, loops and all sliders at ${width}x${height}, with 110 words and 28 controls at most`, async () => {
      const { page } = visitor;
      await resize(page, { width, height });
      for (const preset of ["untrained-advice", "as-learned"]) {
        await choosePreset(page, preset);
        await isMeasured(page);
        assert.deepEqual(await cut(page, ".plot, pg-coupling, .measured, [data-testid=train]"), [], preset);
      }
      const words = await wordsOn(page);
      assert.ok(words.length <= 110, `${words.length} words: ${words.join(" ")}`);
      const controls = await controlsOn(page);
      assert.ok(controls.length <= 28, `${controls.length} controls: ${controls.join(", ")}`);
    });
});

describe("the first screen of the Lab", () => {
  const visitor = oneVisitor(() => readyVisitor(site.visit({ viewport: { width: 1280, height: 720 } })));

  it("uses four sizes of type", async () => {
    const { page } = visitor;
    const sizes = await page.evaluate(() => [
      ...new Set(
        [...document.querySelectorAll("pg-page *:not(option, svg *)")]
          .filter((element) => element.checkVisibility() && element.textContent?.trim())
          .map((element) => Math.round(10 * Number.parseFloat(getComputedStyle(element).fontSize)) / 10),
      ),
    ]);
    assert.deepEqual(
      sizes.filter((size) => ![34, 20, 15, 14].includes(size)),
      [],
    );
  });

  it("shows next to the figure that it stands still, and the stage does not move", async () => {
    const { page } = visitor;
    const before = await box(page.getByTestId("stage"));
    await choosePreset(page, "legs-lost");
    const card = await box(page.getByTestId("health"));
    const stage = await box(page.getByTestId("stage"));
    assert.deepEqual(stage, before);
    // The figure is in the middle and has at most a fifth of the width.
    assert.ok(card.x + card.width <= stage.x + 0.4 * stage.width, `${card.width} of ${stage.width}`);
    await choosePreset(page, "as-learned");
    await page.getByTestId("health").waitFor({ state: "detached" });
  });

  it("disables saving where the stage is not visible", async () => {
    const { page } = visitor;
    await page.getByTestId("view-primitives").click();
    await page.locator("[data-testid=save]:disabled").waitFor();
    await page.getByTestId("view-play").click();
    await page.locator("[data-testid=save]:enabled").waitFor();
  });

  it("lets the keyboard skip to the couplings", async () => {
    const { page } = visitor;
    await page.reload();
    await ready(page);
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement?.textContent), "Skip to the couplings");
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => document.activeElement?.matches("pg-coupling input"));
  });
});

describe("the projector mode", () => {
  seldom.it("hides all but stage, panel and caption; Escape brings the rest back", async () => {
    const { page, problems, leave } = await readyVisitor(
      site.visit({ viewport: { width: 1280, height: 720 } }),
    );
    const [before, label] = [await box(page.getByTestId("stage")), await page.locator("h1").boundingBox()];
    assert.ok(label);
    await page.keyboard.press("p");
    await page.waitForURL(/large=1/);
    await page.reload();
    await ready(page);
    for (const hidden of ["pg-header", "footer", ".picture-foot"])
      assert.ok(await page.locator(hidden).isHidden(), hidden);
    const title = await box(page.getByTestId("stage-title"));
    assert.ok(title.height < 1.7 * 18, `a title of one line, not ${title.height} pixels`);
    assert.deepEqual(await cut(page, ".plot, pg-coupling"), []);
    assert.ok((await box(page.getByTestId("stage"))).height > before.height);
    const { scrollWidth, scrollHeight } = await size(page);
    assert.ok(scrollWidth <= 1280 && scrollHeight <= 720, `${scrollWidth}x${scrollHeight}`);
    assert.deepEqual(await barriers(page), []);
    await page.keyboard.press("Escape");
    await page.locator("pg-header").waitFor();
    await page.keyboard.press("p");
    await page.locator("pg-header").waitFor({ state: "hidden" });
    await page.getByTestId("leave-large").click();
    await page.locator("pg-header").waitFor();
    assert.deepEqual(problems, []);
    await leave();
  });
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
      const play = await box(page.getByTestId("play"));
      assert.ok(play.y + play.height <= height, `play at ${play.y}`);
      assert.deepEqual(await overprints(page, ".timeline > *"), []);
      const { scrollWidth } = await size(page);
      assert.ok(scrollWidth <= width, `${scrollWidth} pixels wide`);
      const title = await box(page.getByTestId("stage-title"));
      const stage = await box(page.getByTestId("stage"));
      // The head of the figure is a quarter of the picture below its top.
      assert.ok(title.y + title.height < stage.y + 0.25 * stage.height, "the title is above the head");
    });
  }

  seldom.it("lets a class solve the exercise with a training, at the size of a frame", async () => {
    const settings = "exercise=6&dynamics=6&poses=6&iterations=20&fps=10&trainings=1";
    const viewport = { width: 800, height: 500 };
    const { page } = await site.visit({ query: "?embed", settings, viewport });
    await ready(page);
    assert.deepEqual(await page.locator(".panel-buttons button").allInnerTexts(), ["Learn", "More"]);
    await page.getByTestId("train").click();
    await page
      .getByTestId("exercise")
      .getByText("This model has 6 points for a part.")
      .waitFor({ timeout: 60_000 });
    await openPanel(page, "more");
    await page.getByTestId("completing").waitFor();
    assert.deepEqual(await barriers(page), []);
    const { scrollWidth } = await size(page);
    assert.ok(scrollWidth <= 800, `${scrollWidth} pixels wide`);
    await page.evaluate(() => Object.assign(location, { hash: "tab=numbers" }));
    await page.locator("#open-numbers[aria-expanded=true]").waitFor();
    await page.locator("pg-numbers table").first().waitFor();
  });

  it("shows any view, without header and footer", async () => {
    const { page } = await site.visit({ query: "?embed", settings: "view=primitives" });
    await page.locator("pg-gallery").waitFor();
    assert.equal(await page.locator("pg-header, footer").count(), 0);
    assert.ok(await page.getByTestId("stage").isHidden());
    await page.evaluate(() => Object.assign(location, { hash: "view=method" }));
    await page.locator("pg-method math").first().waitFor();
  });
});

describe("five parts by hand, trained several times", () => {
  seldom.it("fit their panels, and the document fits the window", async () => {
    const split = "hips:0;left leg:1-4;right leg:5-8;trunk:9-14;arms:15-99";
    const settings = `tab=learn&parts=hand&split=${split}&iterations=10&fps=10&latent=1&dynamics=2&poses=2&trainings=3`;
    const { page } = await site.visit({ viewport: { width: 1440, height: 900 }, settings });
    await ready(page);
    await page.getByTestId("train").click();
    await page.getByTestId("train").waitFor({ timeout: 120_000 });
    const { scrollHeight, scrollWidth } = await size(page);
    assert.ok(scrollHeight <= 900 && scrollWidth <= 1440, `${scrollWidth}x${scrollHeight}`);
    for (const name of ["clear-runs", "bound"]) {
      const { x, width } = await box(page.getByTestId(name));
      assert.ok(x + width <= 1440, name);
    }
    assert.deepEqual(await overprints(page, ".coupling-names, .numbers > span"), []);
    await page.getByTestId("part-3").click();
    await page.getByTestId("coupling-0-3").waitFor();
    await page.setViewportSize({ width: 390, height: 844 });
    assert.ok((await size(page)).scrollWidth <= 390, "on a phone");
  });
});

describe("targets", () => {
  seldom.it("are at least 24 pixels large, or have that much space", async () => {
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
      const small = await barriersBy(page, { runOnly: ["target-size", "scrollable-region-focusable"] });
      assert.deepEqual(small, [], view);
    }
    await leave();
  });
});
