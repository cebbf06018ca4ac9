// The view Which is natural? for a class: its riddle, and answers as codes, which give the same results pasted.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { it } from "node:test";
import { at } from "../../scripts/run.mjs";
import { barriers, changes, draws, openedSite, seldom } from "./site.mjs";

const site = openedSite();

/** A study so short that a test can wait for it. */
function shortStudy() {
  const study = JSON.parse(readFileSync(at("www/dist/study/walks.study.json"), "utf8"));
  const design = { ...study.design, comparisons: 6, attention_checks: 2, catch_trials: 1 };
  return JSON.stringify({ ...study, seconds: 0.2, cross_seconds: 0.02, design });
}

seldom.it("gives each participant a code, and analyses pasted codes as it does the answers", async () => {
  const { page } = await site.visit({ settings: "view=perception" });
  const begin = page.getByTestId("begin").and(page.locator(":enabled"));
  await begin.waitFor({ timeout: 30_000 });
  const study = { name: "s.json", mimeType: "application/json", buffer: Buffer.from(shortStudy()) };
  await page.getByTestId("open-study").setInputFiles(study);
  await page.getByText("9 trials").first().waitFor();
  await begin.waitFor();
  for (const _ of [1, 2]) {
    await page.getByTestId("simulate").and(page.locator(":enabled")).click();
    await page.getByTestId("run-progress").waitFor();
    await page.getByTestId("run-progress").waitFor({ state: "hidden", timeout: 120_000 });
  }
  const codes = await page.getByTestId("class-code").allInnerTexts();
  assert.equal(new Set(codes).size, 2);
  await page.getByTestId("analyse-here").click();
  const words = page.getByTestId("analysis-words");
  await words.waitFor({ timeout: 60_000 });
  const found = await words.innerText();

  await page.reload();
  await begin.waitFor({ timeout: 30_000 });
  await page.getByTestId("open-study").setInputFiles(study);
  await page.getByText("9 trials").first().waitFor();
  await begin.waitFor();
  await page.getByText("Codes of a class").click();
  const [first = "", second = ""] = codes;
  await page.getByTestId("codes").fill(`${first}\n${second.toUpperCase()}\n${first}\n`);
  await page.getByTestId("add-codes").click();
  await words.waitFor({ timeout: 60_000 });
  assert.equal(await words.innerText(), found);
  assert.deepEqual(await barriers(page), []);
  await page.getByTestId("codes").fill(`${first}\n${second.slice(0, -3)}\n`);
  await page.getByTestId("add-codes").click();
  await page.getByText(/Line 2: expected a whole code/).waitFor();
});

it("begins with a riddle, which counts in no study", async () => {
  const { page } = await site.visit({
    settings: "view=perception",
    moving: true,
    seen: true,
  });
  await page.getByTestId("riddle-left").waitFor({ timeout: 30_000 });
  await draws(page.locator(".riddle canvas"));
  assert.ok(await changes(page.getByTestId("riddle")), "the walkers move");
  await page.getByTestId("riddle-left").click();
  assert.match(await page.getByTestId("riddle-answer").innerText(), /^(Yes|No).+ You found [01] of 1\./);
  assert.match(await page.locator(".riddle .look-sides").innerText(), /Natural|Generated/);
  await page.getByTestId("riddle-next").click();
  await page.getByTestId("riddle").click({ position: { x: 10, y: 10 } });
  assert.match(await page.getByTestId("riddle-answer").innerText(), /of 2\./);
  assert.equal(await page.getByTestId("participant").count(), 0);
  // Answers to a study of other walks are told to nobody.
  const buffer = Buffer.from(shortStudy().replaceAll("(made by this project)", ""));
  await page
    .getByTestId("open-study")
    .setInputFiles({ name: "s.json", mimeType: "application/json", buffer });
  await page.locator(".riddle").waitFor({ state: "detached" });
});
