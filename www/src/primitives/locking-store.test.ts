import { beforeEach, expect, it } from "vitest";
import { libraryText } from "../engine/library.fake";
import { FakeProgram, settled } from "../engine/whole-workers.fake";
import { NoticesStore } from "../ui/notices-store";
import { LibraryStore } from "./library-store";
import { LockingStore, STRENGTHS, TEMPOS } from "./locking-store";

let program: FakeProgram;
let library: LibraryStore;
let locking: LockingStore;
beforeEach(async () => {
  program = new FakeProgram();
  library = new LibraryStore(program, new NoticesStore(), async () => libraryText("first"));
  locking = new LockingStore(program, library);
  await library.openFirst();
});

it("asks for one row for each tempo, and contains the learned coupling and tempo", async () => {
  await locking.make();
  expect(program.libraries.rows.map(({ tempo }) => tempo)).toEqual(TEMPOS);
  expect(program.libraries.rows[0]).toMatchObject({
    uses: [0, 3],
    source: 0,
    target: 1,
    strengths: STRENGTHS,
  });
  expect([TEMPOS.includes(1), STRENGTHS.includes(1)]).toEqual([true, true]);
  expect(locking.fraction).toBe(1);
  expect(locking.busy).toBe(false);
  expect(locking.map?.rows[0]?.length).toBe(STRENGTHS.length);
  expect(locking.taken).toEqual({ tempo: 1, strength: 1 });
});

it("gives the figure the tempo and the coupling of a point", async () => {
  await locking.make();
  library.setTempo(0, 0.8);
  locking.take(1.3, 4);
  expect(library.tempos).toEqual([1, 1.3]);
  expect(library.couplings.alpha).toEqual([
    [1, 0.5],
    [3, 4],
  ]);
  expect(locking.taken).toEqual({ tempo: 1.3, strength: 4 });
  library.setTempo(1, 0.61);
  expect(locking.taken).toBeNull();
});

it("is dropped when the library or the fitted couplings change, and then uses the couplings of the figure", async () => {
  await locking.make();
  library.couplings.set(0, 1, 0.7);
  expect(locking.map, "the map varies this coupling itself").not.toBeNull();
  const alpha = [
    [0.5, 2],
    [3, 4],
  ];
  library.takeFitted([0, 3], { alpha, from: { from: "clips", bound: 1, iterations: 1 } });
  expect(locking.map).toBeNull();
  await locking.make();
  expect(program.libraries.rows.at(-1)?.alpha).toEqual(alpha);
  await library.open(libraryText("learned"), "The library learned here", true);
  expect(locking.map).toBeNull();
});

it("measures how much the tempo and the strength change the locking", async () => {
  expect(locking.effects).toBeNull();
  await locking.make();
  // The worker of this test answers 1 / tempo for every strength.
  expect(locking.effects?.tempo).toBeCloseTo(1 / 0.7 - 1 / 1.3, 12);
  expect(locking.effects?.strength).toBe(0);
});

it("is dropped with another combination or pair of parts", async () => {
  await locking.make();
  library.choose(1, 2);
  expect(locking.map).toBeNull();
  await locking.make();
  locking.choose(1, 0);
  expect(locking.map).toBeNull();
  await locking.make();
  await settled();
  expect(program.libraries.rows.at(-1)).toMatchObject({ uses: [0, 2], source: 1, target: 0 });
});
