// The story, the first view of a new visitor: small, quick, in two languages, by keyboard and touch.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { beforeEach, describe, it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { at } from "../../scripts/run.mjs";
import { coupledInfo } from "../node/package.mjs";
import {
  barriers,
  barriersNow,
  changes,
  oneVisitor,
  openedSite,
  ready,
  seldom,
  soon,
  squares,
} from "./site.mjs";

const { Model } = builtPackage();

/** @typedef {import("playwright-core").Page} Page */

/** Holds the wasm back until it is released. */
let wasm = Promise.resolve();
const site = openedSite({ before: (path) => (path.endsWith(".wasm") ? wasm : undefined) });
beforeEach(() => {
  wasm = Promise.resolve();
});

const LAPTOP = { viewport: { width: 1280, height: 720 } };
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
const MOST_WORDS = 80;
const MOST_CONTROLS = 8;

/** Waits until the chapter on screen can be used. */
const open = (/** @type {Page} */ page) => page.locator(".story[data-state=open]").waitFor();

const title = (/** @type {Page} */ page) => page.locator(".story-card h1").innerText();

/** The visible words and controls of the page, and whether it scrolls. */
const firstScreen = (/** @type {Page} */ page) =>
  page.evaluate(() => {
    const controls = [...document.querySelectorAll("a, button, input, select, summary, textarea")];
    const { scrollWidth, scrollHeight } = document.documentElement;
    return {
      words: document.body.innerText.split(/\s+/).filter((word) => /\w/.test(word)).length,
      controls: controls.filter((control) => control.checkVisibility()).length,
      scrolls: scrollWidth > innerWidth || scrollHeight > innerHeight,
    };
  });

/** Elements of the story whose content is wider or higher than their box. */
const overflowing = (/** @type {Page} */ page) =>
  page.evaluate(() => {
    const page = document.documentElement.clientWidth;
    return [...document.querySelectorAll(".story, .story *")]
      .filter((element) => element instanceof HTMLElement && element.checkVisibility())
      .filter((element) => {
        const { left, right } = element.getBoundingClientRect();
        const isHidden = element.closest(".visually-hidden, .story-stage") !== null;
        return (
          !isHidden &&
          ((element.scrollWidth > element.clientWidth + 1 && element.clientWidth > 0) ||
            left < -1 ||
            right > page + 1)
        );
      })
      .map(
        (element) => `${element.localName}.${element.className}: ${element.textContent?.trim().slice(0, 40)}`,
      );
  });

/** The suite of a screen and a language. Each screen and each language is often seen. */
const suite = (/** @type {string} */ screen, /** @type {string} */ locale) =>
  (screen === "laptop") === (locale === "de") ? seldom.describe : describe;

for (const [name, size] of Object.entries({ laptop: LAPTOP, phone: PHONE }))
  for (const locale of ["en", "de"])
    suite(name, locale)(`the story on a ${name}, ${locale}`, () => {
      const visitor = oneVisitor(async () => {
        const visitor = await site.visit({ story: true, locale, ...size });
        await open(visitor.page);
        return visitor;
      });

      it("has a first screen with few words and controls that does not scroll", async (test) => {
        const { page } = visitor;
        const { words, controls, scrolls } = await firstScreen(page);
        test.diagnostic(`${words} words, ${controls} controls`);
        assert.ok(words > 20 && words <= MOST_WORDS, `${words} words`);
        assert.ok(controls > 3 && controls <= MOST_CONTROLS, `${controls} controls`);
        assert.ok(!scrolls, "the page scrolls");
        assert.equal(await page.locator("html").getAttribute("lang"), locale);
      });

      it("fits in all chapters, on a phone with all answers above the foot", async () => {
        const { page } = visitor;
        for (let chapter = 1; chapter <= 10; chapter++) {
          await page.evaluate((hash) => Object.assign(location, { hash }), `story=${chapter}`);
          await page.waitForFunction(
            (chapter) =>
              document.querySelector("#story-chapters [aria-current=step]")?.getAttribute("href") ===
                `#story=${chapter}` &&
              document.querySelector(
                `.story[data-state=open] ${chapter === 1 ? ".pad" : ".story-guess button"}`,
              ),
            chapter,
          );
          assert.deepEqual(await overflowing(page), [], `chapter ${chapter}`);
          if (name !== "phone") continue;
          const hidden = await page.evaluate(() => {
            const foot = document.querySelector(".story-place")?.getBoundingClientRect().top ?? 0;
            const answers = [...document.querySelectorAll(".story-guess button")];
            return answers.filter((answer) => answer.getBoundingClientRect().bottom > foot).length;
          });
          assert.equal(hidden, 0, `chapter ${chapter}`);
        }
      });

      it("has no barriers before and after the first drawing", async () => {
        const { page } = visitor;
        await page.evaluate(() => Object.assign(location, { hash: "story=1" }));
        await page.getByTestId("hand-example").waitFor();
        await open(page);
        const problemsOf = locale === "en" ? barriers : barriersNow;
        assert.deepEqual(await problemsOf(page), []);
        await page.getByTestId("hand-example").click();
        await page.getByTestId("latent-0").waitFor({ timeout: 60_000 });
        assert.deepEqual(await problemsOf(page), [], "after the drawing");
        assert.deepEqual(await overflowing(page), []);
      });
    });

