// Chapters 3 to 8 of the story, and the extra one: by keyboard, in both languages, without barriers.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { barriers, barriersNow, oneVisitor, often, openedSite, resize, seldom } from "./site.mjs";
import { SyntheticExperiment, Library } from "../../crate/wasm/pkg/node/vcgpdm.js";
import { readFileSync } from "node:fs";
import { at } from "../../scripts/run.mjs";

const site = openedSite();

const LAPTOP = { viewport: { width: 1280, height: 720 } };
const PHONE = { width: 390, height: 844 };

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

describe("a chapter", () => {
  const visitor = oneVisitor(() => site.visit({ story: true, locale: "en-GB", moving: true, ...LAPTOP }));

  /** Shows the state that the visitor has reached in German, then on a phone, and goes back. */
  async function isReadableInGerman(/** @type {string} */ measured) {
    const { page } = visitor;
    await page.getByTestId("language").click();
    await page.locator("html[lang=de]").waitFor();
    for (const viewport of [LAPTOP.viewport, PHONE]) {
      await resize(page, viewport);
      assert.doesNotMatch(await page.getByTestId(measured).innerText(), /NaN|undefined|null/);
      assert.equal(await isCovered(page), false, "the foot covers the control");
      assert.deepEqual(await barriersNow(page), [], `in German, ${viewport.width} pixels`);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), viewport.width);
    }
    await resize(page, LAPTOP.viewport);
    await page.getByTestId("language").click();
    await page.locator("html[lang=en]").waitFor();
  }

  for (const { number, choice, measured, handle, key } of CHAPTERS)
    it(`${number} takes a guess, measures the answer, and obeys the keys`, async () => {
      const { page } = visitor;
      await page.evaluate((hash) => Object.assign(location, { hash }), `story=${number}`);
      await page.getByTestId(`choice-${choice}`).focus();
      await page.keyboard.press("Enter");
      const sentence = page.getByTestId(measured);
      await sentence.waitFor({ timeout: 60_000 });
      assert.doesNotMatch(await sentence.innerText(), /NaN|undefined|null/);
      assert.equal(await isCovered(page), false, "the foot covers the control");
      assert.deepEqual(await barriers(page), []);
      if (!often()) await isReadableInGerman(measured);
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
    seldom.it(`${number} leaves its answer and control above the foot`, async () => {
      const { page } = visitor;
      await page.evaluate((hash) => Object.assign(location, { hash }), `story=${number}`);
      await page.getByTestId(`choice-${choice}`).click();
      await page.getByTestId(measured).waitFor({ timeout: 60_000 });
      assert.equal(await isCovered(page), false, "the foot covers the control");
      await isReadableInGerman(measured);
    });
});

