// Accessibility: keyboard alone, screen readers, dark colours, phones.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import {
  LONG,
  ACCESSIBLE,
  keepsNobodyOut,
  openPanel,
  openedSite,
  ready,
  readyVisitor,
  recolour,
  seldom,
  soon,
} from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("./site.mjs").Visitor} Visitor */

const site = openedSite();

describe("accessibility", () => {
  seldom.it(
    ACCESSIBLE,
    keepsNobodyOut(
      () => readyVisitor(site.visit()),
      async (page, fits) => {
        for (const tab of /** @type {const} */ (["none", "learn", "more", "numbers"])) {
          await openPanel(page, tab);
          if (tab === "numbers") await page.getByTestId("expert-kernels").waitFor();
          await fits(tab);
        }
        await page.getByTestId("help").click();
        await fits("with the help open");
      },
    ),
  );

  it("lets the keyboard alone reach and use the main controls", async () => {
    const { page } = await site.visit({
      moving: true,
      settings: `trainings=1&${LONG}`,
    });
    await ready(page);
    const tabTo = async (/** @type {string} */ id) => {
      for (let i = 0; i < 120; i++) {
        await page.keyboard.press("Tab");
        if (
          await page.evaluate(
            (id) =>
              document.activeElement instanceof HTMLElement && document.activeElement.dataset.testid === id,
            id,
          )
        )
          return;
      }
      assert.fail(`the Tab key does not reach ${id}`);
    };
    await tabTo("play");
    await page.keyboard.press("Enter");
    await page.getByRole("button", { name: "Play", exact: true }).waitFor();

    const arrow = page.getByTestId("coupling-0-1");
    const before = await arrow.getAttribute("aria-valuetext");
    await tabTo("coupling-0-1");
    for (let i = 0; i < 3; i++) await page.keyboard.press("ArrowDown");
    assert.notEqual(await arrow.getAttribute("aria-valuetext"), before);
    await page.keyboard.press("Delete");
    assert.equal(await arrow.getAttribute("aria-valuetext"), before);

    await tabTo("train");
    await page.keyboard.press("Enter");
    await page.getByTestId("cancel").waitFor();
    await tabTo("cancel");
    await page.keyboard.press("Enter");
    await page.getByTestId("train").waitFor();
  });
});

/** The colours of everything in the colour of a part, and the pictures of canvases. */
const partColours = (/** @type {Page} */ page) =>
  page.evaluate(() => {
    const inColour = [...document.querySelectorAll("*")].filter(
      (element) =>
        (element instanceof HTMLElement || element instanceof SVGElement) &&
        element.style.getPropertyValue("--part"),
    );
    return inColour
      .flatMap((element) => [element, ...element.querySelectorAll("*")])
      .map((element) => {
        const { color, backgroundColor, borderTopColor, fill, stroke } = getComputedStyle(element);
        const picture = element instanceof HTMLCanvasElement ? element.toDataURL() : "";
        const name = `${element.localName}.${element.getAttribute("class")}`;
        return [name, color, backgroundColor, borderTopColor, fill, stroke, picture].join(" ");
      });
  });

describe("a system that switches to dark while the page is open", () => {
  // Settings, and the element that appears last.
  const VIEWS = /** @type {const} */ ([
    ["view=play", ".arrow .line"],
    ["view=primitives", "pg-walk .map-bone"],
    ["view=synthetic", ".curves-picture path"],
  ]);
  for (const [settings, last] of VIEWS) {
    seldom.it(`changes all colours: ${settings}`, async () => {
      const visits = /** @type {const} */ (["light", "dark"]).map(async (colorScheme) => {
        const visitor = await site.visit({ settings, colorScheme });
        await visitor.page.locator(last).first().waitFor({ state: "attached" });
        if (settings === "view=play") await ready(visitor.page);
        return visitor;
      });
      const [turned, dark] = /** @type {[Visitor, Visitor]} */ (await Promise.all(visits));
      const opened = await partColours(turned.page);
      assert.ok(opened.length > 10, `${opened.length} elements in the colour of a part`);
      await recolour(turned.page, "dark");
      // On a busy machine, elements and pictures come late on both pages.
      await soon(async () => {
        const colours = await partColours(turned.page);
        assert.deepEqual(colours, await partColours(dark.page), "as on a page opened in the dark");
        assert.notDeepEqual(colours, opened);
      });
      for (const { problems, leave } of [turned, dark]) {
        assert.deepEqual(problems, []);
        await leave();
      }
    });
  }
});

describe("a phone", () => {
  it("shows all panels without scrolling sideways", async () => {
    const { page } = await site.visit({
      viewport: { width: 390, height: 844 },
      hasTouch: true,
      isMobile: true,
    });
    await ready(page);
    for (const panel of /** @type {const} */ (["learn", "more", "numbers", "none"])) {
      await openPanel(page, panel);
      const [wide, high] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
      assert.ok((wide ?? Infinity) <= 390 && high === 390, `${panel}: ${wide} pixels wide`);
    }
    const title = await page.locator("h1").boundingBox();
    const open = await page.locator(".actions").boundingBox();
    assert.ok(title && open && title.x + title.width <= open.x, "the buttons cover the title");
    const size = (/** @type {Element} */ choice) => Number.parseFloat(getComputedStyle(choice).fontSize);
    assert.ok((await page.getByTestId("reading").evaluate(size)) >= 14, "the reading can be read");
    const stage = await page.getByTestId("stage").boundingBox();
    assert.ok(
      stage && stage.y < 300 && stage.width >= 360 && stage.height >= 200,
      `stage ${JSON.stringify(stage)}`,
    );
    const length = page.getByTestId("length");
    assert.equal(await length.inputValue(), "10", "the length of the motion");
    const box = await length.boundingBox();
    assert.ok(box && box.x + box.width <= 390);
  });
});
