// Installs the packed package and a tool into fresh folders, and runs programs and opens pages there.
import { execFile, execFileSync, spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { it } from "node:test";
import { promisify, stripVTControlCharacters } from "node:util";
import { launchChromium } from "../../scripts/chromium.mjs";
import { at } from "../../scripts/run.mjs";
import { serve } from "../../scripts/serve.mjs";
import { removeFolder } from "./folders.mjs";

const execute = promisify(execFile);
const place = mkdtempSync(join(tmpdir(), "vcgpdm-clients-"));

const npm = (/** @type {string} */ folder, /** @type {string[]} */ ...args) => {
  const cli = process.env.npm_execpath;
  const options = { cwd: folder, encoding: /** @type {const} */ ("utf8"), maxBuffer: 1 << 26 };
  return execute(
    cli ? process.execPath : "npm",
    [...(cli ? [cli] : []), ...args, "--loglevel=error"],
    options,
  );
};

/** @type {string | undefined} */
let packed;
/** Packs the package as for publishing. */
function tarball() {
  if (!packed) {
    const cli = process.env.npm_execpath;
    const args = [...(cli ? [cli] : []), "pack", at("crate/wasm/pkg"), "--loglevel=error"];
    const printed = execFileSync(cli ? process.execPath : "npm", args, { cwd: place, encoding: "utf8" });
    packed = join(place, printed.trim().split("\n").at(-1) ?? "");
  }
  return packed;
}

/** @typedef {Promise<string | null>} Installed a folder; null when the registry lacks the tools */

/** @type {{ files: Record<string, string>, tools: string[], done: (folder: Installed) => void }[]} */
const asked = [];
let busy = 0;
/** Installations at the same time. They mostly wait for the registry, and tests continue meanwhile. */
const MAX_INSTALLATIONS = 3;

/**
 * Asks for a folder with these files, the package and the tools. The installations start when a test waits
 * for the first folder.
 * @param {Record<string, string>} files
 * @param {string[]} tools as npm names them, such as vite@8
 * @returns {() => Installed}
 */
function later(files, tools = []) {
  /** @type {Installed} */
  const folder = new Promise((resolve) => asked.push({ files, tools, done: resolve }));
  // The test that waits for the folder reports the failure.
  folder.catch(() => {});
  return () => {
    installNext();
    return folder;
  };
}

function installNext() {
  while (busy < MAX_INSTALLATIONS) {
    const next = asked.shift();
    if (!next) return;
    busy += 1;
    const folder = folderWith(next.files, next.tools).finally(() => {
      busy -= 1;
      installNext();
    });
    next.done(folder);
  }
}

/** @returns {Installed} */
async function folderWith(/** @type {Record<string, string>} */ files, /** @type {string[]} */ tools) {
  const folder = mkdtempSync(join(place, "client-"));
  const all = { "package.json": '{ "private": true, "type": "module" }\n', ...files };
  for (const [name, text] of Object.entries(all)) {
    mkdirSync(dirname(join(folder, name)), { recursive: true });
    writeFileSync(join(folder, name), text);
  }
  try {
    await npm(folder, "install", "--no-audit", "--no-fund", tarball(), ...tools);
  } catch (error) {
    // Without tools, the package itself cannot be installed; tools that do not fit together are a fault of ours.
    if (tools.length === 0 || /ERESOLVE/.test(String(error))) throw error;
    return null;
  }
  return folder;
}

/**
 * A test of a tool; skipped when the registry lacks the tool.
 * @param {string} name
 * @param {string[]} tools
 * @param {Record<string, string>} files
 * @param {(folder: string) => Promise<unknown>} work
 */
export function client(name, tools, files, work) {
  const installed = later(files, tools);
  it(name, { timeout: 600_000 }, async (test) => {
    const folder = await installed();
    if (folder === null) return test.skip(`the registry lacks ${tools.join(" ")}`);
    await work(folder);
  });
}

/** The output of a program that runs in the folder. */
export async function run(
  /** @type {string} */ folder,
  /** @type {string} */ program,
  /** @type {string[]} */ ...args
) {
  const { stdout, stderr } = await execute(program, args, {
    cwd: folder,
    encoding: "utf8",
    maxBuffer: 1 << 26,
    timeout: 600_000,
  });
  return stdout + stderr;
}

/** Runs a JavaScript program of an installed package. */
export const tool = (
  /** @type {string} */ folder,
  /** @type {string} */ name,
  /** @type {string[]} */ ...args
) => run(folder, join(folder, "node_modules", ".bin", name), ...args);

/** @type {Awaited<ReturnType<typeof launchChromium>> | undefined} */
let browser;

/** The title of a page when it is done; fails with the errors that the page reported. */
export async function titleOf(/** @type {string} */ address) {
  browser ??= await launchChromium();
  const page = await browser.newPage();
  const errors = /** @type {string[]} */ ([]);
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  try {
    await page.goto(address);
    await page.waitForFunction(() => document.title.startsWith("done:"), undefined, { timeout: 30_000 });
    return await page.title();
  } catch (error) {
    throw new Error(`${address}: ${errors.join("; ") || error}`);
  } finally {
    await page.close();
  }
}

/** The title of the page in a folder. */
export async function titleIn(/** @type {string} */ folder) {
  // Parcel writes scripts into the page, which the policy forbids.
  const server = await serve(folder, { withPolicy: false });
  try {
    return await titleOf(server.address);
  } finally {
    await server.close();
  }
}

/** Starts a server, a tool or a program of Node's, that prints its address, and calls `work` with the address. */
export async function withServer(
  /** @type {string} */ folder,
  /** @type {string} */ name,
  /** @type {string[]} */ args,
  /** @type {(address: string) => Promise<string>} */ work,
) {
  const program = name === process.execPath ? name : join(folder, "node_modules", ".bin", name);
  const child = spawn(program, args, { cwd: folder, detached: true });
  try {
    const address = await new Promise((resolve, reject) => {
      let text = "";
      const read = (/** @type {Buffer} */ data) => {
        text += stripVTControlCharacters(data.toString());
        const found = text.match(/(http:\/\/(?:localhost|127\.0\.0\.1):\d+)\/?\s/);
        if (found) resolve(`${found[1]}/`);
      };
      child.stdout.on("data", read);
      child.stderr.on("data", read);
      child.once("close", () => reject(new Error(`${name} ended: ${text}`)));
      setTimeout(() => reject(new Error(`${name} gave no address: ${text}`)), 60_000).unref();
    });
    return await work(address);
  } finally {
    // Also ends the processes that the server started.
    if (child.pid && child.exitCode === null) process.kill(-child.pid);
  }
}

/** Cleans up after all tests. */
export async function clear() {
  await browser?.close();
  await removeFolder(place);
}
