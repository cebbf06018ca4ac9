// A library of primitives: new combinations while the figure moves on, new couplings, learning from clips.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { opened } from "./library.mjs";
import {
  draws,
  ACCESSIBLE,
  keepsNobodyOut,
  openedSite,
  ready,
  readyVisitor,
  saved,
  seldom,
} from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

/**
 * The largest step of a node from one frame to the next, in metres. A hand of a jumping jack moves 0.2 m, and 0.5 m
 * when its arms are exchanged; without the transition, exchanged arms would move 1.1 m or more.
 */
const LARGEST_STEP = 0.6;

/**
 * The number of the newest frame of the large figure, and the largest step of a node between two of the
 * newest frames.
 */
const walked = (/** @type {Page} */ page, newest = 1000) =>
  page.evaluate((newest) => {
    const { track } = /** @type {any} */ (document.querySelector("pg-walk")).library.walk;
    const { positions, frames, nodes } = track.motion;
    let largest = 0;
    for (let i = 3 * nodes * Math.max(1, frames - newest); i < 3 * nodes * frames; i += 3) {
      const at = (/** @type {number} */ k) => positions[i + k] - positions[i + k - 3 * nodes];
      largest = Math.max(largest, Math.hypot(at(0), at(1), at(2)));
    }
    return { last: track.last, frames, largest };
  }, newest);

/** Waits until the figure has moved on by `frames` frames. */
async function goOn(/** @type {Page} */ page, frames = 45) {
  const { last } = await walked(page);
  await page.waitForFunction(
    (last) => /** @type {any} */ (document.querySelector("pg-walk")).library.walk.track.last >= last,
    last + frames,
    { timeout: 60_000 },
  );
}
/**
 * Gives a part another primitive by mouse or keyboard. Returns the milliseconds from the event to the request
 * to the worker, to its answer and to the first picture with the new frames; also the number of display
 * frames until that picture, and how many of these came after the answer with a frame that the figure had not
 * reached before it. Frames that were reached stay as they are: on a busy machine the answer comes late.
 */
async function redrawn(/** @type {Page} */ page, /** @type {string} */ id, /** @type {boolean} */ byKey) {
  const button = page.getByTestId(id);
  const measured = await page.evaluateHandle((id) => {
    const { walk, playback: player } = /** @type {any} */ (document.querySelector("pg-walk")).library;
    const { track } = walk;
    const found = { drawn: 0, asked: 0, answered: 0, frames: 0, waited: 0 };
    let reached = 0;
    const begin = (/** @type {Event} */ { timeStamp }) => {
      const since = () => performance.now() - timeStamp;
      const known = new Map();
      for (let k = Math.floor(player.frame); k <= track.last; k++) known.set(k, track.frame(k).slice());
      const { postMessage } = Worker.prototype;
      Worker.prototype.postMessage = function (/** @type {any} */ message, /** @type {any} */ ...more) {
        if (message.path?.[0] === "advanceWalk" && JSON.stringify(message.argumentList).includes('"use"')) {
          found.asked = since();
          Worker.prototype.postMessage = postMessage;
          const answered = (/** @type {MessageEvent} */ { data }) => {
            if (data?.id !== message.id) return;
            found.answered = since();
            reached = Math.max(reached, Math.ceil(player.frame));
            this.removeEventListener("message", answered);
          };
          this.addEventListener("message", answered);
        }
        return postMessage.call(this, message, ...more);
      };
      const look = () => {
        found.frames += 1;
        // The frame that the picture shows.
        const newest = Math.ceil(player.frame);
        if (found.answered === 0) reached = Math.max(reached, newest);
        else if (newest > reached) found.waited += 1;
        const before = known.get(newest);
        const isNew =
          !before ||
          track.frame(newest).some((/** @type {number} */ x, /** @type {number} */ i) => x !== before[i]);
        if (found.answered > 0 && isNew) found.drawn = since();
        else requestAnimationFrame(look);
      };
      requestAnimationFrame(look);
    };
    document
      .querySelector(`[data-testid=${id}]`)
      ?.addEventListener("click", begin, { once: true, capture: true });
    return found;
  }, id);
  if (byKey) {
    await button.focus();
    await page.keyboard.press("Enter");
  } else await button.click();
  await page.waitForFunction(({ drawn }) => drawn > 0, measured, { timeout: 10_000 });
  return await measured.jsonValue();
}
const median = (/** @type {number[]} */ values) =>
  values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)] ?? 0;

