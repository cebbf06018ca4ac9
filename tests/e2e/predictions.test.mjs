// Predictions, futures and uncertainty in the latent plots, compared with the npm package.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe, it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { at } from "../../scripts/run.mjs";
import { dist } from "../../scripts/site.mjs";
import { oneVisitor, openedSite, ready, readyVisitor, rests, seldom, soon } from "./site.mjs";
import { coupledInfo } from "../node/package.mjs";

/** @typedef {{ x: number, y: number, major: number, minor: number }} Ellipse */
/** @typedef {{ call: "ellipse" | "arc" | "lineTo", at: number[] }} Call */

const { Model } = builtPackage();
const ALPHA = [
  [0.02, 0.1],
  [0.3, 0.1],
];
const FRAME = 40;

const site = openedSite();

/** @param {number | undefined} a @param {number | undefined} b @param {number} tolerance */
const close = (a, b, tolerance) =>
  assert.ok(Math.abs((a ?? Number.NaN) - (b ?? Number.NaN)) <= tolerance, `${a} and ${b}`);

/**
 * Records what the latent plots draw from now on.
 * @param {import("playwright-core").Page} page
 */
async function recordDrawings(page) {
  await page.evaluate(() => {
    /** @type {Map<string, Call[]>} The newest picture of each plot. */
    const pictures = new Map();
    const { prototype } = CanvasRenderingContext2D;
    const plotOf = (/** @type {CanvasRenderingContext2D} */ { canvas }) =>
      canvas.closest("[data-testid^=latent-]")?.getAttribute("data-testid") ?? "";
    const { clearRect } = prototype;
    prototype.clearRect = function (...box) {
      pictures.set(plotOf(this), []);
      clearRect.apply(this, box);
    };
    for (const call of /** @type {const} */ (["ellipse", "arc", "lineTo"])) {
      const draw = /** @type {(...at: any[]) => void} */ (prototype[call]);
      /** @this {CanvasRenderingContext2D} */
      prototype[call] = function (/** @type {any[]} */ ...at) {
        pictures.get(plotOf(this))?.push({ call, at });
        draw.apply(this, at);
      };
    }
    Object.assign(window, { pictures });
  });
}

/**
 * The experts, their product and the step that a plot shows; null without predictions.
 * @param {import("playwright-core").Page} page
 */
async function drawn(page, /** @type {number} */ part) {
  // The plot is painted before the second display frame from now.
  /** @type {Call[]} */
  const calls = await page.evaluate(async (plot) => {
    for (let i = 0; i < 2; i++) await new Promise((resolve) => requestAnimationFrame(resolve));
    return /** @type {any} */ (window).pictures.get(plot) ?? [];
  }, `latent-${part}`);
  const ellipses = calls.filter(({ call }) => call === "ellipse");
  const [product, ...experts] = ellipses
    .map(({ at: [x = 0, y = 0, major = 0, minor = 0] }) => ({ x, y, major, minor }))
    .reverse();
  if (!product) return null;
  // The step is drawn after the last expert, and before the product.
  const before = calls.slice(0, calls.lastIndexOf(/** @type {Call} */ (ellipses.at(-1))));
  const lastExpert = before.findLastIndex(({ call }) => call !== "lineTo");
  return { product, experts: experts.reverse(), step: before[lastExpert + 1]?.at ?? [] };
}

describe("the product of experts", () => {
  seldom.it("agrees with the package, in 2-D and 3-D", async () => {
    const alpha = ALPHA.flatMap((row, j) => row.map((a, i) => `${j}.${i}:${a}`)).join(",");
    const settings = `alpha=${alpha}&reading=learned`;
    const { page } = await site.visit({ settings: `tab=more&${settings}` });
    await ready(page);
    await recordDrawings(page);
    await page.getByTestId("scrub").fill(String(FRAME));
    const model = Model.fromJson(readFileSync(`${dist}/first/model.json`, "utf8"));
    const frames = Number(await page.getByTestId("scrub").getAttribute("max")) + 1;
    const rollout = model.rollout({ frames, sequence: 0, alpha: ALPHA, reading: "as-learned" });
    const [predicted, weights] = [rollout.predictions(), rollout.weights()];
    const row = FRAME - predicted.firstFrame;
    for (const plot of ["2-D", "3-D"]) {
      await page.getByRole("button", { name: plot }).click();
      for (const [part] of coupledInfo(model).parts.entries()) {
        // The page asks for predictions a moment after the rollout has stopped.
        const picture = await soon(async () => {
          const picture = await drawn(page, part);
          assert.ok(picture, "predictions are drawn");
          return picture;
        });
        const { experts, product, step } = picture;
        assert.equal(experts.length, 2);
        const scale = product.major / Math.sqrt(predicted.variances(part)[row] ?? Number.NaN);
        const sum = { x: 0, y: 0 };
        for (const [source, { x, y, major, minor }] of experts.entries()) {
          // Circles: a deviation has the same number of pixels in both directions.
          close(
            major,
            scale * Math.sqrt(predicted.expertVariances(source, part)[row] ?? Number.NaN),
            1e-6 * major,
          );
          close(minor, major, 1e-6 * major);
          const weight = weights[source]?.[part] ?? Number.NaN;
          sum.x += weight * x;
          sum.y += weight * y;
        }
        // From every side, the product is at the weighted mean, where the step ends.
        close(product.x, sum.x, 0.01);
        close(product.y, sum.y, 0.01);
        close(step[0], product.x, 0.01);
        close(step[1], product.y, 0.01);
        // A plot with as many axes as the part shows the full distance of two means.
        const [one, two] = [0, 1].map((source) => [
          ...predicted.expertMeans(source, part).slice(3 * row, 3 * row + 3),
        ]);
        const apart = Math.hypot(...(one ?? []).map((mean, q) => mean - (two?.[q] ?? Number.NaN)));
        const seen = Math.hypot(
          (experts[0]?.x ?? 0) - (experts[1]?.x ?? 0),
          (experts[0]?.y ?? 0) - (experts[1]?.y ?? 0),
        );
        assert.ok(
          seen <= scale * apart * 1.000001 && seen > 0.01 * scale * apart,
          `${seen} of ${scale * apart}`,
        );
      }
    }
    await page.getByRole("button", { name: "predictions", exact: true }).click();
    assert.equal(await drawn(page, 0), null);
  });
});

