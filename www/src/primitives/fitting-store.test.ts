import { beforeEach, expect, it } from "vitest";
import { progress } from "../engine/engine.fake";
import type { ClipEntry } from "../clips/clips-store";
import { libraryText } from "../engine/library.fake";
import type { Fitted } from "../engine/library-protocol";
import type { TrainingReport, Couplings } from "../engine/protocol";
import { FakeProgram, settled } from "../engine/whole-workers.fake";
import { NoticesStore } from "../ui/notices-store";
import { fitText } from "./walk-couplings-view";
import { FittingStore } from "./fitting-store";
import { LibraryStore } from "./library-store";

const clip = { key: "a", loaded: { id: 7 }, source: { sample: "walk-1" }, first: 5, end: 90 };
const FITTED: Couplings = [
  [0.1, 0.2],
  [0.3, 0.4],
];

let program: FakeProgram;
let library: LibraryStore;
let fitting: FittingStore;
beforeEach(async () => {
  program = new FakeProgram();
  library = new LibraryStore(program, new NoticesStore(), async () => libraryText("first"));
  fitting = new FittingStore(program, { all: [clip] as unknown as ClipEntry[] }, library);
  await library.openFirst();
});

const FROM = { from: "clips", bound: 12, iterations: 9 } as const;

async function end(alpha: Couplings): Promise<void> {
  await settled();
  const training = program.libraries.fittings.at(-1);
  const found = { alpha, from: FROM };
  training?.report({
    progress: { ...progress(9), fraction: 1 },
    elapsed: 1.5,
    found,
  } as TrainingReport<Fitted>);
  training?.end({ cancelled: false, reason: "settled" });
}

it("fits the walking combination, and resets the sliders to the result", async () => {
  const fitted = fitting.fit("a");
  await end(FITTED);
  await fitted;
  expect(program.libraries.fittings[0]?.job).toMatchObject({
    library: libraryText("first"),
    uses: [0, 3],
    clips: [{ id: 7, first: 5, end: 90 }],
  });
  expect(library.couplings.alpha).toEqual(FITTED);
  // The library stores the clip of the fit, unless a slider was moved since.
  await library.keep("mine");
  library.couplings.set(0, 1, 5);
  await library.keep("by hand");
  expect(program.libraries.origins).toEqual([FROM, null]);
  await fitting.fit("gone");
  expect(program.libraries.fittings).toHaveLength(1);
});

it("can be undone: a reset brings the couplings of the primitives back", async () => {
  const { alpha } = library.couplings;
  const fitted = fitting.fit("a");
  await end(FITTED);
  await fitted;
  expect(library.couplings.altered).toBe(true);
  library.couplings.resetAll();
  expect(library.couplings.alpha).toEqual(alpha);
});

it("names the part for which all couplings ended at their limit, and does not call this a success", async () => {
  const fitted = fitting.fit("a");
  await end([
    [0.015, 10],
    [10, 9.9999],
  ]);
  await fitted;
  expect(fitting.unexplained).toEqual(["upper"]);
  const { text, failed } = fitText(fitting);
  expect(failed).toBe(true);
  expect(text).toMatch(/^No coupling found for arms: .* limit, α = 10\. .* Reset undoes the fit\. 1\.5 s\.$/);
  const again = fitting.fit("a");
  await end(FITTED);
  await again;
  expect(fitText(fitting)).toEqual({ text: "The objective no longer rises. 1.5 s.", failed: false });
});

it("does not change a combination that was chosen meanwhile", async () => {
  const fitted = fitting.fit("a");
  library.choose(1, 2);
  await end(FITTED);
  await fitted;
  expect(library.couplings.alpha).not.toEqual(FITTED);
});

it("reports why it failed", async () => {
  program.libraries.fittings.length = 0;
  program.unreachable = "offline";
  await fitting.fit("a");
  expect(fitting.ending).toEqual({ words: "offline", failed: true });
  expect(fitting.busy).toBe(false);
});