const recorded = (/** @type {Page} */ page) => page.getByTestId("recorded").innerText();

describe("a library of primitives", () => {
  it("opens with a combination that was never recorded, and exchanges a primitive without a jump", async (test) => {
    const { page } = await site.visit({
      settings: "view=primitives",
      moving: true,
      pictures: 60,
    });
    await opened(page);
    assert.equal(await recorded(page), "Never recorded");
    assert.match(await page.getByTestId("library-words").innerText(), /mocap\.cs\.cmu\.edu/);
    await goOn(page);
    const before = await walked(page);
    assert.ok(before.largest > 0.01, "it moves");
    await page.getByTestId("primitive-1-4").click();
    assert.equal(await page.getByTestId("primitive-1-4").getAttribute("aria-pressed"), "true");
    assert.equal(await recorded(page), "Recorded as walk");
    await goOn(page);
    await page.getByTestId("primitive-1-5").click();
    await goOn(page);
    // Each is in the first picture that can show the worker's answer.
    /** @type {Awaited<ReturnType<typeof redrawn>>[]} */
    const redraws = [];
    for (let k = 0; k < 5; k++) {
      redraws.push(await redrawn(page, k % 2 === 0 ? "primitive-1-4" : "primitive-1-5", k % 3 === 0));
      await goOn(page, 12);
    }
    assert.ok(
      redraws.every(({ waited }) => waited <= 1),
      JSON.stringify(redraws),
    );
    const of = (/** @type {(redraw: (typeof redraws)[number]) => number} */ what) =>
      median(redraws.map(what)).toFixed(1);
    const answer = of(({ asked, answered }) => answered - asked);
    const words =
      `${of(({ drawn }) => drawn)} ms, ${of(({ frames }) => frames)} display frames; ` +
      `the worker's answer took ${answer} ms`;
    test.diagnostic(`an exchange is in the picture after (medians of ${redraws.length}) ${words}`);
    await page.getByTestId("primitive-0-1").click();
    await goOn(page);
    const after = await walked(page);
    assert.ok(after.last > before.last + 100, "the same walk");
    assert.ok(after.largest < LARGEST_STEP, `a step of ${after.largest} m`);
    await draws(page.getByTestId("walk"));

    // All combinations, and a primitive dragged onto the body.
    await page.getByTestId("combination").first().click();
    assert.equal(await recorded(page), "Recorded as walk");
    await page.getByTestId("primitive-1-5").dragTo(page.getByTestId("slot-1").locator(".map-node"));
    assert.equal(await page.getByTestId("combination-title").innerText(), "legs: walk, arms: jump");
    await page.getByTestId("primitive-0-1").dragTo(page.getByTestId("slot-1").locator(".map-node"));
    assert.equal(await recorded(page), "Never recorded", "legs do not go where arms are");
    await goOn(page, 10);
  });

  seldom.it(
    "lets a hand, the wheel and a recording move parts, and cuts a coupling, while the figure goes on",
    async () => {
      const { page } = await site.visit({ settings: "view=primitives", moving: true });
      await ready(page);
      await opened(page);
      const marks = (/** @type {string} */ kind) =>
        page.waitForFunction(
          (kind) =>
            /** @type {any} */ (document.querySelector("pg-walk")).library.walk.marks.some(
              (/** @type {any} */ mark) => mark.kind === kind,
            ),
          kind,
        );
      // The head stands still while it is looked for.
      await page.getByTestId("walk-play").click();
      await page.getByRole("button", { name: "Play", exact: true }).waitFor();
      const head = await page.getByTestId("walk").evaluate((canvas) => {
        const { scene } = /** @type {any} */ (canvas.closest("pg-stage"));
        const { left, top } = canvas.getBoundingClientRect();
        const { x, y } = scene.placeOf(3);
        return { x: left + x, y: top + y };
      });
      await page.mouse.move(head.x, head.y);
      await page.mouse.down();
      await page.mouse.move(head.x + 20, head.y, { steps: 4 });
      await marks("push");
      await page.mouse.up();
      const legs = page.getByTestId("mover-0");
      await legs.selectOption("you");
      await page.getByTestId("wheel").press("ArrowRight");
      await marks("drive");
      await legs.selectOption({ label: "Jumping jacks 1, by a model of CMU" });
      await marks("record");
      await legs.selectOption("model");
      const cut = page.locator("pg-walk-couplings .cut-button").first();
      await cut.focus();
      await page.keyboard.down("Enter");
      await page.locator("pg-walk-couplings .cut-button[aria-pressed=true]").waitFor();
      await page.keyboard.up("Enter");
      await marks("cut");
      await goOn(page, 20);
    },
  );

  seldom.it("fits couplings to a clip, saves the library, and shows the model on the stage", async () => {
    const { page } = await site.visit({ settings: "view=primitives" });
    await ready(page);
    await opened(page);
    const alpha = page.getByTestId("walk-alpha-1-1");
    const before = await alpha.innerText();
    await page.getByTestId("fit-clip").selectOption({ label: "Jumping jacks 1, by a model of CMU" });
    await page.getByTestId("fit").click();
    await page.waitForFunction(
      () => / s\.$/.test(document.querySelector("[data-testid=fit-words]")?.textContent ?? ""),
      null,
      { timeout: 60_000 },
    );
    const words = await page.getByTestId("fit-words").innerText();
    // Two seconds on an idle machine; tests run at the same time.
    assert.ok(Number(words.match(/([\d.]+) s\.$/)?.[1]) < 20, words);
    assert.notEqual(await alpha.innerText(), before, "the couplings were taken over");
    await page.getByTestId("keep-combination").click();
    await page.waitForFunction(
      () =>
        /** @type {any} */ (document.querySelector("pg-walk")).library.current.info.movements.length === 5,
    );
    const { name, text } = await saved(page, "save-library");
    assert.equal(name, "library.json");
    assert.deepEqual(
      JSON.parse(text).movements.map((/** @type {{ name: string }} */ { name }) => name),
      ["walk", "jump", "run", "wave", "walk + jump"],
    );
    assert.equal(JSON.parse(text).movements[4].couplings.from, "clips", "what it was fitted to is kept");
    await page.getByTestId("open-library").setInputFiles({
      name: "mine.json",
      mimeType: "application/json",
      buffer: Buffer.from(text),
    });
    await page.getByText("mine.json").waitFor();
    await page.getByTestId("library-undo").click();
    await page.getByText("A library of recorded movements").waitFor();

    const model = await page.evaluate(
      () => /** @type {any} */ (document.querySelector("pg-page")).app.model.id,
    );
    // The page still moves under a pointer: what moves well comes later.
    await page.getByTestId("put-on-stage").press("Enter");
    await page.getByTestId("stage").waitFor();
    const next = await page.evaluate(
      () => /** @type {any} */ (document.querySelector("pg-page")).app.model.id,
    );
    assert.notEqual(next, model);
    assert.doesNotMatch(page.url(), /view=primitives/);
    // As it was left.
    await page.getByTestId("view-primitives").click();
    await page.getByTestId("combination-title").waitFor();
    await page.getByTestId("open-library").setInputFiles({
      name: "no.json",
      mimeType: "application/json",
      buffer: Buffer.from("{}"),
    });
    await page.locator("pg-primitives [data-testid=notice]").waitFor();
    assert.equal(await page.getByTestId("combination").count(), 16, "the library stays");
  });

  seldom.it("learns a library from clips in groups, which can be taken back", async () => {
    const { page } = await site.visit({
      settings: "view=primitives&fps=15&iterations=20&dynamics=6&poses=8",
    });
    await ready(page);
    await opened(page);
    await page.getByTestId("share-0-same").click();
    await page.getByTestId("learn").click();
    await page.getByText("The library learned here").waitFor({ timeout: 120_000 });
    await opened(page);
    assert.equal(
      await page.getByTestId("combination").count(),
      2,
      "one primitive of the legs, two of the arms",
    );
    assert.match(await page.getByTestId("learn-words").innerText(), /^Learned\. /);
    await page.getByTestId("library-undo").click();
    await page.getByText("A library of recorded movements").waitFor();
    await opened(page);
    assert.equal(await page.getByTestId("combination").count(), 16);
  });

  seldom.it("saves a primitive, adds it where it fits, and says why it does not fit", async () => {
    const { page } = await site.visit({ settings: "view=primitives", moving: true });
    await ready(page);
    await opened(page);
    const { name, text } = await saved(page, "save-primitive-0-0");
    assert.equal(name, "lower walk.json");
    const add = (/** @type {string} */ name, /** @type {string} */ text) =>
      page
        .getByTestId("add-primitives")
        .setInputFiles({ name, mimeType: "application/json", buffer: Buffer.from(text) });
    await add("same.json", text);
    await page.getByText("These primitives are in the library already.").waitFor();
    // As if from another training: centred elsewhere.
    const other = JSON.parse(text);
    other.column_means[3] += 0.01;
    other.primitives[0].name = "stroll";
    await add("other.json", JSON.stringify(other));
    await page
      .locator("pg-primitives [data-testid=notice]")
      .filter({ hasText: /the columns differ/i })
      .waitFor();
    assert.equal(await page.getByTestId("primitive-0-8").count(), 0);
  });

  seldom.it("works by keyboard alone", async () => {
    const { page } = await site.visit({ settings: "view=primitives", moving: true });
    await opened(page);
    const tabTo = async (/** @type {string} */ id) => {
      for (let i = 0; i < 60; i++) {
        await page.keyboard.press("Tab");
        if (await page.evaluate((id) => document.activeElement?.getAttribute("data-testid") === id, id))
          return;
      }
      assert.fail(`the Tab key does not reach ${id}`);
    };
    await tabTo("walk-play");
    await page.keyboard.press("Enter");
    await page.getByRole("button", { name: "Play", exact: true }).waitFor();
    await tabTo("primitive-1-4");
    await page.keyboard.press("Enter");
    assert.equal(await recorded(page), "Recorded as walk");
    // The couplings of the walk come from the worker.
    await page.getByTestId("walk-alpha-0-1").filter({ hasNotText: "10.0" }).waitFor();
    const learned = await page.getByTestId("walk-alpha-0-1").innerText();
    await tabTo("tempo-1");
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.getByTestId("tempo-1").inputValue(), "1.05");
    const before = await page.getByTestId("walk-alpha-0-1").innerText();
    await tabTo("walk-coupling-0-1");
    for (let i = 0; i < 9; i++) await page.keyboard.press("ArrowLeft");
    assert.notEqual(await page.getByTestId("walk-alpha-0-1").innerText(), before);
    await page.keyboard.press("Delete");
    assert.equal(await page.getByTestId("walk-alpha-0-1").innerText(), learned);
  });

  seldom.it(
    ACCESSIBLE,
    keepsNobodyOut(
      () => readyVisitor(site.visit({ settings: "view=primitives" })),
      async (page, fits) => {
        await opened(page);
        await fits("opened");
      },
    ),
  );
});
