import { expect, it } from "vitest";
import type { AddedResult, FinishedJob, ResultsView } from "../engine/whole-protocol";
import { withResult } from "./comparison-entry";

const finished = (id: string) => ({ id }) as FinishedJob;
const added = (id: string, place: number): AddedResult => ({
  state: 1,
  text: `"${id}"`,
  isWhole: false,
  finished: finished(id),
  place,
  comparison: {} as AddedResult["comparison"],
});
const none = { text: '{"finished":[]}', finished: [] as FinishedJob[] } as ResultsView;

it("adds a result at the end of the file, and in the order of the tables", () => {
  const both = withResult(withResult(none, added("b", 0)), added("a", 0));
  expect(JSON.parse(both.text)).toEqual({ finished: ["b", "a"] });
  expect(both.finished.map(({ id }) => id)).toEqual(["a", "b"]);
});

it("takes the whole file when the result takes the place of a failure", () => {
  const failed = withResult(none, added("a", 0));
  const again = withResult(failed, { ...added("a", 0), isWhole: true, text: '{"finished":["again"]}' });
  expect([again.text, again.finished.length]).toEqual(['{"finished":["again"]}', 1]);
});