/** Keeps the wasm back until the returned function is called. */
function hold() {
  let release = () => {};
  wasm = new Promise((resolve) => {
    release = resolve;
  });
  return () => release();
}

describe("the first drawing, before the wasm has arrived", () => {
  it("can be made by keyboard alone, goes on, and is there in the Lab", async () => {
    const release = hold();
    const { page } = await site.visit({ story: true, moving: true });
    const pad = page.getByTestId("pad-0");
    await pad.waitFor();
    assert.ok(await changes(pad), "a pen shows how to draw");
    for (let i = 0; i < 8; i++) {
      await page.keyboard.press("Tab");
      if (await pad.evaluate((element) => element === document.activeElement)) break;
    }
    await squares(page);
    await page.getByText("The model learns your drawing").waitFor();
    release();
    await page.getByTestId("hand-two").waitFor({ timeout: 60_000 });
    assert.match(await page.getByTestId("reveal").innerText(), /^The model draws: .+ 16 marked points/s);
    assert.ok(await changes(pad), "the pen moves");
    await page.getByTestId("hand-two").click();
    await page.locator("pg-drawing pg-latent-plot").waitFor();
    assert.equal(await page.locator("pg-drawing pg-latent-plot").count(), 1);
  });
});

describe("the way through the story", () => {
  it("is in the address, and goes by buttons, keys of a clicker, the list, and Back", async () => {
    const { page } = await site.visit({ story: true, ...LAPTOP });
    await open(page);
    const first = await title(page);
    await page.getByTestId("chapter-next").click();
    await page.waitForURL(/#story=2$/);
    await open(page);
    assert.notEqual(await title(page), first);
    assert.equal(await page.evaluate(() => document.activeElement?.localName), "h1");
    assert.ok((await page.title()).startsWith(await title(page)));
    await page.keyboard.press("ArrowLeft");
    await page.waitForURL(/#story=1$/);
    await page.keyboard.press("PageDown");
    await page.waitForURL(/#story=2$/);
    await page.goBack();
    await page.waitForURL(/#story=1$/);
    assert.equal(await title(page), first);
    await page.getByTestId("chapters").click();
    await page.getByTestId("chapter-list").getByRole("link").nth(1).click();
    await page.waitForURL(/#story=2$/);
    assert.ok(await page.getByTestId("chapter-list").isHidden());
    // A visitor without an address is where they were.
    await page.goto(page.url().replace(/#.*/, "?again"));
    await page.waitForURL(/#story=2$/);
  });

  it("loads the program of the next chapter before it is opened", async () => {
    const { page, leave } = await site.visit({ story: true });
    await page.locator(".story[data-state=open][data-engine=ready]").waitFor();
    await page.mouse.move(100, 100);
    // The program of the second chapter, with all files that Vite asks for beside it, has arrived.
    await page.waitForFunction(() => {
      const arrived = performance.getEntriesByType("resource").map(({ name }) => name);
      const links = [...document.querySelectorAll("link[rel=modulepreload], link[rel=stylesheet]")];
      const wanted = links.map((link) => /** @type {HTMLLinkElement} */ (link).href);
      const hasChapter = arrived.some((name) => /story\/arms-chapter-[^/]*\.js$/.test(name));
      return hasChapter && wanted.every((name) => arrived.includes(name));
    });
    await page.route("**/assets/**", (route) => route.abort());
    await page.getByTestId("chapter-next").click();
    await page.getByTestId("choice-pace").waitFor();
    await leave();
  });

  seldom.it("measures the time from chapter to chapter", async (test) => {
    const { page } = await site.visit({ story: true, ...LAPTOP });
    await page.locator(".story[data-state=open][data-engine=ready]").waitFor();
    for (const chapter of [2, 3, 10, 4, 5, 6, 7, 8, 9, 11]) {
      // The program of the next chapter loads when the page is idle.
      await page.waitForTimeout(500);
      await page.keyboard.press("ArrowRight");
      await page.waitForURL(new RegExp(`#story=${chapter}$`));
      await open(page);
    }
    const turns = () =>
      page.evaluate(() =>
        performance
          .getEntriesByName("chapter-turn")
          .map((entry) => ({ name: /** @type {any} */ (entry).detail, milliseconds: entry.duration })),
      );
    await soon(async () => assert.equal((await turns()).length, 11));
    for (const { name, milliseconds } of await turns()) {
      assert.ok(milliseconds > 0);
      test.diagnostic(`${name}: ${milliseconds.toFixed(0)} ms`);
    }
  });

  seldom.it("goes by swipes on a phone", async () => {
    const { page, leave } = await site.visit({ story: true, ...PHONE });
    await open(page);
    const swipe = (/** @type {number} */ from, /** @type {number} */ to) =>
      page.locator(".story-text").evaluate(
        (element, [from, to]) => {
          const touch = (/** @type {number} */ clientX) =>
            new Touch({ identifier: 1, target: element, clientX, clientY: 500 });
          const at = (/** @type {number} */ x) => ({
            bubbles: true,
            touches: [touch(x)],
            changedTouches: [touch(x)],
          });
          element.dispatchEvent(new TouchEvent("touchstart", at(from ?? 0)));
          element.dispatchEvent(new TouchEvent("touchend", at(to ?? 0)));
        },
        [from, to],
      );
    await swipe(300, 120);
    await page.waitForURL(/#story=2$/);
    await swipe(120, 300);
    await page.waitForURL(/#story=1$/);
    await leave();
  });

  it("leads to the Lab, which the browser remembers, and back", async () => {
    const { page } = await site.visit({ story: true });
    await open(page);
    await page.getByTestId("to-lab").click();
    await ready(page);
    assert.match(page.url(), /#view=play$/);
    await page.goto(page.url().replace(/#.*/, "?again"));
    await ready(page);
    assert.equal(await page.locator("pg-story").count(), 0);
    await page.evaluate(() => Object.assign(location, { hash: "story=1" }));
    await open(page);
    assert.ok(await page.locator("pg-page").isHidden());
  });

  seldom.it("shows one chapter alone in a frame of another page", async () => {
    const { page } = await site.visit({ query: "?embed", settings: "story=1" });
    await open(page);
    assert.equal(await page.locator(".story-head, .story-place").count(), 0);
    await page.getByTestId("hand-example").click();
    await page.getByTestId("hand-two").waitFor({ timeout: 60_000 });
  });
});

describe("a chapter that cannot be loaded", () => {
  it("says so, and can be tried again", async () => {
    const { page, leave } = await site.visit({ story: true, without: "**/assets/draw/*" });
    await page.getByTestId("try-again").waitFor();
    await page.unroute("**/assets/draw/*");
    await page.getByTestId("try-again").click();
    await open(page);
    await leave();
  });
});

describe("the numbers on the cards are those of the library", () => {
  seldom.it("periods and swings of legs and arms, tied and cut", async () => {
    // A guess before the model once left the thread tied, and the card spoke of a cut one.
    const release = hold();
    const { page } = await site.visit({ settings: "story=2" });
    const model = Model.fromJson(readFileSync(at("www/public/first/model.json"), "utf8"));
    const { alpha, frameTime } = coupledInfo(model);
    const measured = (/** @type {number} */ factor, /** @type {import("vcgpdm").Reading} */ reading) => {
      const cut = alpha.map((row, source) =>
        row.map((value, target) => (source === 0 && target === 1 ? factor * value : value)),
      );
      const rollout = model.rollout({ frames: Math.round(20 / frameTime), sequence: 0, alpha: cut, reading });
      const [legs, arms] = rollout.measures(Math.round(5 / frameTime)).parts;
      assert.ok(legs && arms);
      return { legs, arms };
    };
    const card = page.getByTestId("measured");
    const state = (/** @type {string} */ thread, /** @type {string} */ outcome) =>
      page.locator(`[data-testid=measured][data-thread=${thread}][data-outcome=${outcome}]`).waitFor();
    const seconds = (/** @type {number | null} */ value) => `${(value ?? NaN).toFixed(2)} s`;

    await page.getByTestId("choice-pace").click();
    release();
    await state("relearned", "pace");
    const cut = measured(100, "re-inferred");
    const learned = measured(1, "as-learned");
    const text = await card.innerText();
    assert.ok(text.startsWith(`Legs ${seconds(cut.legs.period)}, arms ${seconds(cut.arms.period)}`), text);

    await page.getByTestId("thread-kept").click();
    await state("kept", "stop");
    const kept = measured(100, "as-learned");
    const [is, was] = [kept.arms.swing, learned.arms.swing].map((swing) => (100 * (swing ?? NaN)).toFixed(0));
    assert.match(await card.innerText(), new RegExp(`^The hands swing ${is} cm instead of ${was} cm`));

    await page.getByTestId("open-in-lab").click();
    await ready(page);
    assert.match(page.url(), /reading=learned&alpha=0\.1:/);
    assert.equal(await page.getByTestId("foreign-link").count(), 0);
    await page.goBack();
    // Who says "stop" sees the arms stop first.
    await page.getByTestId("choice-stop").click();
    await state("kept", "stop");
  });
});

describe("the language", () => {
  it("is a choice that the browser keeps", async () => {
    const { page, leave } = await site.visit({ story: true, locale: "en-GB" });
    await open(page);
    await page.getByTestId("language").click();
    await page.locator("html[lang=de]").waitFor();
    await page.reload();
    await page.locator("html[lang=de]").waitFor();
    await page
      .getByRole("button", { name: "Weiter" })
      .or(page.getByRole("button", { name: "Nächstes Kapitel" }))
      .waitFor();
    await leave();
  });
});
