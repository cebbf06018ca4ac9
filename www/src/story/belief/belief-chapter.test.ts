import { beforeEach, expect, it } from "vitest";
import type { SyntheticFindings, SyntheticTruth } from "../../engine/whole-protocol";
import { FakeProgram, settled } from "../../engine/whole-workers.fake";
import { words } from "../../words/en";
import type { WordsStore } from "../../words/words";
import { BeliefChapter } from "./belief-chapter";

let program: FakeProgram;
let chapter: BeliefChapter;
beforeEach(async () => {
  program = new FakeProgram();
  const store = { now: words } as unknown as WordsStore;
  chapter = new BeliefChapter(store, program, () => 0.4);
  chapter.arrive();
  await settled();
  program.draws.at(-1)?.end({ much: 10, latents: [[], []] } as unknown as SyntheticTruth);
  await settled();
});

/** Ends the training with these couplings from part 1 to part 2, and back. */
async function end(forth: number, back: number): Promise<void> {
  await settled();
  const verdict = { forth, back, forthIsRight: true, backIsRight: true };
  const found = { verdict } as SyntheticFindings;
  const training = program.trainings.at(-1)!;
  training.report({ progress: { iteration: 9, fraction: 1 }, elapsed: 1, found } as never);
  training.end({ cancelled: false, reason: "settled" });
  await settled();
}

it("gives nothing away before the guess, and opens the curtain only at a press", async () => {
  expect([chapter.guess(), chapter.control(), chapter.reveal()]).toEqual([
    words.chapters.belief.guess,
    null,
    null,
  ]);
  expect(chapter.lab(), "a link would name the truth").toEqual({ view: "synthetic" });
  expect(program.trainings).toHaveLength(0);
  chapter.guessed(chapter.round.truth);
  expect([chapter.guess(), chapter.belief, chapter.control()]).toEqual([null, null, null]);
  await end(2000, 2000);
  expect([chapter.belief, chapter.truth]).toEqual(["none", null]);
  expect(chapter.control()).not.toBeNull();
});

it("starts anew when the visitor comes back", async () => {
  chapter.guessed("ab");
  await settled();
  chapter.leave();
  expect(chapter.guess()).not.toBeNull();
  expect(chapter.truth).toBeNull();
});