// Chapter 8 had the rules of its canvas from a file that only other chapters loaded: opened by its address, it
// drew a figure of 300 x 150 pixels in the corner.
seldom.it("draws each chapter over the width of its stage, opened by its address", async () => {
  const { page } = await site.visit({ settings: "story=1" });
  for (let number = 2; number <= 10; number++) {
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
});

// The story's riddle with a known truth: vote, train, draw the curtain.

seldom.it("reveals what the library finds, and has each answer once in three rounds", async () => {
  const { page } = await site.visit({ settings: "story=9" });
  await page.locator(".story[data-state=open]").waitFor();
  /** @type {(string | null)[]} */
  const truths = [];
  for (let round = 1; round <= 3; round++) {
    assert.equal(await page.getByTestId("truth-row").getAttribute("data-answer"), "", "behind the curtain");
    await page.getByTestId("choice-ab").click();
    const belief = page.getByTestId("belief");
    await belief.waitFor({ timeout: 120_000 });
    assert.doesNotMatch((await page.getByTestId("open-in-lab").getAttribute("href")) ?? "", /draw/);
    const { experiment, isMirrored } = await page.evaluate(
      () => /** @type {any} */ (document.querySelector("pg-belief")).chapter.round,
    );
    const text = (await belief.innerText()).replaceAll(",", "");
    const [, ab, ba] = text.match(/to B is ([\d.]+) times .* to A ([\d.]+) times/) ?? [];
    if (round === 1) {
      const same = new SyntheticExperiment(experiment.seed, experiment.driving);
      while (!same.step().done);
      const { forth, back } = same.findings().verdict;
      same.free();
      const wanted = isMirrored ? [back, forth] : [forth, back];
      const text = wanted.map((value) => value.toFixed(value < 10 ? 1 : 0));
      assert.deepEqual([ab, ba], text, "the numbers are those of the library");
    }
    await page.getByTestId("curtain").click();
    const truth = await page.getByTestId("truth").getAttribute("data-truth");
    truths.push(truth);
    assert.equal(await page.getByTestId("truth-row").getAttribute("data-answer"), truth);
    assert.match(await page.getByTestId("truth").innerText(), new RegExp(`you [01] of ${round}, the model`));
    if (round === 1) {
      // What couplings are worth on recordings, with the equations.
      await page.locator(".story-more summary").click();
      assert.match(
        await page.getByTestId("worth").innerText(),
        /with couplings, trained as in the papers, has 0\.73 times.*1\.18 times.*: both undecided/s,
      );
      assert.deepEqual(await barriers(page), []);
      await page.locator(".story-more summary").click();
    }
    await page.getByTestId("another-pair").click();
  }
  assert.deepEqual(truths.sort(), ["ab", "ba", "none"]);
});

// The story's borrowed arms: a guess, and numbers that are those of the library.

/** Centimetres between the hands and the hips in the first 120 frames, on average. */
function handHeight(/** @type {number[]} */ uses) {
  const library = Library.fromJson(readFileSync(at("www/first/library.json"), "utf8"));
  const { joints, figure } = library.info();
  const hands = ["LeftHand", "RightHand"].map((name) =>
    figure.nodes.findIndex(({ joint, endSite }) => joints[joint]?.name === name && !endSite),
  );
  const rollout = library.combination(uses).rollout({ frames: 120, sequence: 0 });
  const positions = rollout.positions();
  const heights = hands.flatMap((hand) =>
    Array.from({ length: 120 }, (_, frame) => {
      const start = 3 * frame * figure.nodes.length;
      return (positions[start + 3 * hand + 1] ?? 0) - (positions[start + 1] ?? 0);
    }),
  );
  return (100 * heights.reduce((sum, height) => sum + height, 0)) / heights.length;
}

it("puts the arms of the jumping jack on the legs of the walk after the guess, and measures them", async () => {
  const { page } = await site.visit({ settings: "story=8" });
  await page.locator(".story[data-state=open]").waitFor();
  assert.equal(await page.getByTestId("borrow-0-0").count(), 0, "nothing to choose before the guess");
  await page.getByTestId("choice-own").click();
  const borrowed = page.getByTestId("borrowed");
  await borrowed.waitFor({ timeout: 60_000 });
  await page.getByText("with their own legs").waitFor({ timeout: 60_000 });
  const text = await borrowed.innerText();
  assert.match(text, /^Never recorded\. The arms do their own movement\./);
  const above = [...text.matchAll(/(\d+) cm above the hips/g)].map(([, value]) => Number(value));
  assert.deepEqual(above, [Math.round(handHeight([0, 5])), Math.round(handHeight([1, 5]))]);
  assert.deepEqual(await barriers(page), []);
  await page.getByTestId("borrow-0-1").click();
  await page.getByText("Learned as a whole: jumping jack.").waitFor();
  assert.match(await borrowed.innerText(), /The body stays in its place\.$/);
  await page.getByTestId("borrow-0-2").click();
  await page.getByText("The arms do their own movement.").waitFor();
  await page.getByTestId("borrow-1-6").click();
  await page.getByText("Learned as a whole: run.").waitFor();
  await page.locator("pg-borrow [data-testid=wheel]").press("ArrowRight");
  await page.waitForFunction(
    () => /** @type {any} */ (document.querySelector("pg-borrow")).library.walk.driven === 0,
  );
});
