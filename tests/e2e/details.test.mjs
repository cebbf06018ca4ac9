// The tab Numbers: the kernels of a model and the channels of the motion on the stage, compared with the npm
// package.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe, it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { dist } from "../../scripts/site.mjs";
import { barriers, bytesOf, openPanel, openedSite, ready, seldom } from "./site.mjs";
import { coupledInfo } from "../node/package.mjs";

const { Model } = builtPackage();

const site = openedSite();

describe("the tab Numbers", () => {
  it("shows the kernels, with explained terms", async () => {
    const { page } = await site.visit();
    await ready(page);
    await openPanel(page, "numbers");
    const document = JSON.parse(readFileSync(`${dist}/first/model.json`, "utf8"));
    await page.getByTestId("pose-kernels").waitFor();
    const cells = await page.getByTestId("pose-kernels").locator("tbody td").allInnerTexts();
    assert.equal(cells.length, 2 * (2 + 3));
    assert.ok(Math.abs(Number(cells[0]) / document.parts[0].variance - 1) < 0.05, "signal variance");
    assert.ok(Math.abs(Number(cells[2]) / Math.sqrt(document.parts[0].lambda[0]) - 1) < 0.05, "lengthscale");
    assert.equal(await page.getByTestId("expert-kernels").locator("tbody tr").count(), 4);
    assert.equal(await page.getByTestId("log-density").locator("tbody tr").count(), 1);
    assert.deepEqual(await barriers(page), []);
    await page.locator("pg-numbers .term[data-term=lengthscale]").first().click();
    await page.getByRole("dialog", { name: "lengthscale" }).waitFor();
    await page.keyboard.press("Escape");
  });

  seldom.it("plots a channel against time, speed or another channel, and saves the plot", async () => {
    const { page } = await site.visit({
      settings: "alpha=0.1:8",
      moving: true,
      viewport: { width: 390, height: 844 },
    });
    await ready(page);
    await openPanel(page, "numbers");
    // With changed couplings there are two curves: the present motion, and as learned.
    await page.locator("pg-numbers .course").nth(1).waitFor();
    assert.equal(await page.locator("pg-numbers .course").count(), 2);
    const motions = await page.getByTestId("log-density").locator("tbody tr").allInnerTexts();
    const [altered = NaN, learned = NaN] = motions.map((row) => Number(row.split("\t")[1]));
    assert.ok(altered < learned, `the changed motion is the less likely one: ${motions.join("; ")}`);
    assert.deepEqual(await barriers(page), []);
    const save = async () => {
      const [file] = await Promise.all([
        page.waitForEvent("download"),
        page.getByTestId("save-angles").click(),
      ]);
      const rows = (await bytesOf(file)).toString("utf8").trim().split("\r\n");
      return {
        header: rows[0]?.split(",") ?? [],
        rows: rows.slice(1).map((row) => row.split(",").map(Number)),
      };
    };

    const model = Model.fromJson(readFileSync(`${dist}/first/model.json`, "utf8"));
    const { joints, alpha } = coupledInfo(model);
    const columns = joints.flatMap(({ name, channels }) => channels.map((channel) => `${name} ${channel}`));
    const [knee, elbow] = ["LeftLeg Xrotation", "LeftForeArm Xrotation"].map((name) => columns.indexOf(name));
    assert.ok(knee && knee > 0 && elbow && elbow > 0, columns.join());
    await page.getByTestId("angle").selectOption(String(knee));
    const overTime = await save();
    assert.deepEqual(overTime.header, [
      "frame",
      "time (s)",
      "the model now: LeftLeg Xrotation (°)",
      "as learned: LeftLeg Xrotation (°)",
    ]);
    const changed = alpha.map((row, source) =>
      row.map((value, target) => (source === 0 && target === 1 ? 8 : value)),
    );
    const frames = overTime.rows.length;
    const bvh = model.rollout({ frames, sequence: 0, alpha: changed, reading: "re-inferred" }).toBvh();
    const written = bvh
      .trim()
      .split("\n")
      .slice(-frames)
      .map((row) => row.trim().split(/\s+/).map(Number));
    for (const [frame, row] of overTime.rows.entries())
      assert.ok(Math.abs((row[2] ?? 0) - (written[frame]?.[knee] ?? 0)) < 1e-6, `frame ${frame}`);

    await page.getByTestId("across").selectOption("speed");
    const phase = await save();
    assert.equal(phase.header[3], "the model now: speed of LeftLeg Xrotation (°/s)");
    const [before = [], now = [], next = []] = phase.rows.slice(99, 102);
    const slope = ((next[2] ?? 0) - (before[2] ?? 0)) / ((next[1] ?? 0) - (before[1] ?? 0));
    assert.ok(Math.abs((now[3] ?? 0) - slope) < 1e-6);

    await page.getByTestId("across").selectOption(String(elbow));
    const against = await save();
    assert.ok(Math.abs((against.rows[50]?.[2] ?? 0) - (written[50]?.[elbow] ?? 0)) < 1e-6);
    assert.ok(Math.abs((against.rows[50]?.[3] ?? 0) - (written[50]?.[knee] ?? 0)) < 1e-6);

    // The dot follows the motion.
    const height = await page.locator("pg-numbers .now").getAttribute("cy");
    await page.waitForFunction(
      (before) => document.querySelector("pg-numbers .now")?.getAttribute("cy") !== before,
      height,
    );
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.equal(width, 390);
  });
});
