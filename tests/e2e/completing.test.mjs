// A recording moves one part in the Lab, and the model infers the other: until the observation ends.
import assert from "node:assert/strict";
import { after, before, it } from "node:test";
import { openSite, ready } from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Awaited<ReturnType<typeof openSite>>} */
let site;
before(async () => {
  site = await openSite();
});
after(() => site?.close());

/** The numbers in the text of a part's error. */
const numbersOf = async (/** @type {Page} */ page, /** @type {number} */ part) => {
  const text = (await page.getByTestId(`completed-${part}`).textContent()) ?? "";
  return (text.match(/\d+\.\d+/g) ?? []).map(Number);
};

it("a recording gives the legs, the model infers the arms, and goes on by itself afterwards", async () => {
  const { page, problems, leave } = await site.visit({ settings: "tab=more" });
  await ready(page);
  const panel = page.getByTestId("completing");
  await panel.locator("summary").click();
  await page.getByTestId("complete").click();
  await page.getByTestId("completed-1").waitFor();
  const [whole = NaN, ...none] = await numbersOf(page, 1);
  assert.ok(whole > 0 && whole < 0.5, `the arms of a walk from its legs: ${whole}`);
  assert.equal(none.length, 0);
  assert.match((await page.getByTestId("stage-title").textContent()) ?? "", /One part recorded/);
  const motions = () =>
    page.locator("pg-stage").evaluate((view) => {
      const { content, ghost } = /** @type {any} */ (view).stage;
      return { kind: content.kind, figure: [...content.motion.positions], outline: [...ghost.positions] };
    });
  const seen = await motions();
  assert.equal(seen.kind, "completed");
  assert.equal(seen.figure.length, seen.outline.length);
  const apart = seen.figure.map((x, k) => Math.abs(x - (seen.outline[k] ?? 0)));
  assert.ok(Math.max(...apart) > 0.01, "the inferred arms are not the recorded ones");

  // With the keyboard: the observation ends earlier, and the arms' error afterwards is another number.
  const until = page.getByTestId("completing-until");
  await until.focus();
  await page.keyboard.press("Home");
  await page.waitForFunction(() =>
    /afterwards/.test(document.querySelector("[data-testid=completed-1]")?.textContent ?? ""),
  );
  assert.equal((await numbersOf(page, 1)).length, 2);

  // The arms give, the legs are inferred.
  await page.getByTestId("given-1").click();
  await page.getByTestId("completed-0").waitFor();

  // Other couplings complete the recording again, and the model's own motion is one press away.
  await page.getByTestId("complete").click();
  await page.waitForFunction(
    () => /** @type {any} */ (document.querySelector("pg-stage")).stage.content.kind === "model",
  );
  assert.equal(await page.getByTestId("completed-0").count(), 0);
  assert.deepEqual(problems, []);
  await leave();
});
