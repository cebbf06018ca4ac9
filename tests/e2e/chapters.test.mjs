// Chapters 3 to 8 of the story, and the extra one: by keyboard, in both languages, without barriers.
import assert from "node:assert/strict";
import { after, before, describe, it } from "node:test";
import { barriers, barriersNow, oneVisitor, openSite } from "./site.mjs";

/** @type {Awaited<ReturnType<typeof openSite>>} */
let site;
before(async () => {
  site = await openSite();
});
after(() => site?.close());

const LAPTOP = { viewport: { width: 1280, height: 720 } };
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/** A choice of each chapter, the sentence that is measured after it, and a handle that arrow keys move. */
const CHAPTERS = /** @type {const} */ ([
  { number: 3, choice: "dissolve", measured: "certainty", handle: "dot", key: "ArrowUp" },
  { number: 4, choice: "pin", measured: "score", handle: "pin", key: "ArrowLeft" },
  { number: 5, choice: "half", measured: "enough", handle: "poses-0", key: "Enter" },
  { number: 6, choice: "same", measured: "doubled", handle: "alpha-0", key: "ArrowRight" },
  { number: 10, choice: "prior", measured: "far", handle: "point-0", key: "ArrowUp" },
]);

/** Whether the answer and the control are above the foot of the page, or the page can be scrolled to them. */
const isCovered = (/** @type {import("playwright-core").Page} */ page) =>
  page.evaluate(() => {
    const foot = document.querySelector(".story-foot")?.getBoundingClientRect();
    const side = document.querySelector(".story-side")?.lastElementChild?.getBoundingClientRect();
    return innerWidth > 760 && foot && side ? side.bottom > foot.top + 1 : false;
  });

for (const [locale, size, problemsOf] of /** @type {const} */ ([
  ["en-GB", LAPTOP, barriers],
  ["de-DE", LAPTOP, barriersNow],
  ["de-DE", PHONE, barriersNow],
]))
  describe(`in ${locale} at ${size.viewport.width} x ${size.viewport.height}`, () => {
    const visitor = oneVisitor(() => site.visit({ story: true, locale, moving: true, ...size }));
    for (const { number, choice, measured, handle, key } of CHAPTERS)
      it(`chapter ${number} takes a guess, measures the answer, and obeys the keys`, async () => {
        const { page } = visitor;
        await page.evaluate((hash) => Object.assign(location, { hash }), `story=${number}`);
        await page.getByTestId(`choice-${choice}`).focus();
        await page.keyboard.press("Enter");
        const sentence = page.getByTestId(measured);
        await sentence.waitFor({ timeout: 60_000 });
        assert.doesNotMatch(await sentence.innerText(), /NaN|undefined|null/);
        assert.equal(await isCovered(page), false, "the foot covers the control");
        assert.deepEqual(await problemsOf(page), []);
        const before = await page.locator(".story-stage, .story-side").allInnerTexts();
        const place = page.getByTestId(`handle-${handle}`);
        const style = await place.getAttribute("style");
        await place.focus();
        await page.keyboard.press(key);
        await page.waitForFunction(
          ([id, style, before]) => {
            const button = document.querySelector(`[data-testid="handle-${id}"]`);
            const now = [...document.querySelectorAll(".story-stage, .story-side")].map(
              (element) => /** @type {HTMLElement} */ (element).innerText,
            );
            return button?.getAttribute("style") !== style || now.join() !== before;
          },
          /** @type {const} */ ([handle, style, before.join()]),
        );
      });

    // In German, the answers of both chapters pushed their controls under the foot.
    for (const [number, choice, measured] of /** @type {const} */ ([
      [7, "fall", "homecoming"],
      [8, "own", "borrowed"],
    ]))
      it(`chapter ${number} leaves its answer and control above the foot`, async () => {
        const { page } = visitor;
        await page.evaluate((hash) => Object.assign(location, { hash }), `story=${number}`);
        await page.getByTestId(`choice-${choice}`).click();
        await page.getByTestId(measured).waitFor({ timeout: 60_000 });
        assert.equal(await isCovered(page), false, "the foot covers the control");
      });
  });

// Chapter 8 had the rules of its canvas from a file that only other chapters loaded: opened by its address, it
// drew a figure of 300 x 150 pixels in the corner.
it("draws each chapter over the width of its stage, opened by its address", async () => {
  const { page, problems, leave } = await site.visit({ settings: "story=1" });
  for (let number = 1; number <= 10; number++) {
    await page.evaluate((hash) => Object.assign(location, { hash }), `story=${number}`);
    await page.reload();
    await page.locator(".story[data-state=open]").waitFor();
    await page.waitForFunction(() => {
      const stage = document.querySelector(".story-stage")?.getBoundingClientRect();
      const pictures = [...document.querySelectorAll(".story-stage :is(canvas, svg)")];
      const boxes = pictures.map((picture) => picture.getBoundingClientRect());
      const width = Math.max(...boxes.map(({ right }) => right)) - Math.min(...boxes.map(({ left }) => left));
      return stage && width >= 0.5 * stage.width;
    });
  }
  assert.deepEqual(problems, []);
  await leave();
});
