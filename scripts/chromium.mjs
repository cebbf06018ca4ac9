// The system's Chromium, driven by playwright-core: nothing is downloaded.
import { existsSync } from "node:fs";
import { Failure, which } from "./run.mjs";
import { serve } from "./serve.mjs";

const NAMES = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];
const MAC = ["Google Chrome", "Chromium"].map((name) => `/Applications/${name}.app/Contents/MacOS/${name}`);

/**
 * Features of Chromium that are off. The two popups of the address bar are pages of their own in each new
 * window, and each visit needed half a second of a core for them. This list replaces that of Playwright, so it
 * repeats what matters here: no requests to Google, and pages that load and end as on any host.
 */
const OFF = [
  ...["WebUIOmniboxPopup", "WebUIOmniboxAimPopup"],
  ...["AimEnabled", "MediaRouter", "NetworkTimeServiceQuerying", "OptimizationHints", "PreconnectToSearch"],
  ...["AvoidUnnecessaryBeforeUnloadCheckSync", "DestroyProfileOnBrowserClose", "HttpsUpgrades"],
  ...["HttpsFirstBalancedModeAutoEnable", "LensOverlay", "PaintHolding", "ThirdPartyStoragePartitioning"],
];

/** The program of the browser: the variable CHROMIUM, else the first one found; or null. */
export function findChromium() {
  if (process.env.CHROMIUM) return process.env.CHROMIUM;
  return NAMES.map(which).find((file) => file !== null) ?? MAC.find((file) => existsSync(file)) ?? null;
}

/** The variable with the address of a browser that several processes share. */
const SHARED = "SHARED_CHROMIUM";

/** The program, and how it draws WebGL in software, without a window. */
function settings() {
  const executablePath = findChromium();
  if (!executablePath) {
    throw new Failure(
      "no Chromium was found: install one (Debian, Ubuntu: sudo apt-get install chromium) " +
        "or name it in the variable CHROMIUM",
    );
  }
  const args = [
    ...["--no-sandbox", "--disable-dev-shm-usage"], // containers run as root and have a small /dev/shm
    ...["--enable-unsafe-swiftshader", "--use-angle=swiftshader"], // WebGL without a graphics card
    // The rest of the page does not use the emulated card, so the stage gets four times the frames.
    ...["--disable-gpu-compositing", "--disable-gpu-rasterization", "--disable-accelerated-2d-canvas"],
    `--disable-features=${OFF.join(",")}`,
  ];
  return { executablePath, args };
}

/** Imported when it is needed: `npm test` reads this file before the npm packages are installed. */
const playwright = async () => (await import("playwright-core")).chromium;

/** Starts the browser, or connects to the one of `inOneChromium`. */
export async function launchChromium() {
  const chromium = await playwright();
  const shared = process.env[SHARED];
  return shared ? chromium.connect(shared) : chromium.launch(settings());
}

/**
 * Runs `work` while this process, and those that it starts, share one browser: a start takes more than a second of
 * a core.
 * @template T
 * @param {() => Promise<T>} work
 */
export async function inOneChromium(work) {
  const chromium = await playwright();
  const server = await chromium.launchServer(settings());
  process.env[SHARED] = server.wsEndpoint();
  try {
    return await work();
  } finally {
    delete process.env[SHARED];
    await server.close();
  }
}

/**
 * What `use` measures on a page of this folder, in a browser of its own.
 * @template T
 * @param {string} folder
 * @param {import("playwright-core").BrowserContextOptions} options
 * @param {(page: import("playwright-core").Page, address: string) => Promise<T>} use
 */
export async function onPage(folder, options, use) {
  const server = await serve(folder);
  const browser = await launchChromium();
  try {
    return await use(await browser.newPage(options), server.address);
  } finally {
    await browser.close();
    await server.close();
  }
}
