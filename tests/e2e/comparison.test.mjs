// A comparison of models on the page: carried out, cancelled, shown, saved and opened again.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { barriers, bytesOf, draws, openedSite, pictures, ready, saved, seldom } from "./site.mjs";

/** Small enough for a test: three trials at 15 frames a second, few iterations. */
const SMALL = "view=compare&models=vcgpdm,vgpdm,dmp-discrete,dmp-rhythmic&ips=6&fps=15&latent=2&steps=15";

/** @type {string[]} */
let sent = [];
const site = openedSite({
  onSend: (path) => {
    sent.push(path);
  },
});

/** Waits for the end of a comparison and returns its last sentence. */
async function over(/** @type {import("playwright-core").Page} */ page) {
  await page.getByTestId("compare").waitFor({ timeout: 120_000 });
  return page.getByTestId("compare-progress").innerText();
}

/** Waits for this status next to the button. */
async function says(/** @type {import("playwright-core").Page} */ page, /** @type {RegExp} */ words) {
  await page.getByTestId("compare-progress").filter({ hasText: words }).waitFor({ timeout: 30_000 });
}

/** Leaves this number of trials ticked. */
async function tick(/** @type {import("playwright-core").Page} */ page, /** @type {number} */ count) {
  await page.locator(".trials summary").click();
  const boxes = page.locator(".trials input");
  for (let i = 0; i < (await boxes.count()); i++) await boxes.nth(i).setChecked(i < count);
}

