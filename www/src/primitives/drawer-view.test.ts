import { expect, it } from "vitest";
import type { PrimitiveOrigin } from "../engine/library-protocol";
import { originText } from "./drawer-view";

const clips = ["walk-1", "walk-2", "walk-2", "walk-3"].map((name) => ({ name })) as PrimitiveOrigin["clips"];
const origin: PrimitiveOrigin = {
  ...{ engine: "vcgpdm", seed: 8, bound: 12, iterations: 400, note: null, relearned: null, clips },
};

it("names the clips that a primitive learned from, and the primitive that it was learned after", () => {
  expect(originText(origin)).toBe("Learned from walk-1, walk-2 and 1 more; 400 iterations, seed 8.");
  const relearned = { primitive: "walk", frames: "remembered" as const, clips: clips.slice(0, 1) };
  expect(originText({ ...origin, relearned, note: "Thanks." })).toBe(
    "Learned again, after walk of another library, which learned from walk-1: from what its file kept of them; 400 iterations, seed 8. Thanks.",
  );
});
