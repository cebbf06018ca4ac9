import { beforeEach, expect, it } from "vitest";
import type { ClipEntry } from "../clips/clips-store";
import { HeldWorkers } from "../engine/held.fake";
import type { Fitted } from "../engine/library-protocol";
import type { Couplings } from "../engine/protocol";
import { NoticesStore } from "../ui/notices-store";
import { FittingStore } from "./fitting-store";
import { libraryText } from "./learned.fake";
import { LibraryStore } from "./library-store";
import { fitText } from "./walk-couplings-view";

const clip = { key: "a", loaded: { id: 7 }, source: { sample: "walk-1" }, first: 5, end: 60 };
const AT_LIMIT: Couplings = [
  [0.015, 10],
  [10, 9.9999],
];

let workers: HeldWorkers;
let library: LibraryStore;
let fitting: FittingStore;
/** What the worker found last, and the couplings that it then answers instead. */
let found: Fitted | null;
let instead: Couplings | null;
beforeEach(async () => {
  workers = new HeldWorkers();
  [found, instead] = [null, null];
  workers.answer("fitCouplings", (real, job, report, signal) =>
    real(
      job,
      (now) => {
        found = now.found && { ...now.found, alpha: instead ?? now.found.alpha };
        return report({ ...now, found });
      },
      signal,
    ),
  );
  library = new LibraryStore(workers, new NoticesStore(), async () => libraryText(1));
  fitting = new FittingStore(workers, { all: [clip] as unknown as ClipEntry[] }, library);
  await library.openFirst();
});

it("fits the walking combination, and resets the sliders to the result", async () => {
  await fitting.fit("a");
  expect(workers.asked("fitCouplings").map(([job]) => job)).toMatchObject([
    { library: libraryText(1), uses: [0, 3], clips: [{ id: 7, first: 5, end: 60 }] },
  ]);
  expect(library.couplings.alpha).toEqual(found?.alpha);
  // The library stores the clip of the fit, unless a slider was moved since.
  await library.keep("mine");
  library.couplings.set(0, 1, 5);
  await library.keep("by hand");
  const [, , mine, byHand] = library.current!.info.movements;
  expect([mine?.couplings, byHand?.couplings]).toEqual([found?.from, { from: "hand" }]);
  await fitting.fit("gone");
  expect(workers.asked("fitCouplings")).toHaveLength(1);
});

it("can be undone: a reset brings the couplings of the primitives back", async () => {
  const { alpha } = library.couplings;
  await fitting.fit("a");
  expect(library.couplings.altered).toBe(true);
  library.couplings.resetAll();
  expect(library.couplings.alpha).toEqual(alpha);
});

it("names the part for which all couplings ended at their limit, and does not call this a success", async () => {
  instead = AT_LIMIT;
  await fitting.fit("a");
  expect(fitting.unexplained).toEqual(["upper"]);
  const { text, failed } = fitText(fitting);
  expect(failed).toBe(true);
  expect(text).toMatch(
    /^No coupling found for arms: .* limit, α = 10\. .* Reset undoes the fit\. \d\.\d s\.$/,
  );
  instead = null;
  await fitting.fit("a");
  expect(fitText(fitting)).toEqual({
    text: expect.stringMatching(/^The objective no longer rises\. \d\.\d s\.$/),
    failed: false,
  });
});

it("does not change a combination that was chosen meanwhile", async () => {
  workers.hold("fitCouplings");
  const fitted = fitting.fit("a");
  await workers.settled();
  library.choose(1, 2);
  await workers.settled();
  const { alpha } = library.couplings;
  workers.held("fitCouplings")[0]?.go();
  await fitted;
  expect(found?.alpha).toHaveLength(2);
  expect([library.couplings.alpha, library.couplings.altered]).toEqual([alpha, false]);
});

it("reports why it failed", async () => {
  workers.unreachable = "offline";
  await fitting.fit("a");
  expect(fitting.ending).toEqual({ words: "offline", failed: true });
  expect(fitting.busy).toBe(false);
});
