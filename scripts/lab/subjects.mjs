// Whose trials are evaluated: clips of a folder, and trials that the program makes.
import { readdirSync } from "node:fs";
import { basename, join, resolve } from "node:path";
import { Failure } from "../run.mjs";

/** @typedef {{ name: string, clips: string[] }} Subject */

/** The parts of walks. */
export const PARTS = "lower,upper";

/** The movements of which the program makes trials. */
export const MADE = [
  {
    name: "walk-made",
    clips: [
      "sample:walk-1",
      "sample:walk-2",
      "sample:walk-3",
      "sample:walk-4",
      "sample:walk-5",
      "sample:walk-6",
    ],
  },
  {
    name: "walk-and-wave-made",
    clips: ["sample:walk-wave-1", "sample:walk-wave-2", "sample:walk-wave-3", "sample:walk-wave-4"],
  },
];

/** The folder's clips as one subject. */
export function subject(/** @type {string} */ folder) {
  const files = readdirSync(folder).filter((file) => file.toLowerCase().endsWith(".bvh"));
  if (files.length < 3)
    throw new Failure(`expected at least three clips (.bvh) in ${folder}, found ${files.length}`);
  return { name: basename(resolve(folder)), clips: files.sort().map((file) => join(folder, file)) };
}
