// The story's riddle with a known truth: vote, train, draw the curtain.
import assert from "node:assert/strict";
import { after, before, it } from "node:test";
import { SyntheticExperiment } from "../../crate/wasm/pkg/node/vcgpdm.js";
import { barriers, openSite } from "./site.mjs";

/** @type {Awaited<ReturnType<typeof openSite>>} */
let site;
before(async () => {
  site = await openSite();
});
after(() => site?.close());

it("reveals what the library finds, has each answer once in three rounds, and gives no truth away before", async () => {
  const { page, problems, leave } = await site.visit({ settings: "story=9" });
  await page.locator(".story[data-state=open]").waitFor();
  /** @type {(string | null)[]} */
  const truths = [];
  for (let round = 1; round <= 3; round++) {
    assert.equal(await page.getByTestId("truth-row").getAttribute("data-answer"), "", "behind the curtain");
    await page.getByTestId("choice-ab").click();
    const belief = page.getByTestId("belief");
    await belief.waitFor({ timeout: 120_000 });
    assert.doesNotMatch((await page.getByTestId("open-in-lab").getAttribute("href")) ?? "", /draw/);
    const { experiment, isMirrored } = await page.evaluate(
      () => /** @type {any} */ (document.querySelector("pg-belief")).chapter.round,
    );
    const text = (await belief.innerText()).replaceAll(",", "");
    const [, ab, ba] = text.match(/to B is ([\d.]+) times .* to A ([\d.]+) times/) ?? [];
    if (round === 1) {
      const same = new SyntheticExperiment(experiment.seed, experiment.driving);
      while (!same.step().done);
      const { forth, back } = same.findings().verdict;
      same.free();
      const wanted = isMirrored ? [back, forth] : [forth, back];
      const text = wanted.map((value) => value.toFixed(value < 10 ? 1 : 0));
      assert.deepEqual([ab, ba], text, "the numbers are those of the library");
    }
    await page.getByTestId("curtain").click();
    const truth = await page.getByTestId("truth").getAttribute("data-truth");
    truths.push(truth);
    assert.equal(await page.getByTestId("truth-row").getAttribute("data-answer"), truth);
    assert.match(await page.getByTestId("truth").innerText(), new RegExp(`you [01] of ${round}, the model`));
    if (round === 1) {
      // What couplings are worth on recordings, with the equations.
      await page.locator(".story-more summary").click();
      assert.match(
        await page.getByTestId("worth").innerText(),
        /without couplings has 1\.99 times.*1\.82 times.*six persons.*1\.07 times.*: undecided/s,
      );
      assert.deepEqual(await barriers(page), []);
      await page.locator(".story-more summary").click();
    }
    await page.getByTestId("another-pair").click();
  }
  assert.deepEqual(truths.sort(), ["ab", "ba", "none"]);
  assert.deepEqual(problems, []);
  await leave();
});
