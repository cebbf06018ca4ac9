// `vcgpdm/figure` on a bare page, without a bundler: the lines of the README of the npm package.
import assert from "node:assert/strict";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe } from "node:test";
import { launchChromium } from "../../scripts/chromium.mjs";
import { at } from "../../scripts/run.mjs";
import { serve } from "../../scripts/serve.mjs";
import { soon, seldom } from "./site.mjs";

const [show = "", change = ""] = [
  ...readFileSync(at("crate/wasm/README.md"), "utf8").matchAll(/^```js\n([\s\S]*?)^```/gm),
]
  .map(([, code = ""]) => code)
  .filter((code) => /\b[fF]igure\./.test(code));

const imports = Object.fromEntries(
  ["player/vcgpdm", "inline/vcgpdm", "figure/figure"].map((file) => [
    `vcgpdm/${file.split("/")[0]}`,
    `/${file}.js`,
  ]),
);
const bare = (/** @type {string} */ script, style = "") => `<!doctype html><meta charset="utf-8">
<title>A figure</title><link rel="icon" href="data:,"><style>${style}</style>
<script type="importmap">${JSON.stringify({ imports })}</script>
<p>A page.</p><canvas></canvas>
<script type="module">${script}</script>
`;
/** Makes `figure` and `model` visible for the tests. */
const SHOWN = "\nObject.assign(window, { Figure, Model, figure, model });\n";
const KINDS = ["vcgpdm", "combination", "map-cgpdm", "tmp", "dmp-discrete", "dmp-rhythmic", "series"];

