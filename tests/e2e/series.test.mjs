// Time series other than bodies: tables, and the curves, couplings and files of their model.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import {
  barriers,
  changes,
  drop,
  ACCESSIBLE,
  keepsNobodyOut,
  openPanel,
  openedSite,
  ready,
  readyVisitor,
  rests,
  saved,
  seldom,
  soon,
} from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

/** A trial of two machines; the second follows the first. */
function trial(/** @type {number} */ phase) {
  const rows = Array.from({ length: 60 }, (_, row) => {
    const now = phase + row / 3;
    const values = [row / 50, Math.sin(now), 2 * Math.cos(now), 10 + Math.sin(now - 0.7)];
    return values.map((value) => value.toFixed(4)).join(",");
  });
  return `time,drive_a,drive_b,load_c\n${rows.join("\n")}\n`;
}

/**
 * A trial of a walker in millimetres with z up: each leg swings from its hip, and the knee bends. Each point has
 * a column that says whether it was seen.
 */
function walker(/** @type {number} */ phase) {
  const rows = Array.from({ length: 60 }, (_, row) => {
    const now = phase + row / 5;
    /** @type {[string, number, number, number][]} */
    const points = [
      ["pelvis", 0, 0, 950],
      ["chest", 0, 0, 1400],
      ["head", 0, 0, 1650],
    ];
    for (const [side, sign] of /** @type {[string, number][]} */ ([
      ["left", 1],
      ["right", -1],
    ])) {
      const [hip, knee] = [0.5 * Math.sin(now + (sign * Math.PI) / 2), 0.5 * Math.sin(now - 1 + sign)];
      const at = { y: 430 * Math.sin(hip), z: 950 - 430 * Math.cos(hip) };
      points.push([`${side}_hip`, 100 * sign, 0, 950], [`${side}_knee`, 100 * sign, at.y, at.z]);
      const bent = hip - 0.5 + knee;
      points.push([`${side}_ankle`, 100 * sign, at.y + 420 * Math.sin(bent), at.z - 420 * Math.cos(bent)]);
    }
    return { points };
  });
  const names = rows[0]?.points.map(([name]) => name) ?? [];
  const head = names.flatMap((name) => [`${name}.x`, `${name}.y`, `${name}.z`, `${name}.visibility`]);
  const lines = rows.map(({ points }, row) =>
    [row / 30, ...points.flatMap(([, ...at]) => [...at, 0.9])].map((value) => value.toFixed(4)).join(","),
  );
  return `time,${head.join(",")}\n${lines.join("\n")}\n`;
}

/** The solid curve of a column. */
const course = (/** @type {Page} */ page, /** @type {number} */ curve) =>
  page.locator(`[data-testid=curve-${curve}] .rolled-out path`).getAttribute("d");