describe("a comparison of models", () => {
  it("is loaded at its first use", async () => {
    sent = [];
    const { page } = await site.visit({ moving: true });
    await ready(page);
    const later = () => sent.filter((path) => path.includes("on-demand"));
    assert.ok(sent.some((path) => path.endsWith(".wasm")));
    assert.deepEqual(later(), []);
    await page.getByTestId("view-compare").click();
    await page.getByTestId("compare").waitFor();
    assert.ok(later().length > 0);
    assert.match(page.url(), /view=compare/);
    await page.getByTestId("view-play").click();
    // The figure walks on.
    await draws(page.getByTestId("stage"));
  });

  it("holds out each trial in turn and shows tables and figures, which files repeat", async () => {
    const { page, problems, leave } = await site.visit({ settings: SMALL, cores: 2 });
    await page.getByTestId("compare").and(page.locator(":enabled")).waitFor({ timeout: 30_000 });
    await tick(page, 3);
    await page.getByTestId("compare").click();
    assert.match(await over(page), /12 of 12 trainings done/);
    const table = page.locator("comparison-figures table").first();
    for (const name of ["vCGPDM", "vGPDM", "DMP (discrete)", "DMP (rhythmic)"])
      await table.getByText(name, { exact: true }).first().waitFor();

    const { text } = await saved(page, "save-results");
    const results = JSON.parse(text);
    assert.equal(results.finished.length, 12);
    assert.ok(
      results.finished.every(
        (/** @type {any} */ f) => f.outcome.score.dtw_mse > 0 && f.outcome.score.dtw_mse < 1,
      ),
    );
    assert.equal(new Set(results.finished.map((/** @type {any} */ f) => f.job.held_out)).size, 3);

    // Nothing is computed twice.
    await page.getByTestId("compare").click();
    assert.match(await over(page), /finished before/);

    // Another visitor opens the file: the same table, without motions.
    const other = await site.visit({ settings: "view=compare" });
    await other.page.getByTestId("compare").and(other.page.locator(":enabled")).waitFor({ timeout: 30_000 });
    await other.page
      .getByTestId("open-results")
      .setInputFiles({ name: "r.json", mimeType: "application/json", buffer: Buffer.from(text) });
    await other.page
      .getByTestId("compare-progress")
      .getByText("12 results opened")
      .waitFor({ timeout: 30_000 });
    const there = other.page.locator("comparison-figures table").first();
    await there.waitFor();
    assert.equal(await there.innerText(), await table.innerText());
    await other.page
      .getByTestId("open-results")
      .setInputFiles({ name: "x.json", mimeType: "application/json", buffer: Buffer.from("{}") });
    await other.page.getByText("expected the results of an evaluation").waitFor();
    assert.equal(await there.innerText(), await table.innerText(), "what was open stays");
    // With the same trials and settings only the first trial's models are trained, for their motions.
    await other.page.evaluate((hash) => {
      location.hash = hash;
    }, SMALL);
    await tick(other.page, 3);
    await other.page.getByTestId("compare").click();
    assert.match(await over(other.page), /4 of 4 trainings done/);
    assert.equal(JSON.parse((await saved(other.page, "save-results")).text).finished.length, 12);
    assert.equal(await other.page.locator(".column-heads li").count(), 4);
    // Passing a bottle comes when asked for: ten clips in three parts, and what was found with them.
    await other.page.getByTestId("bottle").click();
    await other.page.getByTestId("bottle-found").waitFor({ timeout: 30_000 });
    assert.equal(await other.page.locator(".trials input:checked").count(), 10);
    await other.page.getByTestId("bottle-watch").click();
    await other.page.getByTestId("stage-title").getByText("Pass a bottle, trial 1").waitFor();
    assert.match(await other.page.locator(".stage-legend").innerText(), /body\s+left arm\s+right arm/);
    assert.deepEqual([...problems, ...other.problems], []);
    await other.leave();
    await leave();
  });

  seldom.it(
    "opens with the results of all models on ten recorded walks, until there are others",
    async () => {
      const settings = "view=compare&models=dmp-rhythmic&bases=10&fps=15&heldout=1";
      const { page } = await site.visit({ settings, cores: 2 });
      await page.getByTestId("given").getByText("ten recorded walks").waitFor({ timeout: 30_000 });
      assert.equal(await page.locator(".column-heads li").count(), 4, "four models walk");
      assert.equal(await page.getByTestId("to-stage").count(), 0, "their models did not come along");
      const table = page.locator("comparison-figures table").first();
      await table.waitFor({ timeout: 30_000 });
      for (const name of [
        "vCGPDM",
        "vGPDM",
        "MAP GPDM",
        "MAP CGPDM",
        "TMP",
        "DMP (discrete)",
        "DMP (rhythmic)",
        "ProMP",
        "AR",
      ]) {
        await table.getByText(name, { exact: true }).first().waitFor();
      }
      await page.getByText("rank correlation −").first().waitFor();
      await page
        .getByText(/exponent \d/)
        .first()
        .waitFor();
      // One size of each model and variant represents the others, until the visitor asks for all.
      const sizes = await table.locator("tbody tr").count();
      assert.ok(sizes >= 9 && sizes <= 15, `${sizes} rows`);
      await table
        .getByText(/inducing points \(of 16 settings\)/)
        .first()
        .waitFor();
      await table
        .getByText(/^lower\s0\.\d+, upper\s0\.\d+$/)
        .first()
        .waitFor();
      const more = page.getByRole("button", { name: /^All \d+ settings$/ });
      const all = Number((await more.innerText()).match(/\d+/)?.[0]);
      await more.click();
      assert.equal(await table.locator("tbody tr").count(), all);
      assert.ok(all > 3 * sizes, `${all} rows of ${sizes} models`);
      await page.getByRole("button", { name: "One size of each model" }).click();
      assert.equal(await table.locator("tbody tr").count(), sizes);
      assert.deepEqual(await barriers(page), []);
      await page.setViewportSize({ width: 390, height: 844 });
      assert.deepEqual(await barriers(page), [], "on a telephone");
      // The answer is next to the claim, and neither is cut off.
      const claim = page.locator("comparison-claims tbody tr").first();
      const [claimBox, answer] = [
        await claim.locator("th").boundingBox(),
        await claim.locator(".holds").boundingBox(),
      ];
      assert.ok(
        claimBox && answer && Math.abs(claimBox.y - answer.y) < 10 && answer.x + answer.width <= 390,
        "claim and answer",
      );
      await page.setViewportSize({ width: 1440, height: 900 });
      await says(page, /^1 training\./);
      await page.getByTestId("compare").click();
      assert.match(await over(page), /1 of 1 trainings done/);
      assert.equal(await page.getByTestId("given").count(), 0);
      assert.equal(await table.getByText("vCGPDM", { exact: true }).count(), 0);
      // These results come back at a press; the page asks about the comparison that was made here.
      await page.getByTestId("open-walks").click();
      await page.getByTestId("unsaved-discard").click();
      await table.getByText("vCGPDM", { exact: true }).first().waitFor();
    },
  );

  seldom.it("plays up to four models side by side under one clock", async () => {
    const { page } = await site.visit({
      settings: `${SMALL}&heldout=2`,
      cores: 2,
      moving: true,
    });
    await page.getByTestId("compare").and(page.locator(":enabled")).waitFor({ timeout: 30_000 });
    await tick(page, 2);
    await page.getByTestId("compare").click();
    await over(page);
    const stage = page.getByTestId("compare-stage");
    await stage.scrollIntoViewIfNeeded();
    assert.equal(await page.locator(".column-heads li").count(), 4);
    await draws(page.locator(".columns canvas"));
    await page.getByTestId("compare-play").click();
    await page
      .getByTestId("compare-play")
      .and(page.getByRole("button", { name: "Play" }))
      .waitFor();
    // The last picture may be drawn once more, finer.
    await page.waitForTimeout(500);
    const paused = await pictures(stage);
    await page.waitForTimeout(500);
    assert.equal(await pictures(stage), paused, "Pause stops all");
    await page.keyboard.press("ArrowRight");
    const frame = await page.getByTestId("compare-scrub").inputValue();
    await page.keyboard.press("ArrowRight");
    assert.notEqual(await page.getByTestId("compare-scrub").inputValue(), frame);
    await page.locator(".picks .chip[aria-pressed=true]").last().click();
    assert.equal(await page.locator(".column-heads li").count(), 3);
    assert.deepEqual(await barriers(page), []);
  });

  seldom.it("puts the models of a trial on the stage, where they are saved", async () => {
    const settings = "view=compare&models=vcgpdm,vgpdm,tmp&ips=5&fps=15&latent=2&steps=8&heldout=2";
    const { page } = await site.visit({ settings, cores: 2 });
    await page.getByTestId("compare").and(page.locator(":enabled")).waitFor({ timeout: 30_000 });
    await tick(page, 2);
    await page.getByTestId("compare").click();
    assert.match(await over(page), /3 of 3 trainings done/);
    const toStage = (/** @type {string} */ model) =>
      page.getByRole("button", { name: new RegExp(`^Put on the stage: ${model}`) }).click();
    const title = page.getByTestId("stage-title");
    /** The model that the Lab saves. */
    const onStage = async () => JSON.parse((await saved(page, "save-model")).text);

    await toStage("TMP");
    await title.getByText("Made by a TMP", { exact: true }).waitFor({ timeout: 30_000 });
    const tmp = await saved(page, "save-model");
    assert.match(tmp.name, /^tmp-without-.*\.model\.json$/);
    assert.equal(JSON.parse(tmp.text).kind, "tmp");
    await page.getByTestId("view-compare").click();
    await toStage("vCGPDM");
    await title.getByText("Made by a TMP").waitFor({ state: "detached", timeout: 30_000 });
    await page.getByTestId("view-compare").click();
    // The vCGPDM is on no disk yet, so the page asks before another model takes its place.
    await toStage("vGPDM");
    await page.getByTestId("unsaved-keep").click();
    await page.getByTestId("view-play").click();
    const coupled = await onStage();
    assert.equal(coupled.parts.length, 2);
    assert.deepEqual(
      coupled.sequences.map((/** @type {any} */ sequence) => sequence.whole ?? true),
      [true, false],
      "the last sequence is the beginning of the trial held out",
    );
    await page.getByTestId("view-compare").click();
    await toStage("vGPDM");
    await page.getByTestId("stage").waitFor();
    assert.equal((await onStage()).parts.length, 1);
  });

  seldom.it("keeps results under other settings, and the stage moves after each comparison", async () => {
    const settings = "view=compare&models=vgpdm,dmp-rhythmic&ips=5&fps=15&latent=2&steps=5&heldout=1";
    const { page } = await site.visit({ settings, cores: 2, moving: true });
    await page.getByTestId("compare").and(page.locator(":enabled")).waitFor({ timeout: 30_000 });
    await tick(page, 2);
    const compare = async () => {
      await page.getByTestId("compare").click();
      await over(page);
    };
    await compare();
    await draws(page.locator(".columns canvas"));
    await page.locator("pg-comparison .advanced summary").click();
    const rate = page.getByTestId("compare-framesPerSecond");
    await rate.fill("10");
    await rate.press("Tab");
    await says(page, /2 trainings\..*a comparison of its own/s);
    await compare();
    await draws(page.locator(".columns canvas"));
    await rate.fill("15");
    await rate.press("Tab");
    await compare();
    assert.match(await page.getByTestId("compare-progress").innerText(), /finished before/);
    await draws(page.locator(".columns canvas"));
  });

  seldom.it("saves every figure as numbers and as a picture", async () => {
    const settings =
      "view=compare&models=vcgpdm,vgpdm,map-cgpdm&ips=4,5,6&growth=1&heldout=1&steps=4&fps=10&latent=2";
    const { page } = await site.visit({ settings, cores: 2 });
    await page.getByTestId("compare").and(page.locator(":enabled")).waitFor({ timeout: 30_000 });
    await tick(page, 4);
    await page.getByTestId("compare").click();
    assert.match(await over(page), /11 of 11 trainings done/);
    /** The beginning of each figure's CSV. */
    const figures = {
      "Distance from the real trial": /^trial,time \(s\),"vCGPDM, 4 \+ 4 inducing points \(cm\)"/,
      "Error, bound, time and size of each model": /^model,settings,/,
      "Error against bound": /^model,/,
      "Learning time against frames": /^model,frames,time of an iteration \(s\)/,
      "What the papers say": /./,
    };
    for (const [figure, head] of Object.entries(figures)) {
      for (const kind of ["CSV", "PNG"]) {
        const button = page.getByRole("button", { name: `${kind}: ${figure}` });
        const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
        const content = await bytesOf(download);
        assert.match(download.suggestedFilename(), kind === "CSV" ? /\.csv$/ : /\.png$/);
        if (kind === "CSV") {
          const [first, ...rows] = content
            .toString("utf8")
            .replace(/^\ufeff/, "")
            .trim()
            .split("\r\n");
          assert.match(first ?? "", head, figure);
          assert.ok(
            rows.length > 0 && rows.every((row) => !/NaN|Infinity|undefined/.test(row)),
            `${figure}: ${rows.join("\n")}`,
          );
        } else {
          assert.equal(content.subarray(1, 4).toString("latin1"), "PNG", figure);
          assert.ok(content.length > 5_000, `${figure}: ${content.length} bytes`);
        }
      }
    }
  });

  seldom.it("can be cancelled, keeps finished trainings, and continues from there", async () => {
    const settings = "view=compare&models=dmp-rhythmic,map-cgpdm&fps=15&steps=5000";
    const { page } = await site.visit({ settings, cores: 1 });
    await page.getByTestId("compare").and(page.locator(":enabled")).waitFor({ timeout: 30_000 });
    await tick(page, 2);
    // Only the quick model first.
    await page.getByTestId("model-map-cgpdm").uncheck();
    await page.getByTestId("compare").click();
    assert.match(await over(page), /2 of 2 trainings done/);
    await page.getByTestId("model-map-cgpdm").check();
    await page.getByTestId("compare").click();
    await page.getByText("0 of 2 trainings done").waitFor();
    await page.getByTestId("compare-cancel").click();
    assert.match(await over(page), /cancelled/);
    const results = JSON.parse((await saved(page, "save-results")).text);
    assert.deepEqual(
      results.finished.map((/** @type {any} */ f) => f.job.candidate.model),
      ["dmp-rhythmic", "dmp-rhythmic"],
    );
    // A quicker model instead: finished trainings are not repeated.
    await page.getByTestId("model-map-cgpdm").uncheck();
    await page.getByTestId("model-dmp-discrete").check();
    await says(page, /2 trainings, 2 finished before/);
    await page.getByTestId("compare").click();
    assert.match(await over(page), /2 of 2 trainings done/);
  });
});
