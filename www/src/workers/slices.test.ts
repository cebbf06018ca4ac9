import { expect, it } from "vitest";
import { inSlices } from "./slices";

it("takes all steps, and reports after each slice whether they are over", async () => {
  const reports: boolean[] = [];
  let steps = 0;
  const all = await inSlices(
    new AbortController().signal,
    () => {
      steps += 1;
      return steps === 5;
    },
    (done) => reports.push(done),
  );
  expect([all, steps, reports]).toEqual([true, 5, [true]]);
});

it("hears an abort between two slices, and counts the pauses", async () => {
  const controller = new AbortController();
  const slow = () => {
    for (const start = performance.now(); performance.now() - start < 110; );
    return false;
  };
  const reports: boolean[] = [];
  const pauses: number[] = [];
  const work = inSlices(
    controller.signal,
    slow,
    (done) => reports.push(done),
    (milliseconds) => pauses.push(milliseconds),
  );
  setTimeout(() => controller.abort(), 0);
  expect(await work).toBe(false);
  expect(reports.every((done) => !done)).toBe(true);
  expect(pauses.length).toBe(reports.length);
});
