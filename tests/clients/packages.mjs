// Fresh folders in which the packed package and a tool are installed, and how their tests run programs and
// open pages there.
import { execFile, execFileSync, spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { promisify, stripVTControlCharacters } from "node:util";
import { launchChromium } from "../../scripts/chromium.mjs";
import { at } from "../../scripts/run.mjs";
import { serve } from "../../scripts/serve.mjs";

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
/** The package as it would be published. */
function tarball() {
  if (!packed) {
    const cli = process.env.npm_execpath;
    const args = [...(cli ? [cli] : []), "pack", at("crate/wasm/pkg"), "--loglevel=error"];
    const printed = execFileSync(cli ? process.execPath : "npm", args, { cwd: place, encoding: "utf8" });
    packed = join(place, printed.trim().split("\n").at(-1) ?? "");
  }
  return packed;
}

/** @typedef {Promise<string | null>} Installed a folder; null where the registry does not give the tools */

/** @type {{ files: Record<string, string>, tools: string[], done: (folder: Installed) => void }[]} */
const asked = [];
let busy = 0;
/**
 * So many installations at a time: they mostly wait for the registry, and the tests of what is there go on
 * meanwhile.
 */
const SIDE_BY_SIDE = 3;

/**
 * Asks for a folder with these files, the package and the tools; nothing is installed before the first of
 * those asked for is waited for.
 * @param {Record<string, string>} files
 * @param {string[]} tools as npm names them, such as vite@8
 * @returns {() => Installed}
 */
export function later(files, tools = []) {
  /** @type {Installed} */
  const folder = new Promise((resolve) => asked.push({ files, tools, done: resolve }));
  // The test that waits for it says why it failed.
  folder.catch(() => {});
  return () => {
    installNext();
    return folder;
  };
}

function installNext() {
  while (busy < SIDE_BY_SIDE) {
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
    // Without tools it is the package that cannot be installed.
    if (tools.length === 0) throw error;
    return null;
  }
  return folder;
}

/** What a program prints in the folder. */
export async function run(
  /** @type {string} */ folder,
  /** @type {string} */ program,
  /** @type {string[]} */ ...args
) {
  const { stdout, stderr } = await execute(program, args, {
    cwd: folder,
    encoding: "utf8",
    maxBuffer: 1 << 26,
    timeout: 120_000,
  });
  return stdout + stderr;
}

/** A JavaScript program of an installed package, as npm has linked it. */
export const tool = (
  /** @type {string} */ folder,
  /** @type {string} */ name,
  /** @type {string[]} */ ...args
) => run(folder, join(folder, "node_modules", ".bin", name), ...args);

/** @type {Awaited<ReturnType<typeof launchChromium>> | undefined} */
let browser;

/** The title that a page gives itself when it is through, or the errors that it threw. */
export async function titleOf(/** @type {string} */ address) {
  browser ??= await launchChromium();
  const page = await browser.newPage();
  const said = /** @type {string[]} */ ([]);
  page.on("pageerror", (error) => said.push(error.message));
  page.on("console", (message) => message.type() === "error" && said.push(message.text()));
  try {
    await page.goto(address);
    await page.waitForFunction(() => document.title.startsWith("done:"), undefined, { timeout: 30_000 });
    return await page.title();
  } catch (error) {
    throw new Error(`${address}: ${said.join("; ") || error}`);
  } finally {
    await page.close();
  }
}

/** The title of the page in a folder. */
export async function titleIn(/** @type {string} */ folder) {
  // Parcel puts scripts into the page.
  const server = await serve(folder, { withPolicy: false });
  try {
    return await titleOf(server.address);
  } finally {
    await server.close();
  }
}

/** Starts a server that prints its address, and does something with it. */
export async function withServer(
  /** @type {string} */ folder,
  /** @type {string} */ name,
  /** @type {string[]} */ args,
  /** @type {(address: string) => Promise<string>} */ work,
) {
  const child = spawn(join(folder, "node_modules", ".bin", name), args, { cwd: folder, detached: true });
  try {
    const address = await new Promise((resolve, reject) => {
      let text = "";
      const read = (/** @type {Buffer} */ data) => {
        // Without what colours it.
        text += stripVTControlCharacters(data.toString());
        const found = text.match(/http:\/\/(localhost|127\.0\.0\.1):\d+\//);
        if (found) resolve(found[0]);
      };
      child.stdout.on("data", read);
      child.stderr.on("data", read);
      child.once("close", () => reject(new Error(`${name} ended: ${text}`)));
      setTimeout(() => reject(new Error(`${name} gave no address: ${text}`)), 60_000).unref();
    });
    return await work(address);
  } finally {
    // With the processes that it has started.
    if (child.pid && child.exitCode === null) process.kill(-child.pid);
  }
}

/** After all tests. */
export async function clear() {
  await browser?.close();
  rmSync(place, { recursive: true, force: true });
}
