// The Python package: installed by pip as a user does, then tested by pytest (crate/python/tests). Its figure
// walks in a marimo notebook in Chromium.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { before, describe, it } from "node:test";
import { findChromium, launchChromium } from "../../scripts/chromium.mjs";
import { environment, install } from "../../scripts/python.mjs";
import { at, env, Failure, filesUnder, run, whenChanged } from "../../scripts/run.mjs";
import { buildWidget } from "../../scripts/widget.mjs";

const { python } = environment("python");
const requirements = at("tests/clients/python.txt");

/** @type {string | false} */
let skip = false;
try {
  await install("python", requirements);
} catch (error) {
  if (!(error instanceof Failure)) throw error;
  skip = error.message;
}

describe("the Python package", { skip }, () => {
  before(async () => {
    await buildWidget();
    const inputs = filesUnder(
      [requirements, ...["python", "vcgpdm", "lab"].map((name) => at("crate", name))],
      ["target", "tests", "benches", "examples", "__pycache__"],
    );
    const pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check"];
    await whenChanged("python-package", { inputs, outputs: [python] }, () =>
      run(python, ...pip, at("crate/python[widget]")),
    );
  });

  it("has no warnings of clippy", () =>
    run("cargo", "clippy", "--manifest-path", at("crate/python/Cargo.toml"), "--", "--deny", "warnings"));

  it("passes its tests", () => {
    execFileSync(python, ["-m", "pytest", "--quiet", "-p", "no:cacheprovider", at("crate/python/tests")], {
      env: { ...env, PYTHONDONTWRITEBYTECODE: "1" },
      stdio: "inherit",
    });
  });

  it("has a figure that walks in marimo, whose sliders change alpha in Python", {
    skip: findChromium() ? false : "no Chromium was found",
  }, async () => {
    const port = 8123;
    const marimo = ["-m", "marimo", "run", "--headless", "--no-token", "--port", `${port}`];
    const server = spawn(python, [...marimo, at("tests/clients/figure_app.py")], { stdio: "ignore" });
    const browser = await launchChromium();
    try {
      const page = await browser.newPage();
      for (let tries = 0; ; tries++) {
        try {
          await page.goto(`http://127.0.0.1:${port}/`);
          break;
        } catch (error) {
          if (tries === 100) throw error;
          await new Promise((resume) => setTimeout(resume, 500));
        }
      }
      const patience = { timeout: 120_000 };
      const alpha = page.getByText("alpha from lower to upper:");
      await alpha.waitFor(patience);
      const slider = page.getByLabel("lower → upper");
      await slider.waitFor(patience);
      const learned = await alpha.textContent();
      const number = (/** @type {string | null} */ text) => Number(text?.split(": ")[1]);
      await slider.fill("1");
      await page.getByText(learned ?? "").waitFor({ ...patience, state: "detached" });
      const ratio = number(await alpha.textContent()) / number(learned);
      assert.ok(Math.abs(ratio - 10) < 1e-3, `ten times the learned variance, found ${ratio} times`);

      // The figure moves by itself until the button stops it.
      const canvas = page.locator(".vcgpdm canvas");
      const picture = async () => (await canvas.screenshot()).toString("base64");
      const first = await picture();
      assert.notEqual(await picture(), first);
      await page.getByRole("button", { name: "Pause" }).click();
      await page.getByRole("button", { name: "Play" }).waitFor(patience);
    } finally {
      await browser.close();
      server.kill();
    }
  });
});
