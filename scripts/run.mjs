// Running commands and steps: each says what it does, how long it took, and, in one line, why it failed.
import { spawn, spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { homedir } from "node:os";
import { delimiter, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = dirname(dirname(fileURLToPath(import.meta.url)));
export const at = (/** @type {string[]} */ ...parts) => join(root, ...parts);

/** A failure whose message is all that a person needs. */
export class Failure extends Error {}

const exe = process.platform === "win32" ? ".exe" : "";

// Tools of this project first, then cargo's own folder: a fresh rustup is not yet on the PATH of an open
// shell.
const path = [
  at(".tools", "bin"),
  process.env.PATH ?? "",
  join(process.env.CARGO_HOME ?? join(homedir(), ".cargo"), "bin"),
];
/** @type {NodeJS.ProcessEnv & { PATH: string }} */
export const env = { ...process.env, PATH: path.join(delimiter) };

/** Where a program stands on the PATH, or null. */
export function which(/** @type {string} */ program) {
  for (const folder of env.PATH.split(delimiter)) {
    const file = join(folder, program + exe);
    if (folder && existsSync(file) && statSync(file).isFile()) return file;
  }
  return null;
}

/** What a command prints, or null when it is missing or fails. */
export function output(/** @type {string} */ program, /** @type {string[]} */ ...args) {
  const { status, stdout } = spawnSync(program, args, { env, cwd: root, encoding: "utf8" });
  return status === 0 ? stdout.trim() : null;
}

/** Runs a command with its output on the screen; throws a Failure when it fails. */
export async function run(/** @type {string} */ program, /** @type {string[]} */ ...args) {
  const child = spawn(program, args, { env, cwd: root, stdio: ["ignore", "inherit", "inherit"] });
  const code = await new Promise((resolve, reject) => {
    child.once("error", (error) => reject(new Failure(`cannot run ${program}: ${error.message}`)));
    child.once("close", (status, signal) => resolve(status ?? signal));
  });
  if (code !== 0) throw new Failure(`\`${[program, ...args].join(" ")}\` ended with ${code}`);
}

/** Runs a JavaScript program of an npm package, without a shell and the same on every platform. */
export const runModule = (/** @type {string} */ file, /** @type {string[]} */ ...args) =>
  run(process.execPath, at("node_modules", file), ...args);

export function seconds(/** @type {number} */ since) {
  const s = (performance.now() - since) / 1000;
  return s < 60 ? `${s.toFixed(1)} s` : `${Math.floor(s / 60)} min ${Math.round(s % 60)} s`;
}

/**
 * One step of a build. `work` may return a note, e.g. "up to date".
 * @param {string} title
 * @param {() => Promise<string | void> | string | void} work
 */
export async function step(title, work) {
  const start = performance.now();
  console.log(`\n== ${title}`);
  const note = await work();
  console.log(`== ${title}: ${note ?? "done"} (${seconds(start)})`);
}

/** Runs a script's steps; a Failure ends it with one line, anything else with its stack. */
export async function main(/** @type {() => Promise<void>} */ work) {
  try {
    await work();
  } catch (error) {
    console.error(error instanceof Failure ? `\nerror: ${error.message}` : error);
    process.exit(1);
  }
}

/** All files under the given files and folders, sorted; names in `skip` are left out. */
export function filesUnder(/** @type {string[]} */ paths, /** @type {string[]} */ skip = []) {
  /** @type {string[]} */
  const found = [];
  const visit = (/** @type {string} */ path) => {
    if (!existsSync(path)) return;
    if (!statSync(path).isDirectory()) return void found.push(path);
    for (const name of readdirSync(path)) if (!skip.includes(name)) visit(join(path, name));
  };
  paths.forEach(visit);
  return found.sort();
}

/**
 * Does `work` unless its outputs exist and its inputs have the content they had the last time.
 * @param {string} name
 * @param {{ inputs: string[], outputs: string[], salt?: string }} what `salt` holds inputs that are not files
 * @param {() => Promise<void>} work
 * @returns {Promise<string | undefined>} a note when there was nothing to do
 */
export async function whenChanged(name, { inputs, outputs, salt = "" }, work) {
  const hash = createHash("sha256").update(salt);
  for (const file of inputs) hash.update(file.slice(root.length)).update("\0").update(readFileSync(file));
  const now = hash.digest("hex");
  const stamp = at(".tools", `${name}.stamp`);
  const before = existsSync(stamp) ? readFileSync(stamp, "utf8") : null;
  if (before === now && outputs.every((file) => existsSync(file))) return "up to date";
  await work();
  mkdirSync(dirname(stamp), { recursive: true });
  writeFileSync(stamp, now);
}
