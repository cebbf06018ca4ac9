import { expect, it } from "vitest";
import type { TrainingProgress } from "../engine/protocol";
import { follow } from "./follow";

it("sends the notices with the first report alone, and with the outcome", async () => {
  let iteration = 0;
  const training = {
    step: () => {
      // Slower than a slice, so that there is a report after each step.
      for (const start = performance.now(); performance.now() - start < 110; );
      iteration += 1;
      return { iteration, done: iteration === 3, reason: null } as TrainingProgress;
    },
    notices: () => ["the clip a does not move"],
    find: () => null,
  };
  const sent: (string[] | undefined)[] = [];
  const outcome = await follow(training, ({ notices }) => sent.push(notices), new AbortController().signal);
  expect(sent[0]).toEqual(["the clip a does not move"]);
  expect(sent.length).toBeGreaterThan(1);
  expect(sent.slice(1).flat()).toEqual([]);
  expect(outcome.notices).toEqual(["the clip a does not move"]);
});

it("asks for the result at the end as such", async () => {
  const training = {
    step: () => ({ iteration: 1, done: true, reason: null }) as unknown as TrainingProgress,
    find: (isEnd: boolean) => (isEnd ? "result" : "best so far"),
  };
  const found: (string | null)[] = [];
  await follow(training, (report) => void found.push(report.found), new AbortController().signal);
  expect(found).toEqual(["result"]);
});
