// The page for teachers: plans, slides with hands and notes, links of a state, and exercises that are measured.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { barriers, barriersNow, openedSite, ready, resize, seldom, soon } from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

const LAPTOP = { viewport: { width: 1280, height: 720 } };
const PHONE = { width: 390, height: 844 };

const open = (/** @type {Page} */ page) => page.locator(".teach[data-state=open]").waitFor();
const chapter = (/** @type {Page} */ page) => page.locator(".story[data-state=open]").waitFor();

describe("the page for teachers", () => {
  seldom.it("fits and has no barriers, in both languages, on a laptop and a phone", async () => {
    const { page } = await site.visit({ settings: "teach", locale: "en", ...LAPTOP });
    await open(page);
    await page.getByTestId("plan-90").click();
    for (const lang of ["en", "de"]) {
      await page.locator(`html[lang=${lang}]`).waitFor();
      assert.equal(await page.locator(".teach-plan tbody tr").count(), 14);
      assert.match(await page.locator(".teach-plan tbody tr").last().innerText(), /85–90/);
      for (const size of [LAPTOP.viewport, PHONE]) {
        await resize(page, size);
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), size.width);
        assert.deepEqual(await (lang === "en" ? barriers : barriersNow)(page), [], `${lang}, ${size.width}`);
      }
      await page.getByTestId("language").click();
    }
  });

  seldom.it(
    "follows the language, is linked from the story and the Lab, and prints only the sheet",
    async () => {
      const { page } = await site.visit({ settings: "story=1", locale: "en", ...LAPTOP });
      await chapter(page);
      await page.getByTestId("to-teach").click();
      await open(page);
      assert.match(page.url(), /#teach$/);
      await page.getByTestId("language").click();
      await page.getByRole("heading", { name: "Aufgaben" }).waitFor();
      await page.emulateMedia({ media: "print" });
      assert.equal(await page.locator(".teach-code:visible svg").count(), 7);
      assert.equal(await page.locator(".teach-plan:visible, [data-testid=start-slides]:visible").count(), 0);
      await page.emulateMedia({ media: "screen" });
      await page.getByTestId("to-lab").click();
      await ready(page);
      await page.getByTestId("to-teach").click();
      await open(page);
      await page.goBack();
      await page.getByTestId("stage").first().waitFor();
    },
  );
});

