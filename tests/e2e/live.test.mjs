// The live rollout: the visitor cuts a coupling while holding its arrow and drags a limb, and the figure
// moves on without a pause.
import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { barriers, choosePreset, openedSite, ready, seldom, soon } from "./site.mjs";

/** @typedef {import("playwright-core").Page} Page */

const site = openedSite();

/** The newest frame, how far the second part is ahead of the first (turns), and the number of cuts. */
async function now(/** @type {Page} */ page) {
  return page.locator("pg-live").evaluate((view) => {
    const { trace, marks } = /** @type {any} */ (view).live;
    const { frame, phases } = trace.at(-1) ?? { frame: 0, phases: [0, 0] };
    const turns = phases[1] - phases[0];
    const cuts = marks.filter((/** @type {any} */ { kind, to }) => kind === "cut" && to === null).length;
    return { frame, apart: turns - Math.round(turns), cuts };
  });
}

/** Waits until `reached` is true; returns all states until then. */
async function until(
  /** @type {Page} */ page,
  /** @type {(now: { frame: number, apart: number, cuts: number }) => boolean} */ reached,
) {
  const seen = [];
  for (let k = 0; k < 300; k++) {
    const state = await now(page);
    seen.push(state);
    if (reached(state)) return seen;
    await page.waitForTimeout(100);
  }
  assert.fail(`not reached in 30 seconds: ${JSON.stringify(seen.slice(-3))}`);
}

/** The middle of an arrow of the body map, in pixels of the page. */
const middle = (/** @type {Page} */ page, /** @type {string} */ arrow) =>
  page
    .getByTestId(arrow)
    .locator(".grip")
    .evaluate((/** @type {SVGPathElement} */ path) => {
      const at = path
        .getPointAtLength(path.getTotalLength() / 2)
        .matrixTransform(path.getScreenCTM() ?? undefined);
      return { x: at.x, y: at.y };
    });