describe("futures and uncertainty", () => {
  const visitor = oneVisitor(() => readyVisitor(site.visit({ settings: "tab=more" })));

  it("show five futures of a seed, and others of the next seed", async () => {
    const { page } = visitor;
    await page.getByRole("button", { name: "futures", exact: true }).click();
    await page.waitForFunction(
      () => /** @type {any} */ (document.querySelector("pg-outlook"))?.outlook.futures.length === 5,
    );
    assert.match((await page.getByTestId("futures").textContent()) ?? "", /seeds 1 to 5/);
    await page.getByTestId("other-futures").click();
    await page.getByText("seeds 6 to 10").waitFor();
    await page.getByRole("button", { name: "futures", exact: true }).click();
    await page.getByTestId("futures").waitFor({ state: "detached" });
  });

  seldom.it("show the band of moment matching, from the whole program", async () => {
    const { page } = visitor;
    // The text below would make the plots smaller.
    await page.evaluate(() => {
      const sheet = new CSSStyleSheet();
      sheet.replaceSync(".outlook { display: none !important; }");
      document.adoptedStyleSheets = [sheet];
    });
    await page.getByTestId("scrub").fill(String(FRAME));
    const plot = page.getByTestId("latent-1");
    await page.mouse.move(0, 0);
    assert.ok(await rests(plot));
    const before = await plot.screenshot();
    assert.ok(before.equals(await plot.screenshot()), "the plot stands still");
    await page.getByRole("button", { name: "uncertainty", exact: true }).click();
    await page
      .getByTestId("uncertainty")
      .filter({ hasNotText: "(loading)" })
      .waitFor({ state: "attached", timeout: 30_000 });
    await page.mouse.move(0, 0);
    assert.ok(!before.equals(await plot.screenshot()), "the band is drawn");
  });
});

describe("where the model is sure", () => {
  seldom.it("is painted behind the loop, with colour where the variance of the poses is low", async () => {
    const { page } = await readyVisitor(site.visit({ settings: "tab=more" }));
    const frames = Number(await page.getByTestId("scrub").getAttribute("max")) + 1;
    const plot = page.getByTestId("latent-0");
    await page.mouse.move(0, 0);
    assert.ok(await rests(plot));
    const before = await plot.screenshot();
    const button = page.getByRole("button", { name: "where the model is sure" });
    await button.click();
    await page.waitForFunction(() => document.querySelector("pg-outlook"));
    // The pictures that the plots draw, as opacities in the middles of squares of 20 pixels.
    await page.evaluate(() => {
      const { outlook } = /** @type {any} */ (document.querySelector("pg-outlook"));
      const pictureOf = outlook.pictureOf.bind(outlook);
      outlook.pictureOf = (/** @type {number} */ part, /** @type {any} */ picture) => {
        const bitmap = pictureOf(part, picture);
        if (!bitmap || part !== 0) return bitmap;
        const { width, height, centre, right, down } = picture;
        const draw = new OffscreenCanvas(width, height).getContext("2d");
        draw?.drawImage(bitmap, 0, 0);
        const points = [];
        const opacities = [];
        for (let y = 10; y < height; y += 20)
          for (let x = 10; x < width; x += 20) {
            opacities.push(draw?.getImageData(x, y, 1, 1).data[3]);
            const [dx, dy] = [x + 0.5 - width / 2, y + 0.5 - height / 2];
            points.push(
              centre.map(
                (/** @type {number} */ at, /** @type {number} */ q) => at + dx * right[q] + dy * down[q],
              ),
            );
          }
        Object.assign(window, { painted: { points, opacities } });
        return bitmap;
      };
      outlook.changed();
    });
    await page.waitForFunction(() => "painted" in window, undefined, { timeout: 30_000 });
    const { points, opacities } = await page.evaluate(() => /** @type {any} */ (window).painted);
    const model = Model.fromJson(readFileSync(`${dist}/first/model.json`, "utf8"));
    const { poseVariance } = model.rollout({ frames }).latentField(0, points);
    assert.ok(
      Math.max(...opacities) - Math.min(...opacities) > 60,
      `from ${Math.min(...opacities)} to ${Math.max(...opacities)}`,
    );
    // Arrows cover some of the points.
    const same = poseVariance.filter(
      (variance, n) => Math.abs(110 * (1 - variance) - opacities[n]) < 8,
    ).length;
    assert.ok(
      same > 0.7 * points.length,
      `${same} of ${points.length} points have the opacity of their variance`,
    );

    await button.click();
    await page.mouse.move(0, 0);
    assert.ok(await rests(plot));
    assert.ok(before.equals(await plot.screenshot()), "nothing is left of it");
  });
});
