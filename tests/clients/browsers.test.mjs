// The main path of the page in Firefox and in WebKit: load, drop a clip, train, drag a coupling, save, reload
// and bring back.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, it } from "node:test";
import { env, which } from "../../scripts/run.mjs";
import { serve } from "../../scripts/serve.mjs";
import { dist } from "../../scripts/site.mjs";
import { bvh } from "../e2e/clips.mjs";
import { removeFolder } from "./folders.mjs";
import { startBrowser } from "./webdriver.mjs";

const folder = mkdtempSync(join(tmpdir(), "vcgpdm-browsers-"));
const LIBRARIES = "/usr/lib";
const DISPLAY = ":87";

/** The small browser that comes with WebKitGTK. */
function miniBrowser() {
  for (const machine of existsSync(LIBRARIES) ? readdirSync(LIBRARIES) : [])
    for (const version of ["4.1", "4.0", "6.0"]) {
      const file = join(LIBRARIES, machine, `webkit2gtk-${version}`, "MiniBrowser");
      if (existsSync(file)) return file;
    }
  return null;
}

const geckodriver = which("geckodriver");
const firefox = which("firefox-esr") ?? which("firefox");
const webkitDriver = which("WebKitWebDriver");
const mini = miniBrowser();
const xvfb = which("Xvfb");

const BROWSERS = [
  {
    name: "Firefox",
    skip: firefox && geckodriver ? false : "Firefox or geckodriver was not found",
    start: () =>
      startBrowser({
        driver: geckodriver ?? "",
        args: ["--websocket-port=0"],
        capabilities: {
          "moz:firefoxOptions": {
            binary: firefox,
            args: ["-headless"],
            prefs: {
              "browser.download.folderList": 2,
              "browser.download.dir": folder,
              "webgl.force-enabled": true,
            },
          },
        },
      }),
  },
  {
    name: "WebKit",
    skip: webkitDriver && mini && xvfb ? false : "WebKitWebDriver, MiniBrowser or Xvfb was not found",
    start: () =>
      startBrowser({
        driver: webkitDriver ?? "",
        capabilities: { "webkitgtk:browserOptions": { binary: mini, args: ["--automation"] } },
        env: { ...env, DISPLAY, XDG_DATA_HOME: folder, XDG_CACHE_HOME: folder, XDG_CONFIG_HOME: folder },
      }),
  },
];

/** Runs in the page: drops a file onto its middle. */
function dropFile(/** @type {string} */ name, /** @type {string} */ text) {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([text], name));
  for (const type of ["dragenter", "dragover", "drop"]) {
    const where = { clientX: innerWidth / 2, clientY: innerHeight / 2 };
    document.body.dispatchEvent(
      new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true, ...where }),
    );
  }
}

/** Runs in the page: keeps the next file that the page saves. */
function catchFile() {
  const create = URL.createObjectURL.bind(URL);
  URL.createObjectURL = (/** @type {Blob} */ blob) => {
    Object.assign(window, { saved: blob.text() });
    return create(blob);
  };
}

const READY = () =>
  document.documentElement.dataset.engine === "ready" &&
  document.querySelector("[data-testid=train]:enabled") !== null;
const OWN_CLIP = () => /mine/.test(document.querySelector("[data-testid=own-clips]")?.textContent ?? "");
const training = () => /** @type {any} */ (document.querySelector("pg-training")).training;

/** @type {Awaited<ReturnType<typeof serve>>} */
let site;
/** @type {import("node:child_process").ChildProcess | undefined} */
let display;

before(async () => {
  site = await serve(dist);
  if (xvfb)
    display = spawn(xvfb, [DISPLAY, "-screen", "0", "1400x1000x24", "-nolisten", "tcp"], { stdio: "ignore" });
});
after(async () => {
  display?.kill();
  await site?.close();
  await removeFolder(folder);
});

for (const { name, skip, start } of BROWSERS) {
  describe(name, () => {
    it("trains on a dropped clip, saves the model, and brings all back after a reload", {
      skip,
    }, async () => {
      const browser = await start();
      try {
        await browser.open(`${site.address}#trainings=1&iterations=40&fps=15&dynamics=8&poses=8`);
        await browser.until("the page", READY);

        await browser.run(dropFile, "mine.bvh", bvh());
        await browser.until("the clip", OWN_CLIP);

        await browser.click("[data-testid=train]");
        const model = await browser.until(
          "the end of the training",
          `() => (${training})().runs.find((run) => run.state === "done")?.model.text`,
          180_000,
        );

        const weight = () => document.querySelector("[data-testid=weight-0-1]")?.textContent;
        const learned = await browser.run(weight);
        await browser.drag("[data-testid=coupling-0-1]", 40);
        await browser.until("the new coupling", () => /alpha=/.test(location.hash));
        assert.notEqual(await browser.run(weight), learned);

        await browser.run(catchFile);
        await browser.click("[data-testid=save]");
        await browser.click("[data-testid=save-model]");
        const file = await browser.until("the saved model", () => "saved" in window && window.saved);
        assert.ok(file === model, "the saved file is the trained model");

        // The address follows the end of the drag a moment later.
        const address = await browser.run(() => location.hash);
        await browser.run(() => /** @type {any} */ (document.querySelector("pg-page")).session.keepNow());
        await browser.reload();
        await browser.until("the page", READY);
        await browser.until("the clip", OWN_CLIP);
        const models = `() => (${training})().runs.map((run) => run.model?.text)`;
        assert.ok((await browser.run(models)).join() === model, "the trained model is back");
        assert.equal(await browser.run(() => location.hash), address);
      } finally {
        await browser.close();
      }
    });
  });
}
