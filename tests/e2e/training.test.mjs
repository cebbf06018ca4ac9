// Train, cancel, open own files, save and open models.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe, it } from "node:test";
import { Clip, Model } from "../../crate/wasm/pkg/node/vcgpdm.js";
import { at } from "../../scripts/run.mjs";
import { bvh } from "./clips.mjs";
import { LONG, draws, drop, openPanel, openedSite, ready, saved, seldom, soon } from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

const trainIsBack = (/** @type {Page} */ page) => page.getByTestId("train").waitFor({ timeout: 90_000 });
const trained = async (/** @type {Page} */ page) =>
  Model.fromJson((await saved(page, "save-model")).text).info();
const provenance = async (/** @type {Page} */ page) => (await trained(page)).provenance;

/** Records every iteration that the page shows, because a short training may end before a test can look. */
async function watchIterations(/** @type {Page} */ page) {
  await page.evaluate(() => {
    const seen = /** @type {Set<number>} */ (new Set());
    new MutationObserver(() => {
      const words = document.querySelector("[data-testid=progress]")?.textContent ?? "";
      const iteration = /Iteration (\d+)/.exec(words)?.[1];
      if (iteration) seen.add(Number(iteration));
    }).observe(document.body, { subtree: true, childList: true, characterData: true });
    Object.assign(window, { iterationsSeen: seen });
  });
  return () => page.evaluate(() => [.../** @type {any} */ (window).iterationsSeen].map(Number));
}

describe("training", () => {
  it("shows progress, and has the usual settings of the library and says why", async () => {
    const golden = JSON.parse(readFileSync(at("tests/golden/defaults.json"), "utf8"));
    const { page } = await site.visit({
      settings: `tab=learn&trainings=1&iterations=${golden.max_iterations}`,
    });
    await ready(page);
    const before = await provenance(page);
    const iterationsShown = await watchIterations(page);
    await page.getByTestId("train").click();
    await trainIsBack(page);
    const shown = await iterationsShown();
    assert.ok(
      shown.length >= 2 && shown.every((n, i) => n > (shown[i - 1] ?? -1)),
      `iterations shown: ${shown}`,
    );
    const { bound, iterations, settings } = await provenance(page);
    assert.ok(iterations >= 2 && iterations <= golden.max_iterations, `${iterations} iterations`);
    assert.notEqual(bound, before.bound, "another model");
    assert.ok(Math.abs(bound / golden.bound - 1) < 1e-9, `${bound}`);
    assert.deepEqual([settings.seed, settings.poseWeight, settings.ownRollouts], [0, "balanced", true]);
    assert.equal(await page.getByTestId("setting-dynamicsIps").inputValue(), "12");
    assert.match(
      (await page.getByTestId("why-points").textContent()) ?? "",
      /^12 points, because the longest clip has [1-7]\.\d seconds\.$/,
    );
  });

  seldom.it("does not block the page, and keeps its best model when it is cancelled", async () => {
    const { page } = await site.visit({
      moving: true,
      settings: `tab=learn&trainings=1&fps=15&${LONG}`,
    });
    await ready(page);
    const before = await provenance(page);
    const iterations = await watchIterations(page);
    await page.getByTestId("train").click();
    await page.getByRole("progressbar", { name: "Training", exact: true }).waitFor();
    // The figure moves while the model learns.
    await draws(page.getByTestId("stage"));
    await soon(async () => assert.ok(Math.max(...(await iterations())) >= 2), 60);
    await page.getByTestId("cancel").click();
    await trainIsBack(page);
    const after = await provenance(page);
    assert.notEqual(after.bound, before.bound);
    assert.ok(after.iterations >= 2 && after.iterations < 5000, `${after.iterations} iterations`);
    // Its rollout is on the stage.
    await draws(page.getByTestId("stage"));
  });
});