describe("a live rollout", () => {
  it("lets the arms fall out of step while the legs' arrow is held, then back in step", async () => {
    const { page } = await site.visit({ moving: true });
    await ready(page);
    const arrow = await middle(page, "arrow-0-1");
    await page.mouse.move(arrow.x, arrow.y);
    await page.mouse.down();
    // Holding an arrow starts the live rollout.
    await page.getByTestId("live").waitFor();
    const cut = await until(page, ({ apart, cuts }) => cuts === 1 && Math.abs(apart) > 0.3);
    await page.mouse.up();
    const free = await until(page, ({ apart, cuts }) => cuts === 0 && Math.abs(apart) < 0.03);
    const frames = [...cut, ...free].map(({ frame }) => frame);
    assert.ok(
      frames.every((frame, k) => k === 0 || frame >= (frames[k - 1] ?? 0)),
      "time goes on",
    );
    // The arms are in step again and stay in step.
    const { frame } = free.at(-1) ?? { frame: 0 };
    for (const { apart } of await until(page, (now) => now.frame > frame + 60))
      assert.ok(Math.abs(apart) < 0.1);

    await page.getByTestId("live-on").click();
    await page.getByTestId("live").waitFor({ state: "detached" });
    assert.equal(await page.getByTestId("scrub").isEnabled(), true);
  });

  it("can be cut by a key, follows sliders, and a limb can be dragged", async () => {
    const { page } = await site.visit({ moving: true });
    await ready(page);
    await page.getByTestId("live-on").click();
    await page.getByTestId("live").waitFor();
    await page.getByTestId("stage").focus();
    await page.keyboard.down("c");
    await until(page, ({ cuts, apart }) => cuts === 1 && Math.abs(apart) > 0.2);
    await page.keyboard.up("c");
    await until(page, ({ cuts, apart }) => cuts === 0 && Math.abs(apart) < 0.05);

    await page.getByTestId("coupling-0-1").focus();
    await page.keyboard.press("Home");
    await until(page, ({ apart }) => Math.abs(apart) > 0.3);
    await page.keyboard.press("0");
    await until(page, ({ apart }) => Math.abs(apart) < 0.05);

    const before = await page
      .locator("pg-live")
      .evaluate((view) => /** @type {any} */ (view).live.marks.length);
    const spot = await page.getByTestId("stage").evaluate((canvas) => {
      const { left, top, width, height } = canvas.getBoundingClientRect();
      const scene = /** @type {any} */ (canvas.closest("pg-stage")).scene;
      for (let y = 0.2 * height; y < 0.7 * height; y += 6)
        for (let x = 0.3 * width; x < 0.7 * width; x += 6)
          if (scene.nodeAt(x, y, 8) !== null) return { x: left + x, y: top + y };
      return null;
    });
    assert.ok(spot, "the figure is visible");
    await page.mouse.move(spot.x, spot.y);
    await page.mouse.down();
    await page.mouse.move(spot.x + 30, spot.y - 20, { steps: 6 });
    await page.mouse.up();
    const after = await page
      .locator("pg-live")
      .evaluate((view) => /** @type {any} */ (view).live.marks.length);
    assert.ok(after > before, "the push is marked");
    const { frame } = await now(page);
    await until(page, (state) => state.frame > frame + 10);
  });

  seldom.it("cuts in the chosen reading: re-inferred arms swing on, arms as learned stop", async () => {
    const { page } = await site.visit({ moving: true });
    await ready(page);
    // Seconds of the arms' period as the library measures them in the rollout of the same couplings.
    await choosePreset(page, "arms-go");
    const arms = page.getByTestId("clock-period-1").locator("b");
    await page.locator("[data-testid=clock-periods][data-current=yes] [data-step='out of step']").waitFor();
    const alone = Number.parseFloat(await arms.innerText());
    await page.keyboard.press("0");
    await page.getByTestId("live-on").click();
    await page.getByTestId("live").waitFor();
    await page.getByTestId("stage").focus();
    await page.keyboard.down("c");
    await page.locator("[data-step='out of step']").waitFor();
    await soon(async () => {
      const live = Number.parseFloat(await arms.innerText());
      assert.ok(Math.abs(live / alone - 1) < 0.05, `live ${live} s, rollout ${alone} s`);
    });
    await page.getByTestId("reading").selectOption("as-learned");
    await page
      .locator("[data-testid=clock-period-1]", { hasText: "keeps one pose" })
      .waitFor({ timeout: 6000 });
    await page.keyboard.up("c");
    await page.locator("[data-step='in step']").waitFor();
  });

  seldom.it(
    "lets the visitor move a part by a wheel: it stands, turns and goes on when it is let go",
    async (test) => {
      const { page } = await site.visit({ moving: true, hasTouch: true });
      await ready(page);
      await page.getByTestId("live-on").click();
      const wheel = page.getByTestId("wheel");
      await wheel.waitFor();
      const newest = () =>
        page.locator("pg-live").evaluate((view) => {
          const { trace, driven } = /** @type {any} */ (view).live;
          const { frame, phases } = trace.at(-1);
          return { frame, legs: phases[0], arms: phases[1], driven };
        });
      const apart = (/** @type {number} */ a, /** @type {number} */ b) => a - b - Math.round(a - b);
      const frames = async (/** @type {number} */ count) => {
        const { frame } = await newest();
        await until(page, (state) => state.frame >= frame + count);
      };
      const box = await wheel.boundingBox();
      assert.ok(box);
      const at = (/** @type {number} */ turns) => ({
        x: box.x + box.width / 2 + 0.4 * box.width * Math.sin(2 * Math.PI * turns),
        y: box.y + box.height / 2 - 0.4 * box.width * Math.cos(2 * Math.PI * turns),
      });
      const go = (/** @type {number} */ turns) => page.mouse.move(at(turns).x, at(turns).y);
      await go(0);
      await page.mouse.down();
      await frames(5);
      const held = await newest();
      assert.equal(held.driven, 0);
      await frames(20);
      assert.ok(Math.abs(apart((await newest()).legs, held.legs)) < 0.02, "the legs stand still");
      for (let k = 1; k <= 12; k++) await go(k / 24);
      await frames(6);
      const turned = apart((await newest()).legs, held.legs);
      assert.ok(Math.abs(Math.abs(turned) - 0.5) < 0.04, `half a turn of the wheel is ${turned} turns`);
      await page.mouse.up();
      assert.equal((await newest()).driven, null);
      // The walk goes on, and the arms are in step with the legs again.
      await until(page, ({ apart }) => Math.abs(apart) < 0.05);
      await frames(8);
      const turns = await page.locator("pg-live").evaluate((view) => {
        const last = /** @type {any} */ (view).live.trace
          .slice(-8)
          .map((/** @type {any} */ at) => at.phases[0]);
        return last.map((/** @type {number} */ at, /** @type {number} */ k) =>
          k > 0 ? at - last[k - 1] : 0,
        );
      });
      assert.ok(
        turns.slice(1).every((/** @type {number} */ turn) => turn - Math.round(turn) > 0.01),
        `the legs go on: ${turns}`,
      );

      // From the move of the pointer to the picture with the first frame that obeys it.
      const waited = [];
      await go(0);
      await page.mouse.down();
      await frames(20);
      for (let k = 1; k <= 5; k++) {
        const measured = await page.evaluateHandle(() => {
          const { live, playback } = /** @type {any} */ (document.querySelector("pg-live"));
          const found = { milliseconds: 0 };
          const legs = live.trace.at(-1).phases[0];
          document.querySelector("[data-testid=wheel]")?.addEventListener(
            "pointermove",
            ({ timeStamp }) => {
              const look = () => {
                const shown = live.trace.find(
                  (/** @type {any} */ { frame }) => frame === Math.ceil(playback.frame),
                );
                const turns = Math.abs(shown?.phases[0] - legs);
                if (Math.min(turns, 1 - turns) > 0.01) found.milliseconds = performance.now() - timeStamp;
                else requestAnimationFrame(look);
              };
              requestAnimationFrame(look);
            },
            { once: true },
          );
          return found;
        });
        await go(k / 16);
        await page.waitForFunction(({ milliseconds }) => milliseconds > 0, measured);
        waited.push((await measured.jsonValue()).milliseconds);
        await frames(6);
      }
      const median = waited.toSorted((a, b) => a - b)[2] ?? 0;
      test.diagnostic(`a turn of the wheel is in the picture after ${median.toFixed(0)} ms (median of 5)`);
      await page.mouse.up();

      // Another part, by keys: it stands until the wheel is turned.
      const who = page.getByTestId("mover-1");
      await who.selectOption("you");
      assert.equal((await newest()).driven, 1);
      await wheel.focus();
      await page.keyboard.press("ArrowRight");
      await frames(3);
      const arms = await newest();
      assert.equal(arms.driven, 1);
      for (let k = 0; k < 6; k++) await page.keyboard.press("ArrowRight");
      await frames(6);
      assert.ok(Math.abs(apart((await newest()).arms, arms.arms) - 0.25) < 0.04);
      await page.keyboard.press("Escape");
      assert.equal((await newest()).driven, null);
      await page.waitForFunction(
        () => /** @type {any} */ (document.querySelector("[data-testid=mover-1]")).value === "model",
      );
      assert.deepEqual(await barriers(page), []);
    },
  );

  seldom.it("lets a recording move the legs while the sense is cut, and gives them back", async () => {
    const { page } = await site.visit({ moving: true });
    await ready(page);
    await page.getByTestId("live-on").click();
    const legs = page.getByTestId("mover-0");
    await legs.waitFor();
    // The model's own walk is the last recording.
    const own = legs.locator("optgroup option").last();
    await legs.selectOption((await own.getAttribute("value")) ?? "");
    const marks = () =>
      page
        .locator("pg-live")
        .evaluate((view) =>
          /** @type {any} */ (view).live.marks.map((/** @type {any} */ { kind, to }) => [kind, to !== null]),
        );
    await page.waitForFunction(() => {
      const stage = /** @type {any} */ (document.querySelector("pg-stage"))?.stage;
      return stage?.ghost && stage.ghostFrame !== null;
    });
    assert.deepEqual(await marks(), [["record", false]]);
    assert.match((await page.getByTestId("live").innerText()) ?? "", /A recording moves .*Outline/);
    // The recorded legs take the arms along.
    await until(page, ({ apart }) => Math.abs(apart) < 0.06);
    await page.getByTestId("stage").focus();
    await page.keyboard.down("c");
    await until(page, ({ cuts, apart }) => cuts === 1 && Math.abs(apart) > 0.3);
    assert.deepEqual(await marks(), [
      ["record", false],
      ["cut", false],
    ]);
    await page.keyboard.up("c");
    await until(page, ({ cuts, apart }) => cuts === 0 && Math.abs(apart) < 0.05);
    await legs.selectOption("model");
    assert.deepEqual(await marks(), [
      ["record", true],
      ["cut", true],
    ]);
    const { frame } = await now(page);
    await until(page, (state) => state.frame > frame + 30);
    assert.ok(Math.abs((await now(page)).apart) < 0.1, "the model walks on");
    const ghost = await page
      .locator("pg-stage")
      .evaluate((view) => /** @type {any} */ (view).stage.ghost === null);
    assert.ok(ghost, "no outline");
    assert.deepEqual(await barriers(page), []);
  });

  seldom.it("lets a hand follow the pointer while it is held, and go home afterwards", async () => {
    const { page } = await site.visit({ moving: true });
    await ready(page);
    await page.getByTestId("live-on").click();
    const arms = page.getByTestId("mover-1");
    await arms.waitFor();
    /** The place of the right hand in the picture, and how far the arms are from their loop. */
    const hand = () =>
      page.getByTestId("stage").evaluate((canvas) => {
        const { stage, scene } = /** @type {any} */ (canvas.closest("pg-stage"));
        const { left, top } = canvas.getBoundingClientRect();
        const { figure, joints } = stage.content;
        const node = figure.nodes.findIndex(
          (/** @type {any} */ { joint, endSite }) => !endSite && joints[joint] === "RightHand",
        );
        const { x, y } = scene.placeOf(node);
        const hips = scene.placeOf(0).x - x;
        const { trace } = /** @type {any} */ (document.querySelector("pg-live")).live;
        return { x: left + x, y: top + y, hips, away: trace.at(-1).distances[1] };
      });
    // The hand stands still while it is looked for.
    await page.getByTestId("play").click();
    await page.getByRole("button", { name: "Play", exact: true }).waitFor();
    const begin = await hand();
    await page.mouse.move(begin.x, begin.y);
    await page.mouse.down();
    // Towards the hips, where the hand swings in each step.
    const [x, y] = [begin.x + 40 * Math.sign(begin.hips), begin.y];
    await page.mouse.move(x, y, { steps: 4 });
    const moved = (/** @type {string} */ by) =>
      page.waitForFunction(
        (by) => /** @type {any} */ (document.querySelector("[data-testid=mover-1]")).value === by,
        by,
      );
    await moved("you");
    let nearest = Infinity;
    for (let k = 0; k < 40; k++) {
      await page.waitForTimeout(50);
      const now = await hand();
      nearest = Math.min(nearest, Math.hypot(now.x - x, now.y - y));
    }
    assert.ok(nearest < 20, `the hand comes as near as ${nearest} of 40 pixels`);
    await page.mouse.up();
    await moved("model");
    for (let k = 0; (await hand()).away > 0.2; k++) {
      assert.ok(k < 100, "the arms come home");
      await page.waitForTimeout(100);
    }
  });

  seldom.it("can be pushed at the dots of the latent plots by mouse, finger and keys", async () => {
    const { page } = await site.visit({ hasTouch: true });
    await ready(page);
    await page.getByTestId("live-on").click();
    await page.getByTestId("live").waitFor();
    /**
     * The largest distance of a part from its cycle after the newest push; 0: the part was not pushed.
     */
    const farthest = (/** @type {number} */ part) =>
      page.locator("pg-live").evaluate((view, part) => {
        const { marks, trace } = /** @type {any} */ (view).live;
        const push = marks.findLast((/** @type {any} */ mark) => mark.kind === "push" && mark.part === part);
        const felt = trace.filter((/** @type {any} */ { frame }) => push && frame >= push.from - 10);
        return Math.max(0, ...felt.map((/** @type {any} */ { distances }) => distances[part]));
      }, part);
    const gone = async (/** @type {number} */ part) => {
      const seen = [];
      for (let k = 0; k < 100; k++) {
        const distance = await farthest(part);
        if (distance > 0.1) return;
        seen.push(distance);
        await page.waitForTimeout(50);
      }
      assert.fail(`part ${part} was not pushed: ${Math.max(...seen)}`);
    };
    /** The middle of a dot that no longer moves: some pictures after the clock has stopped. */
    const middleOf = async (/** @type {number} */ part) => {
      const dot = page.getByTestId(`push-${part}`);
      let last;
      for (let same = 0; same < 3; await page.waitForTimeout(100)) {
        const box = await dot.boundingBox();
        same = box && box.x === last?.x && box.y === last.y ? same + 1 : 0;
        last = box;
      }
      return last ? { x: last.x + last.width / 2, y: last.y + last.height / 2 } : assert.fail();
    };
    /** Pixels from a dot away from the middle of its plot, and so from the cycle. */
    const outwards = async (/** @type {number} */ part) => {
      const plot = await page.getByTestId(`latent-${part}`).boundingBox();
      const dot = await middleOf(part);
      if (!plot) return assert.fail();
      const [dx, dy] = [dot.x - plot.x - plot.width / 2, dot.y - plot.y - plot.height / 2];
      return [(80 * dx) / Math.hypot(dx, dy), (80 * dy) / Math.hypot(dx, dy)];
    };
    // While the clock stands, a dot does not move away, and a slow machine adds up the steps of one push.
    const play = page.getByTestId("play");
    const stopClock = async () => {
      await play.click();
      await page.getByRole("button", { name: "Play", exact: true }).waitFor();
    };

    const dot = page.getByRole("button", {
      name: "State of legs now. Drag it, or use the arrow keys, to push this part.",
    });
    await stopClock();
    await dot.focus();
    const [right = 0, down = 0] = await outwards(0);
    const [horizontal, vertical] = [
      right < 0 ? "ArrowLeft" : "ArrowRight",
      down < 0 ? "ArrowUp" : "ArrowDown",
    ];
    const key = Math.abs(right) > Math.abs(down) ? horizontal : vertical;
    for (let k = 0; k < 12; k++) await page.keyboard.press(key);
    await play.click();
    await gone(0);

    await stopClock();
    const { x, y } = await middleOf(1);
    const [dx = 0, dy = 0] = await outwards(1);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + dx, y + dy, { steps: 5 });
    await page.mouse.up();
    await play.click();
    await gone(1);

    const cdp = await page.context().newCDPSession(page);
    const touch = async (
      /** @type {string} */ type,
      /** @type {{ x: number, y: number }[]} */ ...touchPoints
    ) => cdp.send("Input.dispatchTouchEvent", { type: /** @type {any} */ (type), touchPoints });
    const pushes = () =>
      page.locator("pg-live").evaluate((view) => /** @type {any} */ (view).live.marks.length);
    const before = await pushes();
    await stopClock();
    const start = await middleOf(0);
    await touch("touchStart", start);
    for (let k = 1; k <= 5; k++) await touch("touchMove", { x: start.x, y: start.y + 12 * k });
    await touch("touchEnd");
    assert.ok((await pushes()) > before, "a finger pushes too");

    await page.getByTestId("live-on").click();
    await page.getByTestId("push-0").waitFor({ state: "detached" });
  });
});
