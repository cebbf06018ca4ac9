// Folders that a test makes and removes.
import { rmSync } from "node:fs";
import { setTimeout as sleep } from "node:timers/promises";

/**
 * Removes a folder into which a program that was just ended may still write: `rmSync` lists a folder once and
 * fails on a file that came later, so the whole removal is tried again. What is still there after ten seconds
 * stays, with a warning: a rest in the folder of temporary files says nothing about what was tested.
 */
export async function removeFolder(/** @type {string} */ folder) {
  for (let attempt = 1; ; attempt++) {
    try {
      rmSync(folder, { recursive: true, force: true });
      return;
    } catch (error) {
      if (attempt === 50) return console.warn(`not removed: ${folder}: ${error}`);
      await sleep(200);
    }
  }
}