describe("after training", () => {
  const POOR = "tab=learn&trainings=1&seed=1&iterations=10&fps=15&latent=1&dynamics=2&poses=2";

  seldom.it("says that a model keeps one pose, and trains again with more points", async () => {
    const { page } = await site.visit({ settings: POOR });
    await ready(page);
    const health = page.getByTestId("health");
    assert.equal(await health.count(), 0, "the model that walks first keeps moving");
    await page.getByTestId("train").click();
    await trainIsBack(page);
    await health.getByText(/^The model (stands still|keeps one pose) from \d/).waitFor();
    assert.equal(await health.getByTestId("other-seeds").count(), 1);
    // Samples are a way out: the stage plays another motion of the model.
    await health.getByRole("button", { name: "Play samples" }).click();
    await page
      .getByTestId("stage-title")
      .getByText(/^Made by the model: sample \d+$/)
      .waitFor();
    await openPanel(page, "more");
    const samples = page.getByRole("button", { name: "Play samples" });
    assert.equal(await samples.last().getAttribute("aria-pressed"), "true");
    await samples.last().click();
    await page.getByTestId("stage-title").getByText("Made by the model", { exact: true }).waitFor();
    await openPanel(page, "learn");
    await health.getByTestId("more-points").click();
    await page.getByTestId("run").nth(1).waitFor();
    await trainIsBack(page);
    const { settings } = await provenance(page);
    assert.deepEqual([settings.dynamicsIps, settings.poseIps], [20, 20]);
    assert.equal(await page.getByTestId("setting-poseIps").inputValue(), "20");
    assert.match(
      (await page.getByTestId("run").first().textContent()) ?? "",
      /done, (stands still|keeps one pose) from \d/,
    );
  });

  seldom.it("continues where it stopped, for as many iterations again", async () => {
    const { page } = await site.visit({ settings: POOR });
    await ready(page);
    await page.getByTestId("train").click();
    await trainIsBack(page);
    const first = await provenance(page);
    const more = page.getByTestId("continue");
    assert.equal(await more.textContent(), "Continue, 10 more");
    // The status next to both buttons once had one word in each line.
    const width = await page.getByTestId("progress").evaluate((words) => words.getBoundingClientRect().width);
    assert.ok(width > 140, `${width} pixels for the words about the training`);
    await more.click();
    await page.getByTestId("progress").filter({ hasText: "Iteration 20 of 20." }).waitFor();
    const second = await provenance(page);
    assert.deepEqual([first.iterations, second.iterations, second.settings.maxIterations], [10, 20, 20]);
    assert.ok(second.bound > first.bound, `${first.bound} to ${second.bound}`);
    assert.equal(await page.getByTestId("run").count(), 1);
  });

  seldom.it("trains clips of other bones together, with the bones of the first", async () => {
    const { page } = await site.visit({
      settings: "tab=learn&trainings=1&iterations=10&fps=15",
    });
    await ready(page);
    const text = bvh();
    const longer = text.replace(/OFFSET .*/g, (line) =>
      line.replace(/-?\d+(\.\d+)?/g, (number) => String(1.1 * Number(number))),
    );
    await drop(page, { "mine.bvh": text, "taller.bvh": longer });
    await page.getByTestId("clash").filter({ hasText: "its offset differs" }).waitFor();
    assert.ok(await page.getByTestId("train").isDisabled());
    await page.getByTestId("first-bones").click();
    await page.getByTestId("bones").filter({ hasText: "with the bones of mine" }).waitFor();
    await page.getByTestId("train").click();
    await trainIsBack(page);
    assert.deepEqual(
      (await trained(page)).sequences.map(({ name }) => name),
      ["mine", "taller"],
    );
  });
});

