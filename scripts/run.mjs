// Runs commands and steps. A step prints its title, its time and, in one line, the reason of a failure.
import { spawn, spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { homedir } from "node:os";
import { delimiter, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = dirname(dirname(fileURLToPath(import.meta.url)));
export const at = (/** @type {string[]} */ ...parts) => join(root, ...parts);

/** A failure whose message is enough: no stack is printed. */
export class Failure extends Error {}

/** What the file name of a program ends with. */
export const executable = process.platform === "win32" ? ".exe" : "";

// The last folder is Cargo's own: right after rustup is installed, the PATH of an open shell lacks it.
const path = [process.env.PATH ?? "", join(process.env.CARGO_HOME ?? join(homedir(), ".cargo"), "bin")];
/** @type {NodeJS.ProcessEnv & { PATH: string }} */
export const env = { ...process.env, PATH: path.join(delimiter) };

/** The file of a program on the PATH, or null. */
export function which(/** @type {string} */ program) {
  for (const folder of env.PATH.split(delimiter)) {
    const file = join(folder, program + executable);
    if (folder && existsSync(file) && statSync(file).isFile()) return file;
  }
  return null;
}

/** The output of a command, or null when the command is missing or fails. */
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

/** Runs a JavaScript program of an npm package: without a shell, in the same way on every platform. */
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
 * @typedef {{ inputs: string[], outputs: string[], salt?: string }} State
 * `salt` holds inputs other than files
 */

const stampOf = (/** @type {string} */ name) => at(".tools", `${name}.stamp`);

function hashOf(/** @type {State} */ { inputs, salt = "" }) {
  const hash = createHash("sha256").update(salt);
  for (const file of inputs) hash.update(file.slice(root.length)).update("\0").update(readFileSync(file));
  return hash.digest("hex");
}

/** Whether the outputs exist and the inputs have the same content as last time. */
export function isUpToDate(/** @type {string} */ name, /** @type {State} */ state) {
  const stamp = stampOf(name);
  return (
    existsSync(stamp) &&
    readFileSync(stamp, "utf8") === hashOf(state) &&
    state.outputs.every((file) => existsSync(file))
  );
}

/**
 * Does `work` unless it is up to date; then it returns a note that says so.
 * @param {string} name
 * @param {State} state
 * @param {() => Promise<void>} work
 */
export async function whenChanged(name, state, work) {
  if (isUpToDate(name, state)) return "up to date";
  const now = hashOf(state);
  await work();
  mkdirSync(dirname(stampOf(name)), { recursive: true });
  writeFileSync(stampOf(name), now);
}
