// The story's borrowed arms: a guess, and numbers that are those of the library.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, it } from "node:test";
import { Library } from "../../crate/wasm/pkg/node/vcgpdm.js";
import { at } from "../../scripts/run.mjs";
import { barriers, openSite } from "./site.mjs";

/** @type {Awaited<ReturnType<typeof openSite>>} */
let site;
before(async () => {
  site = await openSite();
});
after(() => site?.close());

/** Centimetres between the hands and the hips in the first 120 frames, on average. */
function handHeight(/** @type {number[]} */ uses) {
  const library = Library.fromJson(readFileSync(at("www/first/library.json"), "utf8"));
  const { joints, figure } = library.info();
  const hands = ["LeftHand", "RightHand"].map((name) =>
    figure.nodes.findIndex(({ joint, endSite }) => joints[joint]?.name === name && !endSite),
  );
  const rollout = library.combination(uses).rollout({ frames: 120, sequence: 0 });
  const positions = rollout.positions();
  const heights = hands.flatMap((hand) =>
    Array.from({ length: 120 }, (_, frame) => {
      const start = 3 * frame * figure.nodes.length;
      return (positions[start + 3 * hand + 1] ?? 0) - (positions[start + 1] ?? 0);
    }),
  );
  return (100 * heights.reduce((sum, height) => sum + height, 0)) / heights.length;
}

it("puts the arms of the jumping jack on the legs of the walk after the guess, and measures them", async () => {
  const { page, problems, leave } = await site.visit({ settings: "story=8" });
  await page.locator(".story[data-state=open]").waitFor();
  assert.equal(await page.getByTestId("borrow-0-0").count(), 0, "nothing to choose before the guess");
  await page.getByTestId("choice-own").click();
  const borrowed = page.getByTestId("borrowed");
  await borrowed.waitFor({ timeout: 60_000 });
  await page.getByText("with their own legs").waitFor({ timeout: 60_000 });
  const text = await borrowed.innerText();
  assert.match(text, /^Never recorded\. The arms do their own movement\./);
  const above = [...text.matchAll(/(\d+) cm above the hips/g)].map(([, value]) => Number(value));
  assert.deepEqual(above, [Math.round(handHeight([0, 5])), Math.round(handHeight([1, 5]))]);
  assert.deepEqual(await barriers(page), []);
  await page.getByTestId("borrow-0-1").click();
  await page.getByText("Learned as a whole: jumping jack.").waitFor();
  assert.match(await borrowed.innerText(), /The feet stay in their place\.$/);
  await page.getByTestId("borrow-0-2").click();
  await page.getByText("The arms do their own movement.").waitFor();
  await page.getByTestId("borrow-1-6").click();
  await page.getByText("Learned as a whole: run.").waitFor();
  assert.deepEqual(problems, []);
  await leave();
});
