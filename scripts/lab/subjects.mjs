// Whose trials are evaluated: clips of a folder, and trials that the program makes.
import { readdirSync } from "node:fs";
import { basename, join, resolve } from "node:path";
import { Failure } from "../run.mjs";

/**
 * Seated trials are not periodic and have three parts, as in Velychko et al. (2018, section 5.3).
 * @typedef {{ name: string, clips: string[], seated?: boolean }} Subject
 */

/** The parts of walks. */
export const PARTS = "lower,upper";

/** The parts of passing a bottle. */
export const THREE_PARTS = "body-arms";

/** Trials that the program makes, from the first. */
export const samples = (/** @type {string} */ name, /** @type {number} */ count) =>
  Array.from({ length: count }, (_, trial) => `sample:${name}-${trial + 1}`);

/** Walks that the program makes. */
export const MADE = [
  { name: "walk-made", clips: samples("walk", 6) },
  { name: "walk-and-wave-made", clips: samples("walk-wave", 4) },
];

/**
 * Passing a bottle.
 * @type {Subject}
 */
export const BOTTLE = { name: "bottle-made", clips: samples("bottle", 10), seated: true };

/** The folder's clips as one subject. */
export function subject(/** @type {string} */ folder, least = 3) {
  const files = readdirSync(folder).filter((file) => file.toLowerCase().endsWith(".bvh"));
  if (files.length < least)
    throw new Failure(`expected at least ${least} clips (.bvh) in ${folder}, found ${files.length}`);
  return { name: basename(resolve(folder)), clips: files.sort().map((file) => join(folder, file)) };
}
