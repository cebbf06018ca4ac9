// The Lab in two languages: the words of each tab, and their place on the screen.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { at } from "../../scripts/run.mjs";
import { answersOf } from "./answers.mjs";
import {
  choosePreset,
  drop,
  oneVisitor,
  openPanel,
  openedSite,
  readyVisitor,
  drawn,
  resize,
  saved,
  seldom,
} from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

const PANELS = /** @type {const} */ (["none", "learn", "more", "numbers"]);
const SIZES = /** @type {const} */ ([
  { width: 1280, height: 720 },
  { width: 390, height: 844 },
]);
const GERMAN = { locale: "de-DE", viewport: SIZES[0] };

/** The views with words of their own, and when all of a view is on the page. */
const VIEWS = [
  {
    view: "compare",
    ready: async (/** @type {Page} */ page) => {
      await page.getByTestId("given").waitFor();
      await page.locator("comparison-claims tbody tr").first().waitFor({ state: "attached" });
    },
  },
  {
    view: "primitives",
    ready: async (/** @type {Page} */ page) => {
      await page.getByTestId("combination").first().waitFor();
      await page.getByTestId("recorded").waitFor();
    },
  },
  {
    view: "series",
    ready: (/** @type {Page} */ page) => page.getByTestId("series-example").waitFor(),
  },
  {
    view: "synthetic",
    ready: (/** @type {Page} */ page) => page.locator(".curves-picture path").first().waitFor(),
  },
  {
    view: "perception",
    ready: async (/** @type {Page} */ page) => {
      await page.getByTestId("begin").and(page.locator(":enabled")).waitFor({ timeout: 30_000 });
      await page.evaluate(() => {
        for (const folded of document.querySelectorAll("pg-perception details"))
          folded.toggleAttribute("open", true);
      });
      await drop(page, { "answers.json": answers() });
      await page.getByTestId("analysed").nth(1).waitFor({ timeout: 60_000, state: "attached" });
      await page.locator("perception-inducing figcaption").waitFor({ timeout: 30_000 });
    },
  },
  {
    view: "draw&exercise=9",
    ready: async (/** @type {Page} */ page) => {
      await page.getByTestId("draw-example").click();
      await page.locator("pg-drawing pg-latent-plot").nth(1).waitFor({ timeout: 30_000 });
      await page.getByTestId("sound").waitFor();
    },
  },
  {
    view: "play&tab=more&exercise=7",
    ready: async (/** @type {Page} */ page) => {
      await page.getByTestId("live-on").click();
      await page.getByTestId("feet").click();
      await page.getByTestId("perform").getByRole("button").nth(2).waitFor();
      await page.getByTestId("sound").waitFor();
      await page.getByTestId("exercise").waitFor();
    },
  },
  {
    view: "play&samples=1",
    ready: (/** @type {Page} */ page) => page.getByText("Stichprobe 1").first().waitFor(),
  },
  {
    view: "method",
    ready: (/** @type {Page} */ page) => page.locator("pg-method math").first().waitFor(),
  },
];

/** The answers of two participants of the page's study, as a file. */
function answers() {
  const { Study } = builtPackage();
  const study = Study.fromJson(readFileSync(at("www/dist/study/walks.study.json"), "utf8"));
  return JSON.stringify(answersOf(study, [1, 2]));
}

/** Texts of the library, which are English everywhere, such as titles and settings; the credit of the recordings; a function; clips, which keep their names. */
const OF_LIBRARY = [
  /^Walk/,
  /^\w+ [XYZ]rotation/,
  /mocap\.cs\.cmu\.edu/,
  /^MAP C?GPDM$/,
  /^(v?C?GPDM, )*\d+ \+ \d+ inducing points(, (Q = \d+|uncoupled|[Ss]\w+ \d+))*$/,
  /^(\d+ iterations, )?not balanced/,
  /^primitives by the bound/,
  /^arg max$/,
  /vom Modell von CMU/,
];