describe("tables of columns", () => {
  it("can be dropped, trained on, drawn, changed and saved, and their model opens again", async () => {
    const { page, problems, leave } = await site.visit({
      settings: "latent=2&dynamics=6&poses=6&iterations=40",
    });
    await ready(page);
    await drop(page, { "trial-1.csv": trial(0), "trial-2.csv": trial(2), "gap.csv": "x,y\n1,\n2,3\n" });
    await page.getByText("gap.csv, line 2, column 2 (y): expected a number (fill gaps before)").waitFor();
    assert.equal(await page.getByTestId("tables").getByRole("listitem").count(), 2);
    const parts = page.locator("pg-tables .part-names input");
    assert.deepEqual([await parts.nth(0).inputValue(), await parts.nth(1).inputValue()], ["drive", "load"]);
    await parts.nth(1).fill("drive");
    await parts.nth(1).press("Enter");
    await page.getByText("Another part is called “drive”.").waitFor();
    assert.equal(await parts.nth(1).inputValue(), "load");
    await parts.nth(1).fill("machine");
    await parts.nth(1).press("Enter");

    await page.getByTestId("series-train").click();
    await page.getByTestId("series-words").filter({ hasText: "Trained." }).waitFor({ timeout: 60_000 });
    await page.locator(".series-curve").nth(2).waitFor();
    assert.equal(await page.locator(".series-curve").count(), 3);
    assert.equal(await page.getByTestId("series-figure").count(), 0, "no figure of machines");
    assert.equal(
      await page.locator(".series-curve .rolled-out + .recorded").count(),
      3,
      "dashes above the lines",
    );
    assert.equal(await page.locator("pg-series .plot canvas").count(), 2);
    assert.equal(await page.locator("pg-series .mark").count(), 24, "inducing points of both parts");
    await page.locator("pg-series .loop-name").filter({ hasText: "machine" }).waitFor();
    const learned = await saved(page, "save-curves");
    const rows = learned.text.trim().split("\n");
    assert.equal(rows[0], "frame,time,drive_a,drive_b,load_c");
    // One and a half times as long as the trial.
    assert.equal(rows.length, 91);
    const before = await course(page, 2);
    await page.locator("pg-series [data-testid=coupling-0-1]").fill("-3");
    await page.waitForFunction(
      (before) =>
        document.querySelector("[data-testid=curve-2] .rolled-out path")?.getAttribute("d") !== before,
      before,
    );
    assert.notEqual((await saved(page, "save-curves")).text, learned.text);
    await page.getByTestId("series-reset").click();
    await page.waitForFunction(
      (before) =>
        document.querySelector("[data-testid=curve-2] .rolled-out path")?.getAttribute("d") === before,
      before,
    );

    // A recorded column is given, then drawn by hand; the model infers the others, and then moves all again.
    const another = async (/** @type {number} */ curve, /** @type {string | null} */ from) => {
      await page.waitForFunction(
        ({ curve, from }) =>
          document.querySelector(`[data-testid=curve-${curve}] .rolled-out path`)?.getAttribute("d") !== from,
        { curve, from },
      );
      return course(page, curve);
    };
    const giver = page.getByTestId("giver-0");
    await giver.selectOption("recording");
    const inferred = await another(2, before);
    await giver.selectOption("hand");
    const curve = page.locator("[data-testid=curve-0] svg");
    const drawn = await course(page, 0);
    await curve.focus();
    for (let k = 0; k < 3; k++) await page.keyboard.press("ArrowUp");
    const bent = await another(0, drawn);
    await curve.scrollIntoViewIfNeeded();
    const box = (await curve.boundingBox()) ?? assert.fail();
    await page.mouse.move(box.x + 0.3 * box.width, box.y + 0.5 * box.height);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.6 * box.width, box.y + 0.3 * box.height, { steps: 5 });
    await page.mouse.up();
    await another(0, bent);
    await another(2, inferred);
    assert.deepEqual(await barriers(page), []);
    await giver.selectOption("model");
    await page.waitForFunction(
      (before) =>
        document.querySelector("[data-testid=curve-2] .rolled-out path")?.getAttribute("d") === before,
      before,
    );

    // The page asks before it replaces an unsaved model; closing the question keeps the model.
    const leaving = () =>
      page.evaluate(() => !dispatchEvent(new Event("beforeunload", { cancelable: true })));
    assert.ok(await leaving(), "leaving asks");
    await page.getByTestId("series-train").focus();
    await page.keyboard.press("Enter");
    const question = page.getByTestId("unsaved");
    await question.waitFor();
    assert.match(await question.innerText(), /Not saved: the model of tables that was trained here/);
    assert.deepEqual(await barriers(page), []);
    await page.keyboard.press("Escape");
    await question.waitFor({ state: "detached" });
    assert.equal(
      await page.evaluate(() => document.activeElement?.getAttribute("data-testid")),
      "series-train",
    );
    assert.equal(await course(page, 2), before);
    // Enough iterations for the curves to appear during the training.
    await page.locator("pg-series #open-learn").click();
    await page.getByTestId("series-maxIterations").fill("5000");
    await page.getByTestId("series-train").click();
    await question.waitFor();
    // Checked when the question closes: a moment later, the new training has an unsaved model again.
    const asksAtOnce = page.evaluate(
      () =>
        new Promise((answer) => {
          const look = () =>
            document.querySelector("[data-testid=unsaved]")
              ? requestAnimationFrame(look)
              : answer(!dispatchEvent(new Event("beforeunload", { cancelable: true })));
          look();
        }),
    );
    const model = await saved(page, "unsaved-save");
    assert.ok(!(await asksAtOnce), "the model is saved");
    await page.getByTestId("series-cancel").click();
    await page.getByTestId("series-train").waitFor();
    assert.deepEqual(problems, []);
    await leave();

    // Another visitor opens the model alone, and then a table too.
    const other = await site.visit();
    await ready(other.page);
    await drop(other.page, { "model.json": model.text });
    await other.page.getByTestId("series-start").waitFor();
    assert.equal(await other.page.locator(".series-curve .recorded").count(), 0);
    assert.equal((await saved(other.page, "save-curves")).text, learned.text);
    assert.equal((await saved(other.page, "save-series")).text, model.text);
    await drop(other.page, { "trial-1.csv": trial(0) });
    await other.page.locator(".series-curve .recorded").nth(2).waitFor();
    assert.deepEqual(other.problems, []);
    await other.leave();
  });

  seldom.it("are drawn as a figure of points and bones, without the columns that are left out", async () => {
    const settings = "latent=2&dynamics=6&poses=6&iterations=60";
    // In a smaller window, the figure and the slider are not in sight together.
    const viewport = { width: 1280, height: 800 };
    const { page, problems, leave } = await site.visit({ settings, seen: true, viewport });
    await ready(page);
    await drop(page, { "walk-1.csv": walker(0), "walk-2.csv": walker(2) });
    const columns = page.locator("pg-tables .joint-tree li");
    await soon(async () => assert.equal(await columns.count(), 36));
    const without = page.getByTestId("series-without");
    await without.fill("*.colour");
    await without.press("Enter");
    await page.getByText('to leave out, found "*.colour"').waitFor();
    await without.fill("*.visibility");
    await without.press("Enter");
    await soon(async () => assert.equal(await columns.count(), 27));
    await page.getByTestId("series-train").click();
    await page.getByTestId("series-words").filter({ hasText: "Trained." }).waitFor({ timeout: 60_000 });
    const figure = page.getByTestId("series-figure");
    await figure.scrollIntoViewIfNeeded();
    const header = (await saved(page, "save-curves")).text.split("\n", 1)[0] ?? "";
    assert.match(header, /^frame,time,pelvis\.x,.*right_ankle\.z$/);
    assert.ok(!header.includes("visibility"));

    await page.getByTestId("series-scrub").fill("30");
    assert.ok(await rests(figure));
    const learned = await figure.screenshot();
    // The left leg decides about the right one.
    await page.locator("pg-series [data-testid=coupling-3-4]").fill("-3");
    await soon(async () =>
      assert.ok(!(await figure.screenshot()).equals(learned), "moves with the couplings"),
    );
    await page.getByTestId("series-play").click();
    assert.ok(await changes(figure), "walks with the clock of the curves");
    assert.deepEqual(problems, []);
    await leave();
  });

  seldom.it(
    ACCESSIBLE,
    keepsNobodyOut(
      () => readyVisitor(site.visit({ settings: "latent=1&dynamics=4&poses=4&iterations=10" })),
      async (page, fits) => {
        await openPanel(page, "learn");
        await page.getByTestId("show-series").click();
        await page.getByTestId("series-example").click();
        await page.getByTestId("series-train").and(page.locator(":enabled")).click({ timeout: 60_000 });
        await page.locator(".series-curve").nth(4).waitFor({ timeout: 60_000 });
        await page.getByTestId("series-train").waitFor({ timeout: 60_000 });
        await fits("trained");
      },
    ),
  );
});
