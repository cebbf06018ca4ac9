// The graphics Turing test: a simulated participant, a closed tab, keys and taps, the times of a trial, and
// the analysis.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe, it } from "node:test";
import { builtPackage } from "../../scripts/package.mjs";
import { at } from "../../scripts/run.mjs";
import { answersOf } from "./answers.mjs";
import {
  bytesOf,
  barriers,
  changes,
  draws,
  drop,
  ACCESSIBLE,
  keepsNobodyOut,
  oneVisitor,
  openedSite,
  saved,
  seldom,
} from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** The same program in Node. */
const { Study, analysePerception, perceptionJson } = builtPackage();

/** @type {string[]} */
let sent = [];
const site = openedSite({ onSend: (path) => void sent.push(path) });

const bundled = readFileSync(at("www/dist/study/walks.study.json"), "utf8");

/** The study that comes with the page, with other fields, and other fields of its design. */
function studyWith(/** @type {object} */ fields, /** @type {object} */ design = {}) {
  const study = JSON.parse(bundled);
  return JSON.stringify({ ...study, ...fields, design: { ...study.design, ...design } });
}

/** So short that a test can wait for it. */
const SHORT = { seconds: 0.2, cross_seconds: 0.02 };

async function visit(/** @type {Parameters<typeof site.visit>[0]} */ options = {}, study = "") {
  const visitor = await site.visit({ settings: "view=perception", ...options });
  const { page } = visitor;
  await page.getByTestId("begin").and(page.locator(":enabled")).waitFor({ timeout: 30_000 });
  if (study) await open(page, study);
  return visitor;
}

async function open(/** @type {Page} */ page, /** @type {string} */ study) {
  const buffer = Buffer.from(study);
  await page
    .getByTestId("open-study")
    .setInputFiles({ name: "s.json", mimeType: "application/json", buffer });
  await page.getByTestId("begin").and(page.locator(":enabled")).waitFor({ timeout: 30_000 });
}

/** Passes consent and instructions. */
async function goOn(/** @type {Page} */ page, /** @type {string[]} */ ...names) {
  for (const name of names) {
    await page.getByTestId(`page-${name}`).waitFor({ timeout: 30_000 });
    await page.getByTestId("onward").and(page.locator(":enabled")).click();
  }
}

const phase = (/** @type {Page} */ page, /** @type {string} */ name) =>
  page.locator(`[data-testid=pair-trial][data-phase=${name}]`).waitFor({ timeout: 30_000 });

/** Waits until this number of trials is answered. */
const answered = (/** @type {Page} */ page, /** @type {number} */ count) =>
  page
    .getByTestId("run-progress")
    .filter({ hasText: new RegExp(`^${count} of`) })
    .waitFor({ timeout: 30_000 });

/** Rows of a CSV whose fields are all quoted, as objects. */
function rowsOf(/** @type {string} */ csv) {
  const [head = [], ...rows] = csv
    .trim()
    .split("\r\n")
    .map((line) =>
      [...line.matchAll(/"((?:[^"]|"")*)"/g)].map(([, field = ""]) => field.replaceAll('""', '"')),
    );
  return rows.map((row) => Object.fromEntries(head.map((name, i) => [name, row[i] ?? ""])));
}

/** The saved file of a figure. Chromium drops the eleventh download within a second. */
async function savedFigure(
  /** @type {Page} */ page,
  /** @type {"CSV" | "PNG"} */ kind,
  /** @type {string} */ heading,
) {
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: `${kind}: ${heading}` }).click(),
    page.waitForTimeout(120),
  ]);
  return bytesOf(download);
}

