import { beforeEach, expect, it } from "vitest";
import type { ClipEntry } from "../clips/clips-store";
import { libraryText } from "../engine/library.fake";
import type { LibraryReport } from "../engine/library-protocol";
import type { Couplings } from "../engine/protocol";
import { FakeProgram, settled } from "../engine/whole-engine.fake";
import { NoticesStore } from "../ui/notices-store";
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

async function end(found: Couplings | null): Promise<void> {
  await settled();
  const training = program.libraries.fittings.at(-1);
  training?.report({ progress: { iteration: 9, fraction: 1 }, elapsed: 1.5, found } as LibraryReport<Couplings>);
  training?.end({ cancelled: false, reason: "settled" });
}

it("fits the combination that walks, and the sliders go back to what was found", async () => {
  const fitted = fitting.fit("a");
  await end(FITTED);
  await fitted;
  expect(program.libraries.fittings[0]?.job).toMatchObject({
    library: libraryText("first"),
    uses: [0, 3],
    clips: [{ id: 7, first: 5, end: 90 }],
  });
  expect(library.alpha).toEqual(FITTED);
  expect(library.altered).toBe(false);
  await fitting.fit("gone");
  expect(program.libraries.fittings).toHaveLength(1);
});

it("leaves another combination alone that was chosen meanwhile", async () => {
  const fitted = fitting.fit("a");
  library.choose(1, 2);
  await end(FITTED);
  await fitted;
  expect(library.alpha).not.toEqual(FITTED);
});

it("says why it failed", async () => {
  program.libraries.fittings.length = 0;
  program.unreachable = "offline";
  await fitting.fit("a");
  expect(fitting.ending).toEqual({ words: "offline", failed: true });
  expect(fitting.busy).toBe(false);
});