/** The texts of two or more words that a visitor of the page sees or hears. */
const textsOf = (/** @type {Page} */ page) =>
  page.evaluate(() => {
    const found = new Set();
    const add = (/** @type {string | null} */ text) => {
      const words = (text ?? "").replace(/\s+/g, " ").trim();
      if (/\p{L}{2,}[’']? \p{L}{2,}/u.test(words)) found.add(words);
    };
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
      const parent = walker.currentNode.parentElement;
      if (
        parent &&
        !parent.closest("script, style, noscript, code, body [lang], [popover]:not(:popover-open)")
      )
        add(walker.currentNode.nodeValue);
    }
    for (const element of document.querySelectorAll("[aria-label], [aria-valuetext], [title]"))
      for (const name of ["aria-label", "aria-valuetext", "title"]) add(element.getAttribute(name));
    return [...found];
  });

/** Fails with each text that is the same in both languages and is none of the library's. */
function areTranslated(
  /** @type {Set<string>} */ german,
  /** @type {Set<string>} */ english,
  /** @type {number} */ atLeast,
) {
  assert.ok(english.size > atLeast && german.size > atLeast, `${english.size} and ${german.size} texts`);
  const same = [...german].filter((text) => english.has(text));
  assert.deepEqual(
    same.filter((text) => !OF_LIBRARY.some((of) => of.test(text))),
    [],
  );
}

/** Texts that leave their button or the window, or that a box cuts off, but not those in boxes that scroll. */
const cutTexts = (/** @type {Page} */ page) =>
  page.evaluate(() => {
    const leaves = (/** @type {Node} */ text) => {
      const range = document.createRange();
      range.selectNodeContents(text);
      const { left, right, width } = range.getBoundingClientRect();
      if (width === 0 || text.parentElement?.closest(".visually-hidden, .skip")) return false;
      // Some texts are for screen readers only.
      for (let box = text.parentElement; box; box = box.parentElement)
        if (getComputedStyle(box).clipPath !== "none") return false;
      for (let box = text.parentElement; box; box = box.parentElement) {
        const { overflowX, textOverflow } = getComputedStyle(box);
        const edge = box.getBoundingClientRect();
        const isOutside = left < edge.left - 1 || right > edge.right + 1;
        if (overflowX === "auto" || overflowX === "scroll" || textOverflow === "ellipsis") return false;
        if (isOutside && (overflowX !== "visible" || box.matches("button, select, td, th, body")))
          return true;
      }
      return false;
    };
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const found = [];
    while (walker.nextNode()) {
      const text = walker.currentNode;
      if (text.nodeValue?.trim() && !text.parentElement?.closest("script, style, option") && leaves(text))
        found.push(text.nodeValue.trim());
    }
    return found;
  });

/** Fails if the page is wider than the screen, or cuts a text off. */
async function fits(/** @type {Page} */ page, /** @type {number} */ width, /** @type {string} */ state) {
  const where = `${state}, ${width} pixels`;
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, where);
  assert.deepEqual(await cutTexts(page), [], where);
}

/** As `fits`, at all sizes. */
async function fitsAll(/** @type {Page} */ page, /** @type {string} */ state) {
  for (const viewport of SIZES) {
    await resize(page, viewport);
    await fits(page, viewport.width, state);
  }
}

/** Opens everything that is folded in the open panel. */
const unfold = (/** @type {Page} */ page) =>
  page.evaluate(() => {
    for (const folded of document.querySelectorAll(".panel details")) folded.toggleAttribute("open", true);
  });

