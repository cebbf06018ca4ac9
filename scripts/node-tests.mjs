// Runs test files by Node's test runner.
import { relative } from "node:path";
import { describe, it, run } from "node:test";
import { spec } from "node:test/reporters";
import { at, env, Failure, filesUnder, root } from "./run.mjs";

const TEN_MINUTES = 600_000;

/** Whether only the steps and tests run that a change often breaks. Their wasm is compiled quickly. */
export const often = () => env.PAGE_TESTS === "often";

/** `it` and `describe` of what a change seldom breaks: `npm test` leaves these tests out. */
export const seldom = often() ? { it: it.skip, describe: describe.skip } : { it, describe };

/** The largest number of files that run again: when more fail, the change is at fault, not a slow machine. */
const MOST_AGAIN = 4;

/**
 * Runs the test files of a folder, `concurrency` files at a time: tests in a browser mostly wait. With
 * `again`, a file that failed runs once more, alone: a browser beside a compiler can be too slow for a test.
 * The note that is returned names these files, so that nobody takes them for sound.
 */
export async function nodeTests(/** @type {string} */ folder, concurrency = 1, again = false) {
  const all = filesUnder([at("tests", folder)]).filter((file) => file.endsWith(".test.mjs"));
  const failed = await failedOf(all, concurrency);
  if (failed.length === 0) return;
  if (!again || failed.length > MOST_AGAIN) throw new Failure(`failed: ${namesOf(failed)}`);
  console.log(`\nOnce more, alone: ${namesOf(failed)}\n`);
  const twice = await failedOf(failed, 1);
  if (twice.length > 0) throw new Failure(`failed twice: ${namesOf(twice)}`);
  return `failed at first, passed alone: ${namesOf(failed)}`;
}

const namesOf = (/** @type {string[]} */ files) => files.map((file) => relative(root, file)).join(", ");

/** The files in which a test failed. */
async function failedOf(/** @type {string[]} */ files, /** @type {number} */ concurrency) {
  /** @type {Set<string>} */
  const failed = new Set();
  // The test files get the environment of this process.
  Object.assign(process.env, env);
  const tests = run({ files, concurrency, timeout: TEN_MINUTES });
  // A file that cannot run, or not to its end, is a failed test that has the name of the file.
  tests.on("test:fail", ({ file, name }) => failed.add(file ?? name));
  for await (const text of tests.compose(new spec())) process.stdout.write(text);
  // A helper file has no tests of its own, so it would pass when it runs again.
  const stray = [...failed].find((file) => !files.includes(file));
  if (stray) throw new Failure(`expected failed tests in test files alone, found one that ${stray} defines`);
  return [...failed];
}