describe("own files", () => {
  it("trains on the chosen frames of a dropped clip", async () => {
    const { page } = await site.visit({
      settings: "tab=learn&trainings=1&iterations=10&fps=15&dynamics=14",
    });
    await ready(page);
    const text = bvh();
    await drop(page, { "mine.bvh": text });
    await page.getByTestId("own-clips").getByText("mine").waitFor();
    await page.getByRole("button", { name: "Cut mine" }).click();
    await page.getByLabel("First frame of mine").fill("6");
    await page.getByLabel("First frame of mine").blur();
    await page.getByLabel("Last frame of mine").fill("45");
    await page.getByLabel("Last frame of mine").blur();
    await page.getByTestId("train").click();
    await trainIsBack(page);
    const mine = Clip.read("mine", new TextEncoder().encode(text));
    const frames = mine.cut(5, 45).resample(15).info().frames;
    assert.ok(frames < mine.resample(15).info().frames);
    const { sha256 } = mine.info();
    const { provenance, sequences } = await trained(page);
    assert.deepEqual([provenance.settings.framesPerSecond, provenance.settings.dynamicsIps], [15, 14]);
    assert.deepEqual(sequences, [
      { name: "mine", sha256, frames, restsFrom: null, piece: [5, 45], bonesOf: null, whole: true },
    ]);
  });

  seldom.it("keeps open rows with their clips, and the numbers of a cut", async () => {
    const { page } = await site.visit({ settings: "tab=learn" });
    await ready(page);
    // A notice for each clip with a missing row.
    const [one, other] = [bvh(0), bvh(1)].map((text) => text.replace("Frames: 60", "Frames: 61"));
    await drop(page, { "one.bvh": one ?? "", "other.bvh": other ?? "" });
    const row = (/** @type {string} */ name) =>
      page.getByTestId("own-clips").locator("li.clip", { hasText: name });
    await row("one").getByText("1 notice").click();
    await row("one").locator("details[open]").waitFor();
    await page.getByRole("button", { name: "Remove one" }).click();
    await row("one").waitFor({ state: "detached" });
    await row("other").getByText("1 notice").waitFor();
    assert.equal(await row("other").locator("details[open]").count(), 0);

    await page.getByRole("button", { name: "Cut other" }).click();
    const [first, last] = [page.getByLabel("First frame of other"), page.getByLabel("Last frame of other")];
    for (const [field, typed, holds] of /** @type {const} */ ([
      [first, "6", "6"],
      [first, "", "6"],
      [last, "", "60"],
      [last, "900", "60"],
    ])) {
      await field.fill(typed);
      await field.blur();
      assert.equal(await field.inputValue(), holds);
    }
    // Ten frames remain: the handle goes back each time.
    await page.getByRole("button", { name: "Show other" }).click();
    for (const frame of ["55", "58"]) {
      await page.getByTestId("trim-first").fill(frame);
      assert.equal(await page.getByTestId("trim-first").inputValue(), "50");
    }
  });

  it("names the wrong line of a dropped file, and loses nothing", async () => {
    const { page } = await site.visit({ settings: "tab=learn&alpha=0.1:50" });
    await ready(page);
    const [model, motion] = [await saved(page, "save-model"), await saved(page, "save-motion")];
    const clips = await page.getByTestId("made-clips").textContent();

    const lines = bvh().split("\n");
    const line = lines.findIndex((text) => text.includes("OFFSET"));
    lines[line] = "OFFSET 0 here 0";
    await drop(page, { "broken.bvh": lines.join("\n") });
    const notice = page.getByTestId("notice").filter({ hasText: "broken" });
    assert.match((await notice.textContent()) ?? "", new RegExp(`line ${line + 1}\\b`));
    await drop(page, { "no.json": '{ "format": "something else" }', "picture.png": "x" });
    await page.getByTestId("notice").filter({ hasText: "no.json" }).waitFor();
    await page.getByTestId("notice").filter({ hasText: "picture.png" }).waitFor();

    assert.equal(await page.getByTestId("own-clips").count(), 0);
    assert.equal(await page.getByTestId("made-clips").textContent(), clips);
    assert.equal((await saved(page, "save-model")).text, model.text);
    assert.equal((await saved(page, "save-motion")).text, motion.text);
  });

  seldom.it("asks for the rate of a file whose frame time is none, and for one of two bodies", async () => {
    const { page } = await site.visit({ settings: "tab=learn" });
    await ready(page);
    await drop(page, { "rate.bvh": bvh().replace(/Frame Time:.*/, "Frame Time: 30") });
    const words = page.getByTestId("assumed-rate");
    await words.waitFor();
    assert.match(
      await words.innerText(),
      /^Read at 30 frames a second.*line \d+: expected the seconds of a frame/,
    );
    await page.getByRole("spinbutton", { name: "Frames a second of rate" }).fill("60");
    await page.keyboard.press("Enter");
    await words.waitFor({ state: "detached" });

    const [tree = "", rows = ""] = bvh().split(/^MOTION\s*$/m);
    const body = (/** @type {string} */ name) => tree.replace(/HIERARCHY\s+ROOT (\w+)/, `JOINT ${name}$1`);
    const [frames, time, ...poses] = rows.trim().split("\n");
    const two = poses.map((pose) => `${pose} ${pose}`);
    const scene = [
      "HIERARCHY",
      "ROOT Scene",
      "{",
      "OFFSET 0 0 0",
      "CHANNELS 0",
      body("A"),
      body("B"),
      "}",
      "MOTION",
    ];
    await drop(page, { "two.bvh": [...scene, frames, time, ...two].join("\n") });
    const which = page.getByRole("combobox", { name: "Which body of two" });
    await page.getByRole("button", { name: "Cut two" }).click();
    await which.waitFor();
    const bodies = await which.locator("option").allTextContents();
    assert.deepEqual(bodies, ["AHips", "BHips"]);
    await which.selectOption("BHips");
    await which.and(page.locator(":enabled")).waitFor();
    assert.equal(await which.inputValue(), "BHips");
  });

  it("opens a saved model, which moves as before", async () => {
    const { page } = await site.visit({
      settings: "tab=learn&trainings=1&iterations=8&fps=15",
    });
    await ready(page);
    const [first, firstMotion] = [await saved(page, "save-model"), await saved(page, "save-motion")];
    assert.match(first.name, /\.json$/);
    assert.match(firstMotion.name, /\.bvh$/);
    assert.equal(Clip.read("saved", new TextEncoder().encode(firstMotion.text)).info().frames, 300);
    await page.getByTestId("train").click();
    await trainIsBack(page);
    assert.notEqual((await saved(page, "save-motion")).text, firstMotion.text);
    await page
      .getByTestId("open-model")
      .setInputFiles({ name: "first.json", mimeType: "application/json", buffer: Buffer.from(first.text) });
    const isBack = async () => (await saved(page, "save-model")).text === first.text;
    await soon(async () => assert.ok(await isBack(), "the first model is back"));
    assert.equal((await saved(page, "save-motion")).text, firstMotion.text);
  });
});