describe("slides", () => {
  seldom.it("count hands by keys, take one back, and say what most hands said", async () => {
    const { page } = await site.visit({ settings: "teach", locale: "en", ...LAPTOP });
    await open(page);
    await page.getByTestId("start-slides").click();
    await chapter(page);
    assert.equal(await page.locator(".story-head").count(), 0);
    // A clicker has one key: it shows the answer, and then the next chapter.
    await page.getByTestId("hand-example").waitFor();
    await page.keyboard.press("ArrowRight");
    await page.getByTestId("choice-stop").waitFor();
    await page.keyboard.press("ArrowRight");
    await page.locator("[data-testid=measured]").waitFor();
    assert.equal(await page.locator(".story-said").count(), 0, "nobody has said anything");
    await page.keyboard.press("ArrowRight");
    await page.getByTestId("choice-walk").waitFor();
    await page.keyboard.press("ArrowLeft");
    await page.getByTestId("choice-stop").waitFor();
    for (const key of ["1", "3", "1", "2", "Backspace"]) await page.keyboard.press(key);
    await soon(async () => assert.equal(await page.getByTestId("hands-stop").innerText(), "2"));
    assert.equal(await page.getByTestId("hands-pace").innerText(), "1");
    assert.equal(await page.getByTestId("hands-step").innerText(), "0");
    assert.deepEqual(await barriers(page), []);
    await page.keyboard.press("Enter");
    await page.getByText("2 of 3 said “Stop”. Right if the arms keep").waitFor();
    await page.evaluate(() => document.exitFullscreen().catch(() => {}));
    await page.keyboard.press("Escape");
    await open(page);
  });

  seldom.it("show the notes of the chapter in a second window, which turns the chapters too", async () => {
    const { page } = await site.visit({ settings: "story=2", locale: "en", ...LAPTOP });
    await chapter(page);
    const [notes] = await Promise.all([page.waitForEvent("popup"), page.keyboard.press("n")]);
    await notes.getByRole("heading", { name: "Who tells the arms when to swing?" }).waitFor();
    assert.match(await notes.locator("main").innerText(), /Next: A walk is a loop/);
    await notes.keyboard.press("ArrowRight");
    await page.waitForURL(/#story=3$/);
    await notes.getByRole("heading", { name: "A walk is a loop" }).waitFor();
  });
});

describe("the link of a state", () => {
  it("brings back chapter, cut and camera, also from a QR code", async () => {
    const { page } = await site.visit({
      settings: "story=2&cut=kept&camera=0.5,0.3,1.2",
      ...LAPTOP,
    });
    await page.locator("[data-testid=thread-kept][aria-pressed=true]").waitFor();
    await page.waitForURL(/#story=2$/);
    // The stage takes the camera with its first figure.
    await page.locator("[data-testid=measured][data-outcome=stop]").waitFor();
    await page.keyboard.press("q");
    const address = await page.getByTestId("code-address").getAttribute("href");
    assert.match(`${address}`, /#story=2&camera=0\.5,0\.3,1\.2(&time=[\d.]+)?&cut=kept$/);
    assert.deepEqual(await barriers(page), []);
    await page.keyboard.press("Escape");
    await page.getByTestId("code").waitFor({ state: "detached" });
  });

  seldom.it("opens the Lab with the camera and the time of the chapter", async () => {
    const { page } = await site.visit({ settings: "story=2&camera=0.5,0.3,1.2", ...LAPTOP });
    await page.locator(".story[data-engine=ready]").waitFor();
    await page.getByTestId("choice-stop").click();
    await page.locator("[data-testid=measured]").waitFor();
    const link = page.getByTestId("open-in-lab");
    await link.focus();
    const fragment = (await link.getAttribute("href")) ?? "";
    const time = Number(/time=([\d.]+)/.exec(fragment)?.[1]);
    assert.match(fragment, /camera=0\.5,0\.3,1\.2/);
    assert.ok(time > 0 && time < 10, fragment);
    await page.evaluate((fragment) => Object.assign(location, { hash: fragment }), fragment);
    await ready(page);
    await soon(async () => {
      const frame = Number(await page.getByTestId("scrub").inputValue());
      assert.ok(Math.abs(frame / 30 - time) < 0.1, `frame ${frame} for ${time} s`);
    });
    await page.locator("pg-stage canvas").last().focus();
    await page.keyboard.press("q");
    const address = await page.getByTestId("code-address").getAttribute("href");
    assert.match(`${address}`, /camera=0\.5,0\.3,1\.2/);
    assert.match(`${address}`, /alpha=0\.1:/);
  });
});

describe("exercises", () => {
  it("are solved by what the page measures, and can be closed", async () => {
    const { page } = await site.visit({ settings: "teach", locale: "en", ...LAPTOP });
    await open(page);
    await page.getByTestId("try-pace").click();
    await ready(page);
    const exercise = page.getByTestId("exercise");
    await exercise.getByText("Not yet.").waitFor();
    assert.deepEqual(await barriers(page), []);
    assert.equal(await page.getByTestId("preset").count(), 0, "a preset would be the answer");
    await page.getByTestId("coupling-0-1").press("Home");
    await exercise.getByText("Solved.").waitFor();
    assert.match(await exercise.innerText(), /of the hands 0\.8\d ×/);
    await page.evaluate(() => Object.assign(location, { hash: "exercise=5" }));
    await exercise.getByText("Not yet.").waitFor();
    await page.evaluate(() => Object.assign(location, { hash: "exercise=6&tab=learn&dynamics=6" }));
    await exercise.getByText("Train a model first.").waitFor();
    await page.getByTestId("close-exercise").click();
    assert.equal(await exercise.count(), 0);
  });

  seldom.it("take a trained model of few points that walks on", async () => {
    const settings = "exercise=6&tab=learn&dynamics=6";
    const { page } = await site.visit({ settings, locale: "en", ...LAPTOP });
    await ready(page);
    await page.getByTestId("train").click();
    // The page measures again while a training gets better.
    const solved = page.getByTestId("exercise").filter({ hasText: "Solved." });
    await solved.getByText(/6 points for a part/).waitFor({ timeout: 120_000 });
  });
});
