import { expect, it } from "vitest";
import { workerTrouble } from "./running";

it("tells a worker that could not be loaded from one that stopped", () => {
  // A browser reports a script that it could not fetch with an event that has neither message nor line.
  expect(workerTrouble({} as ErrorEvent)).toMatch(/could not be loaded.*online/);
  expect(workerTrouble({ message: "out of memory", lineno: 7 })).toBe(
    "the worker that computed it stopped (out of memory)",
  );
});
