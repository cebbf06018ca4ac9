import { expect, it } from "vitest";
import { OneTask } from "./slices";

it("takes all steps, and reports after each slice whether they are over", async () => {
  const reports: boolean[] = [];
  let steps = 0;
  const all = await new OneTask().run((task) =>
    task.inSlices(
      () => {
        steps += 1;
        return steps === 5;
      },
      (done) => reports.push(done),
    ),
  );
  expect([all, steps, reports]).toEqual([true, 5, [true]]);
});

it("hears a cancel between two slices, and does one thing at a time", async () => {
  const worker = new OneTask();
  const slow = () => {
    for (const start = performance.now(); performance.now() - start < 110; );
    return false;
  };
  const reports: boolean[] = [];
  const work = worker.run((task) => task.inSlices(slow, (done) => reports.push(done)));
  await expect(worker.run(() => Promise.resolve())).rejects.toThrow("at work already");
  setTimeout(() => worker.cancel(), 0);
  expect(await work).toBe(false);
  expect(reports.every((done) => !done)).toBe(true);
  worker.cancel();
  expect(
    await worker.run((task) =>
      task.inSlices(
        () => true,
        () => {},
      ),
    ),
  ).toBe(true);
});

it("can work again after a failure", async () => {
  const worker = new OneTask();
  await expect(worker.run(() => Promise.reject(new Error("too short")))).rejects.toThrow("too short");
  expect(await worker.run(() => Promise.resolve(7))).toBe(7);
});
