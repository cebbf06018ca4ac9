import { expect, it } from "vitest";
import { Latest } from "./latest";

function slow() {
  const open: { request: number; answer: (value: number) => void; fail: (problem: Error) => void }[] = [];
  const ask = (request: number) =>
    new Promise<number>((answer, fail) => open.push({ request, answer, fail }));
  return { open, ask };
}
const settle = () => new Promise((resolve) => setTimeout(resolve, 0));

it("asks for the newest only, and one at a time", async () => {
  const { open, ask } = slow();
  const results: number[] = [];
  const latest = new Latest(
    ask,
    (result) => results.push(result),
    () => {},
  );
  for (const n of [1, 2, 3, 4]) latest.request(n);
  expect(open.map(({ request }) => request)).toEqual([1]);
  open[0]!.answer(10);
  await settle();
  expect(open.map(({ request }) => request)).toEqual([1, 4]);
  open[1]!.answer(40);
  await settle();
  expect(results).toEqual([10, 40]);
});

it("goes on after a failure, and forgets what was dropped", async () => {
  const { open, ask } = slow();
  const results: number[] = [];
  const problems: unknown[] = [];
  const latest = new Latest(
    ask,
    (result) => results.push(result),
    (problem) => problems.push(problem),
  );
  latest.request(1);
  open[0]!.fail(new Error("no"));
  await settle();
  latest.request(2);
  latest.drop();
  open[1]!.answer(20);
  await settle();
  latest.request(3);
  open[2]!.answer(30);
  await settle();
  expect(problems).toHaveLength(1);
  expect(results).toEqual([30]);
});