const folder = mkdtempSync(join(tmpdir(), "vcgpdm-figure-"));
/** @type {Awaited<ReturnType<typeof serve>>} */
let server;
/** @type {Awaited<ReturnType<typeof launchChromium>>} */
let browser;
before(async () => {
  for (const name of ["player", "inline", "web", "figure"])
    cpSync(at("crate/wasm/pkg", name), join(folder, name), { recursive: true });
  cpSync(at("www/first/model.json"), join(folder, "model.json"));
  for (const kind of KINDS)
    cpSync(at("crate/vcgpdm/tests/library/documents", `${kind}.json`), join(folder, `${kind}.json`));
  writeFileSync(join(folder, "index.html"), bare(show + SHOWN));
  const whole = `import init, { Model } from "vcgpdm/inline";
import { Figure } from "vcgpdm/figure";
await init();
Object.assign(window, { Figure, Model });
`;
  writeFileSync(join(folder, "whole.html"), bare(whole, "canvas { width: 100%; height: 240px }"));
  server = await serve(folder, { withPolicy: false });
  browser = await launchChromium();
});
after(async () => {
  await browser?.close();
  await server?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Runs in the page: counts the calls that draw. */
function countDraws() {
  const { prototype } = WebGL2RenderingContext;
  const draw = prototype.drawElements;
  Object.assign(window, { draws: 0 });
  prototype.drawElements = function (...given) {
    /** @type {any} */ (window).draws += 1;
    draw.apply(this, given);
  };
}

/** A page with a figure. */
async function open(path = "", options = {}) {
  const page = await browser.newPage({ viewport: { width: 640, height: 480 }, ...options });
  /** @type {string[]} */
  const problems = [];
  page.on("pageerror", (error) => problems.push(error.message));
  page.on("console", (message) => message.type() === "error" && problems.push(message.text()));
  await page.addInitScript(countDraws);
  await page.goto(server.address + path);
  await page
    .waitForFunction(() => "Figure" in window, undefined, { timeout: 30_000 })
    .catch((error) => assert.fail([error, ...problems].join("; ")));
  const canvas = page.locator("canvas");
  return {
    page,
    problems,
    picture: () => canvas.screenshot(),
    /** The picture when the camera and the quality of the picture rest. */
    async atRest() {
      let last = await canvas.screenshot();
      await soon(async () => {
        // A busy machine may draw the finer picture late.
        await page.waitForTimeout(1000);
        const next = await canvas.screenshot();
        const same = next.equals(last);
        last = next;
        assert.ok(same, "the picture rests");
      });
      return last;
    },
  };
}

describe("vcgpdm/figure on a bare page", () => {
  seldom.it(
    "walks by the lines of the README, changes its motion with alpha, and ends with dispose",
    async () => {
      const { page, problems, picture, atRest } = await open();
      const first = await picture();
      await soon(async () => assert.ok(!(await picture()).equals(first), "pixels move"));

      const now = () => page.evaluate(() => /** @type {any} */ (window).figure.time);
      await soon(async () => assert.ok((await now()) > 0.5));
      await page.evaluate(() => {
        const { figure } = /** @type {any} */ (window);
        figure.pause();
        figure.time = 3;
      });
      const learned = await atRest();
      await page.evaluate(() => {
        const { figure } = /** @type {any} */ (window);
        figure.alpha = figure.alpha.map((/** @type {number[]} */ row) => [...row]);
      });
      assert.ok((await atRest()).equals(learned), "the same couplings give the same picture");
      const before = await page.evaluate(() => /** @type {any} */ (window).figure.alpha[0][1]);
      await page.addScriptTag({ type: "module", content: `const { figure } = window;\n${change}` });
      await soon(async () =>
        assert.equal(await page.evaluate(() => /** @type {any} */ (window).figure.alpha[0][1]), 10 * before),
      );
      assert.ok(Math.abs((await now()) - 3) < 1e-9, "the motion goes on at its time");
      assert.ok(!(await atRest()).equals(learned), "other couplings give another picture");

      // Walks on, and ends.
      await page.evaluate(() => /** @type {any} */ (window).figure.play());
      const draws = () => page.evaluate(() => /** @type {any} */ (window).draws);
      const drawn = await draws();
      await soon(async () => assert.ok((await draws()) > drawn + 100, "it draws"));
      await page.evaluate(() => /** @type {any} */ (window).figure.dispose());
      const ended = await draws();
      await page.waitForTimeout(500);
      assert.equal(await draws(), ended, "nothing is drawn after dispose");
      assert.deepEqual(problems, []);
      await page.close();
    },
  );

  seldom.it("keeps the size of a canvas without a style, on a fine screen", async () => {
    const { page, problems, picture } = await open("", { deviceScaleFactor: 2 });
    const first = await picture();
    await soon(async () => assert.ok(!(await picture()).equals(first)));
    const size = await page.locator("canvas").boundingBox();
    assert.deepEqual([size?.width, size?.height], [300, 150]);
    assert.deepEqual(problems, []);
    await page.close();
  });

  seldom.it("shows every kind of model that has a body, and says what it expects of others", async () => {
    const { page, problems } = await open("whole.html");
    const found = await page.evaluate(async (kinds) => {
      const { Figure, Model } = /** @type {any} */ (window);
      const canvas = document.querySelector("canvas");
      const codeOf = (/** @type {() => unknown} */ work) => {
        try {
          work();
          return "none";
        } catch (error) {
          const { name, code, message } = /** @type {any} */ (error);
          return `${name} ${code}: ${message}`;
        }
      };
      const rows = [];
      for (const kind of kinds) {
        const model = Model.fromJson(await (await fetch(`${kind}.json`)).text());
        /** @type {any} */
        let figure;
        const made = codeOf(() => {
          figure = new Figure(canvas, model, { seconds: 1 });
        });
        const alpha = figure && codeOf(() => (figure.alpha = [[1]]));
        rows.push({ kind, made, couplings: figure ? figure.alpha !== null : false, alpha });
        figure?.dispose();
        model.free();
      }
      return rows;
    }, KINDS);
    for (const { kind, made, couplings, alpha } of found) {
      if (kind === "series") {
        assert.match(made, /^VcgpdmError model: expected a model of a body, found a vcgpdm of tables/);
        continue;
      }
      assert.equal(made, "none", kind);
      assert.equal(couplings, ["vcgpdm", "combination"].includes(kind), kind);
      assert.match(
        alpha,
        couplings ? /^VcgpdmError / : /^VcgpdmError model: expected a model with coupl/,
        kind,
      );
    }
    assert.deepEqual(problems, []);
    await page.close();
  });

  seldom.it("follows its canvas and its options", async () => {
    const { page, problems, atRest } = await open("whole.html");
    const kept = await page.evaluate(async () => {
      const { Figure, Model } = /** @type {any} */ (window);
      const model = Model.fromJson(await (await fetch("vcgpdm.json")).text());
      const canvas = document.querySelector("canvas");
      new Figure(canvas, model).dispose();
      const figure = new Figure(canvas, model, { samples: 2, seconds: 2, dark: false });
      Object.assign(window, { figure });
      const before = JSON.stringify(figure.alpha);
      const refused = [];
      for (const work of [
        () => (figure.alpha = [[-1]]),
        () => new Figure(canvas, model, { second: 2 }),
        () => new Figure(canvas, model, { seconds: 0 }),
      ])
        try {
          work();
        } catch (error) {
          refused.push(/** @type {Error} */ (error).message);
        }
      return {
        refused,
        same: JSON.stringify(figure.alpha) === before,
        frozen: Object.isFrozen(figure.alpha[0]),
      };
    });
    assert.equal(kept.refused.length, 3, "refuses strange values");
    assert.match(kept.refused[1] ?? "", /expected options of seconds, .*, found second$/);
    assert.ok(kept.same, "a refused alpha changes nothing");
    assert.ok(kept.frozen, "a change of one number throws in a module, because it would change nothing");
    const setDark = (/** @type {boolean | null} */ dark) =>
      page.evaluate((dark) => {
        const { figure } = /** @type {any} */ (window);
        figure.dark = dark;
      }, dark);
    const light = await atRest();
    await setDark(true);
    const dark = await atRest();
    assert.ok(!dark.equals(light));
    await page.emulateMedia({ colorScheme: "dark" });
    await setDark(null);
    assert.ok((await atRest()).equals(dark), "null follows the system");

    const pixels = () =>
      page.locator("canvas").evaluate((canvas) => {
        const { width, clientWidth } = /** @type {HTMLCanvasElement} */ (canvas);
        return [width, clientWidth];
      });
    await page.setViewportSize({ width: 400, height: 480 });
    await soon(async () => {
      const [width, clientWidth = 0] = await pixels();
      assert.equal(width, clientWidth);
      assert.ok(clientWidth < 400);
    });
    assert.deepEqual(problems, []);
    await page.close();
  });
});
