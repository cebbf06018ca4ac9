import { describe, expect, it } from "vitest";
import { progress } from "../engine/documents.fake";
import { goingWords } from "./progress-row";
import { ProgressStore } from "./progress-store";

describe("the status of a running training", () => {
  it("says the phase, and the remaining time once it is known", async () => {
    const store = new ProgressStore<string>();
    expect(goingWords(store)).toEqual([]);
    const statuses: string[][] = [];
    await store.run(async (report) => {
      statuses.push(goingWords(store));
      const halfway = { ...progress(7), fraction: 0.5 };
      report({ steps: [], progress: halfway, elapsed: 0.2, found: null });
      statuses.push(goingWords(store));
      report({ steps: [], progress: halfway, elapsed: 8, found: "this" });
      statuses.push(goingWords(store));
      store.cancel();
      statuses.push(goingWords(store));
      return { cancelled: true, reason: null };
    });
    expect(statuses).toEqual([
      ["Setting up"],
      ["Iteration 7", "Estimating the time left."],
      ["Iteration 7", "At most 8 s left."],
      ["Stopping"],
    ]);
    expect(goingWords(store)).toEqual([]);
  });
});