/** What the page says with each panel. */
async function wordsOfTabs(/** @type {Page} */ page, /** @type {(tab: string) => Promise<void>} */ inTab) {
  /** @type {Set<string>} */
  const words = new Set();
  for (const tab of PANELS) {
    await openPanel(page, tab);
    if (tab === "numbers") await page.getByTestId("pose-kernels").waitFor();
    await unfold(page);
    await drawn(page);
    for (const text of await textsOf(page)) words.add(text);
    await inTab(tab);
  }
  // The help, and the explanation of a term.
  await page.getByTestId("help").click();
  await page.locator("pg-help dialog[open]").waitFor();
  for (const text of await textsOf(page)) words.add(text);
  await inTab("help");
  await page.keyboard.press("Escape");
  await page.locator(".panel .term").first().click();
  await page.locator(".term-card").waitFor();
  for (const text of await textsOf(page)) words.add(text);
  await inTab("a term");
  await page.keyboard.press("Escape");
  return words;
}

seldom.describe("the Lab in German", () => {
  const visitor = oneVisitor(() => readyVisitor(site.visit(GERMAN)));

  it("fits, says what it measures, and says nothing that it says in English too", async () => {
    const { page } = visitor;
    let german = new Set();
    for (const viewport of SIZES) {
      await resize(page, viewport);
      await openPanel(page, "none");
      await choosePreset(page, "arms-go");
      await page.getByText("nicht im Gleichschritt").first().waitFor();
      assert.match(await page.getByTestId("clock-period-0").innerText(), /^Beine/);
      assert.match(await page.getByTestId("measured").innerText(), /Arme 0,8\d × so weit/);
      german = await wordsOfTabs(page, async (tab) => {
        await fits(page, viewport.width, tab);
      });
      await openPanel(page, "none");
    }
    await resize(page, SIZES[0]);
    await page.getByTestId("language").click();
    await page.getByRole("button", { name: "Learn", exact: true }).waitFor();
    assert.equal(await page.locator("html").getAttribute("lang"), "en");
    assert.equal(await page.getByTestId("preset").inputValue(), "arms-go", "the couplings are kept");
    areTranslated(german, await wordsOfTabs(page, async () => {}), 100);
  });
});

seldom.describe("each view in German", () => {
  for (const { view, ready: isReady } of VIEWS)
    it(`fits and says nothing English in the view ${view}`, async () => {
      const { page } = await site.visit({ ...GERMAN, settings: `view=${view}` });
      await isReady(page);
      const german = new Set(await textsOf(page));
      await fitsAll(page, view);
      await resize(page, SIZES[0]);
      await page.getByTestId("language").click();
      await page.getByRole("button", { name: "Help and keys" }).waitFor();
      areTranslated(german, new Set(await textsOf(page)), 20);
    });

  it("runs the perception test in German, and stores its answers as in English", async () => {
    const { page } = await site.visit({ ...GERMAN, settings: "view=perception" });
    await page.getByTestId("begin").and(page.locator(":enabled")).click({ timeout: 30_000 });
    const pages = [
      ["consent", "freiwillig", "Ich bin einverstanden"],
      ["instructions", "Pfeiltaste", "Beginnen"],
    ];
    for (const [name = "", text = "", button = ""] of pages) {
      await page.getByTestId(`page-${name}`).getByText(text).waitFor({ timeout: 30_000 });
      await fitsAll(page, name);
      await page.getByTestId("run").getByRole("button", { name: button }).click();
    }
    await page.getByText("Auf welcher Seite").waitFor({ timeout: 30_000 });
    await fitsAll(page, "trial");
    await page.getByRole("button", { name: "Links" }).click();
    await page.getByText("1 von 60").first().waitFor();
    await page.getByRole("button", { name: "Verlassen" }).click();
    const { text } = await saved(page, "save-csv");
    const [head = ""] = text.split("\r\n");
    assert.match(head, /"participant","study","seed".*"natural_side","heading","response"/);
    assert.match(text, /"comparison"|"attention"/);
    assert.match(text, /"left"/);
    assert.doesNotMatch(text, /Links|Seite|Versuchsperson/);
    const study = JSON.parse((await saved(page, "save-study")).text);
    assert.equal(study.texts.question, "On which side did you perceive the more natural movement?");
  });
});