/** The rows of a figure's CSV, the titles first. */
async function figure(/** @type {Page} */ page, /** @type {string} */ heading) {
  const text = (await savedFigure(page, "CSV", heading)).toString("utf8");
  return text
    .trim()
    .split("\r\n")
    .map((line) => [...line.matchAll(/(?:^|,)("(?:[^"]|"")*"|[^,]*)/g)].map(([, field = ""]) => field));
}

seldom.describe("a study", () => {
  const visitor = oneVisitor(() => visit({ hasTouch: true, seen: true }));

  it("takes answers during the movement if the study says so, also by a tap", async () => {
    const study = studyWith({ seconds: 3 }, { answer_during_movement: true });
    const { page } = visitor;
    await open(page, study);
    await page.getByTestId("begin").click();
    await goOn(page, "consent", "instructions");
    await phase(page, "movement");
    await page.touchscreen.tap(700, 300);
    await answered(page, 1);
    await phase(page, "movement");
    await page.keyboard.press("ArrowLeft");
    await answered(page, 2);
    await page.getByTestId("run-leave").click();
    const trials = rowsOf((await saved(page, "save-csv")).text).filter(({ kind }) => kind !== "");
    assert.deepEqual(
      trials.map(({ response }) => response),
      ["right", "left"],
    );
    assert.ok(trials.every(({ lasted_ms }) => Number(lasted_ms) < 3000));
  });

  it("pauses between blocks, at least as long as the study says", async () => {
    const design = { blocks: 2, comparisons: 2, attention_checks: 0, catch_trials: 0, pause_seconds: 2 };
    const { page } = visitor;
    await open(page, studyWith(SHORT, design));
    await page.getByTestId("begin").click();
    await goOn(page, "consent", "instructions");
    await phase(page, "question");
    await page.keyboard.press("ArrowLeft");
    const since = Date.now();
    await page.getByText(/You can go on in \d s/).waitFor();
    assert.ok(await page.getByTestId("onward").isDisabled());
    await goOn(page, "pause");
    assert.ok(Date.now() - since >= 1900);
    await phase(page, "question");
    await page.keyboard.press("ArrowRight");
    await goOn(page, "end");
    await page.locator("[data-testid=participant][data-complete=true]").waitFor();
    await page.getByTestId("run").waitFor({ state: "hidden" });
  });

  it("saves its texts, its look and its attention checks", async () => {
    const { page } = visitor;
    await page.getByText("What participants read").click();
    await page.getByTestId("text-question").fill("Which one?");
    await page.getByTestId("text-question").press("Tab");
    await page.getByTestId("points").check();
    await page.getByText("Movements that check attention").click();
    const mark = page.locator(".movement-marks input:not(:checked)").first();
    const id = (await mark.getAttribute("data-testid"))?.replace("failed-", "");
    // The visitor looks at the movement first.
    await page.getByTestId(`look-${id}`).click();
    const look = page.getByTestId("look");
    await look.getByRole("heading", { name: id ?? "" }).waitFor({ timeout: 30_000 });
    // Two different pauses: a periodic movement looks the same after its period.
    const canvas = look.locator("canvas");
    await draws(canvas);
    assert.ok((await changes(canvas, 1000)) || (await changes(canvas, 700)), "it moves");
    await look.getByRole("button", { name: "Close" }).click();
    await mark.check();
    await page.locator(`[data-testid="failed-${id}"]:checked:enabled`).waitFor();
    const study = JSON.parse((await saved(page, "save-study")).text);
    assert.deepEqual([study.texts.question, study.look], ["Which one?", "points"]);
    assert.equal(study.stimuli.find((/** @type {any} */ stimulus) => stimulus.id === id).failed, true);
    await page.getByTestId("begin").click();
    await goOn(page, "consent", "instructions");
    await phase(page, "question");
    await page.getByText("Which one?").waitFor();
    await page.getByTestId("run-leave").click();
    // The time of a plan is visible before it is chosen, and the chosen plan is pressed.
    const plans = page.getByRole("group", { name: "Plan" });
    assert.match(await page.getByTestId("preset-p2").innerText(), /^P2\s+1,170 trials, \d+ min$/);
    await page.getByTestId("preset-p2").click();
    await page.getByTestId("study-words").getByText("1170 trials").waitFor();
    assert.equal(await page.getByTestId("preset-class").getAttribute("aria-pressed"), "false");
    await page.getByTestId("preset-class").click();
    await page.getByTestId("study-words").getByText("60 trials").waitFor();
    assert.deepEqual(await plans.locator("[aria-pressed=true]").allInnerTexts(), [
      await page.getByTestId("preset-class").innerText(),
    ]);
  });

  it("refuses files that are no study or no answers, and stays open", async () => {
    const { page } = visitor;
    const words = await page.getByTestId("study-words").innerText();
    await open(page, "{}");
    await page.getByTestId("study-problem").getByText("expected a study").waitFor();
    assert.equal(await page.getByTestId("study-words").innerText(), words);
    await page
      .getByTestId("open-answers")
      .setInputFiles({ name: "a.csv", mimeType: "text/csv", buffer: Buffer.from("a,b\r\n1,2\r\n") });
    await page.getByTestId("analysis-problem").getByText("a.csv").waitFor({ timeout: 30_000 });
  });
});

describe("the graphics Turing test", () => {
  it("is loaded at its first use, from the page's own folder", async () => {
    sent = [];
    const { page } = await site.visit();
    await page.waitForSelector("html[data-engine=ready]", { timeout: 30_000 });
    const ofIt = () => sent.filter((path) => path.includes("/perception/") || path.includes("/study/"));
    assert.deepEqual(ofIt(), []);
    await page.getByTestId("view-perception").click();
    await page.getByTestId("begin").and(page.locator(":enabled")).waitFor({ timeout: 30_000 });
    assert.ok(ofIt().length > 0);
    assert.match(page.url(), /view=perception/);
  });

  seldom.it("draws every figure of the papers, and saves each as numbers and as a picture", async () => {
    const { page } = await visit();
    const rows = answersOf(Study.fromJson(bundled), [1, 2, 3, 4]);
    await drop(page, { "all.json": JSON.stringify(rows) });
    await page.getByTestId("analysed").nth(3).waitFor({ timeout: 60_000, state: "attached" });
    /** A column of each figure's CSV. */
    const figures = {
      "The best of each model": "P(rate > 0.5)",
      "All models over the test error": "confusion rate",
      "Over the number of primitives or bases": "primitives or bases",
      "Confusion rate over inducing points": "dynamics inducing points",
      "Confusion rate over each score": "ln K",
      "What inducing points do": "bound (nats)",
    };
    for (const [heading, column] of Object.entries(figures)) {
      const [titles = [], ...numbers] = await figure(page, heading);
      assert.ok(titles.includes(column), `${heading}: ${titles}`);
      assert.ok(
        numbers.length > 1 && !/NaN|Infinity|undefined/.test(numbers.join()),
        `${heading}: ${numbers.join("\n")}`,
      );
      const picture = await savedFigure(page, "PNG", heading);
      assert.equal(picture.subarray(1, 4).toString("latin1"), "PNG", heading);
      assert.ok(picture.length > 5_000, `${heading}: ${picture.length} bytes`);
    }
    assert.deepEqual(await barriers(page), []);
  });

  seldom.it(
    ACCESSIBLE,
    keepsNobodyOut(
      () => visit({ hasTouch: true }, studyWith(SHORT)),
      async (page, fits) => {
        await fits("the study");
        await page.getByTestId("begin").tap();
        await page.getByTestId("page-consent").waitFor();
        await fits("consent");
        await goOn(page, "consent", "instructions");
        await phase(page, "question");
        await fits("a trial");
        await page.getByTestId("answer-left").tap();
        await answered(page, 1);
        await page.getByTestId("run-leave").tap();
      },
    ),
  );
});

seldom.describe("answers and studies of the graphics Turing test", () => {
  it("runs with a simulated participant who closes the tab half way and continues", async () => {
    const study = studyWith(SHORT, { comparisons: 12, attention_checks: 4, catch_trials: 2 });
    const { page: first, problems, leave } = await visit({}, study);
    const whole = (await saved(first, "save-study")).text;
    await first.getByTestId("participant-name").fill("robot");
    await first.getByTestId("simulate").click();
    await first
      .getByTestId("run-progress")
      .filter({ hasText: /^(9|1\d) of 18$/ })
      .waitFor({ timeout: 120_000 });
    const page = await first.context().newPage();
    page.on("pageerror", (error) => problems.push(`uncaught: ${error.message}`));
    const address = first.url();
    await first.close();

    await page.goto(address);
    const row = page.getByTestId("participant");
    await row.filter({ hasText: /robot.*simulated/s }).waitFor({ timeout: 30_000 });
    const before = Number(/(\d+) of 18/.exec(await row.innerText())?.[1]);
    assert.ok(before >= 9 && before < 18, `${before} answers were kept`);
    await page.getByTestId("resume").click();
    await page.locator("[data-testid=participant][data-complete=true]").waitFor({ timeout: 120_000 });
    const { name, text } = await saved(page, "save-csv");
    assert.equal(name, "answers-robot.csv");
    const rows = rowsOf(text);
    const trials = rows.filter(({ kind }) => kind !== "");
    assert.deepEqual(
      trials.map(({ position }) => Number(position)),
      Array.from({ length: 18 }, (_, i) => i),
      "every trial once, in its order",
    );
    assert.deepEqual(
      rows.map(({ trial_index }) => Number(trial_index)),
      rows.map((_, i) => i),
    );
    assert.deepEqual([...new Set(rows.map(({ sitting }) => sitting))], ["1", "2"]);
    assert.ok(trials.every(({ response }) => response === "left" || response === "right"));
    assert.deepEqual(
      [...new Set(rows.map(({ participant, simulated }) => `${participant} ${simulated}`))],
      ["robot true"],
    );
    const json = JSON.parse((await saved(page, "save-json")).text);
    assert.deepEqual(
      json.map((/** @type {any} */ row) => [String(row.kind ?? ""), String(row.response ?? "")]),
      rows.map(({ kind, response }) => [kind, response]),
    );

    // The trials and the analysis equal those of the package in Node.
    const node = Study.fromJson(whole);
    const { stimuli } = node.info;
    assert.deepEqual(
      node
        .trials(Number(rows[0]?.seed))
        .map(({ left, right, kind }) => [stimuli[left]?.id, stimuli[right]?.id, kind]),
      trials.map(({ left, right, kind }) => [left, right, kind]),
    );
    await page.getByTestId("analyse-here").click();
    await page.getByTestId("analysis-words").waitFor({ timeout: 60_000 });
    const files = [{ name, text }];
    assert.equal((await saved(page, "save-analysis")).text, perceptionJson(whole, files));
    const { settings, participants } = analysePerception(whole, files);
    assert.deepEqual(
      participants.map(({ name, excluded, attentionHits }) => [name, excluded, attentionHits]),
      [["robot", false, 4]],
    );
    const drawn = await figure(page, "All models over the test error");
    assert.deepEqual(
      drawn.slice(1).map((row) => row.slice(2).map(Number)),
      settings.flatMap(({ scores, confusion }) =>
        scores && confusion
          ? [[scores.mse, confusion.trials, confusion.hits, confusion.mean, confusion.deviation]]
          : [],
      ),
    );
    assert.equal(await page.getByTestId("analysed").count(), 1);
    assert.deepEqual(await barriers(page), []);

    // The same from its file, with that of another participant in JSON who fails the attention checks.
    const wrong = (/** @type {Record<string, string>} */ row) =>
      row.natural_side === "left" ? "right" : "left";
    const careless = rows.map((row) => ({
      ...{ ...row, participant: "dreamer" },
      response: row.kind === "attention" ? wrong(row) : row.response,
    }));
    const dropped = { "answers.csv": text, "dreamer.json": JSON.stringify(careless) };
    await page.reload();
    await page.getByTestId("begin").and(page.locator(":enabled")).waitFor({ timeout: 30_000 });
    await open(page, whole);
    await drop(page, dropped);
    await page.getByTestId("analysed").nth(1).waitFor({ timeout: 60_000 });
    assert.match(await page.locator(".left-out").innerText(), /dreamer.*0 of 4.*left out/s);
    assert.match(
      await page.getByTestId("analysis-words").innerText(),
      /^12 answers of 1 participant:.* 1 left out/,
    );
    assert.deepEqual(problems, []);
    await leave();
  });

  it("shows both movements for 3.5 seconds, with the measured times in the data", async (test) => {
    const { page } = await visit({ seen: true });
    await page.getByTestId("begin").click();
    await goOn(page, "consent", "instructions");
    for (const key of ["ArrowLeft", "ArrowRight"]) {
      await phase(page, "movement");
      // Too early: the question has not appeared yet.
      await page.keyboard.press(key === "ArrowLeft" ? "ArrowRight" : "ArrowLeft");
      await phase(page, "question");
      await page.keyboard.press(key);
    }
    await phase(page, "question");
    await page.getByTestId("answer-right").click();
    await answered(page, 3);
    await page.keyboard.press("Escape");
    await page.getByTestId("participant").getByText("3 of 60").waitFor();
    const trials = rowsOf((await saved(page, "save-csv")).text).filter(({ kind }) => kind !== "");
    assert.deepEqual(
      trials.map(({ response }) => response),
      ["left", "right", "right"],
    );
    const off = trials.map((trial) => {
      const [apart, lasted, frame] = [trial.started_apart_ms, trial.lasted_ms, trial.frame_ms].map(Number);
      test.diagnostic(
        `apart ${apart} ms, lasted ${lasted} ms, a frame ${frame} ms, ${trial.frames_dropped} dropped`,
      );
      assert.ok(Number(trial.rt) >= Number(lasted) - 1);
      return {
        apart: Number(apart) / Number(frame),
        late: Math.abs(Number(lasted) - 3500) / Number(frame),
      };
    });
    // The median of three trials: a shared machine may pause once.
    const middle = (/** @type {number[]} */ values) => values.sort((a, b) => a - b)[1] ?? NaN;
    assert.ok(middle(off.map(({ apart }) => apart)) <= 1, "they start within a frame of each other");
    assert.ok(middle(off.map(({ late }) => late)) <= 2, "they last 3.5 s within two frames");
  });

  it("makes a study of a comparison that ran on the page", async () => {
    const settings = "view=compare&models=dmp-rhythmic,dmp-discrete&bases=10&fps=15&steps=5";
    const { page } = await site.visit({ settings, cores: 2 });
    await page.getByTestId("compare").and(page.locator(":enabled")).waitFor({ timeout: 30_000 });
    assert.ok(await page.getByTestId("make-study").isDisabled(), "there are no movements yet");
    await page.locator(".trials summary").click();
    const boxes = page.locator(".trials input");
    for (let i = 0; i < (await boxes.count()); i++) await boxes.nth(i).setChecked(i < 3);
    await page.getByTestId("compare").click();
    await page.getByTestId("compare").waitFor({ timeout: 120_000 });
    await page.getByTestId("make-study").click();
    await page
      .getByTestId("study-words")
      .getByText("3 natural and 6 generated movements")
      .waitFor({ timeout: 60_000 });
    await page.getByTestId("begin").click();
    await goOn(page, "consent", "instructions");
    await phase(page, "movement");
  });

  it("forgets one participant, or everything, when the visitor says so", async () => {
    const { page, problems, leave } = await visit({}, studyWith(SHORT));
    page.on("dialog", (dialog) => void dialog.accept());
    for (const name of ["anna", "bert"]) {
      await page.getByTestId("participant-name").fill(name);
      await page.getByTestId("begin").click();
      await goOn(page, "consent", "instructions");
      await phase(page, "question");
      await page.keyboard.press("ArrowLeft");
      await answered(page, 1);
      await page.getByTestId("run-leave").click();
    }
    const anna = page.getByTestId("participant").filter({ hasText: "anna" });
    assert.equal(await anna.count(), 1);
    await page.getByRole("button", { name: "Forget anna" }).click();
    // The row disappears when the database has removed it.
    await anna.waitFor({ state: "detached" });
    await page.reload();
    const rows = page.getByTestId("participant");
    await rows.waitFor({ timeout: 30_000 });
    assert.match(await rows.innerText(), /bert.*1 of/s);
    await page.getByTestId("forget").click({ timeout: 30_000 });
    await page.getByTestId("confirm-yes").click();
    await rows.waitFor({ state: "detached" });
    await page.reload();
    await page.getByText("Nobody has answered on this machine yet").waitFor({ timeout: 30_000 });
    assert.deepEqual(problems, []);
    await leave();
  });
});
