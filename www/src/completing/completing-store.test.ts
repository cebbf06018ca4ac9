import { beforeEach, expect, it } from "vitest";
import { HeldLab } from "../couplings/lab.fake";
import { loadCompleting } from "../words/sections";
import { WordsStore } from "../words/words";
import { CompletingStore } from "./completing-store";
import { Recordings } from "./recordings";

let { workers, store, model, clips, stage, notices } = new HeldLab();
let completing: CompletingStore;
beforeEach(async () => {
  await loadCompleting(new WordsStore());
  const lab = new HeldLab();
  ({ workers, store, model, clips, stage, notices } = lab);
  const recordings = new Recordings(lab.store, model, clips, workers);
  completing = new CompletingStore(recordings, model, stage, notices);
  await lab.start();
});

const asked = () => workers.asked("complete").map(([request]) => request);
const kinds = () => [stage.content?.kind, stage.ghost !== null, completing.scores?.length ?? 0];

it("shows a recording that the model has completed, with the recording as an outline", async () => {
  completing.show();
  await workers.settled();
  expect(kinds()).toEqual(["completed", true, 1]);
  expect(asked().at(-1)).toMatchObject({ until: null, alpha: null });
  expect(stage.ghost?.positions).not.toEqual(stage.content?.motion.positions);
  const seen: boolean[] = [];
  completing.on(() => seen.push(completing.shown));
  completing.hide();
  expect(kinds()).toEqual(["model", false, 0]);
  expect(seen).toEqual([false]);
});

it("asks again for other couplings, another part and an earlier end, and once for each", async () => {
  completing.show();
  await workers.settled();
  completing.give(1);
  await workers.settled();
  const [, last] = completing.times;
  completing.observeUntil(last / 2);
  await workers.settled();
  completing.observeUntil(last / 2);
  model.couplings.set(0, 1, 2);
  await workers.settled();
  expect(asked().map(({ given, until, alpha }) => [given, until, alpha?.[0]?.[1]])).toEqual([
    [model.model?.info.parts[0]?.name, null, undefined],
    [model.model?.info.parts[1]?.name, null, undefined],
    [model.model?.info.parts[1]?.name, last / 2, undefined],
    [model.model?.info.parts[1]?.name, last / 2, 2],
  ]);
  completing.observeUntil(last);
  expect(completing.until).toBeNull();
});

it("ends with a notice when the recording is refused", async () => {
  const bvh = await store.engine!.rolloutBvh(model.rolloutRequest());
  await clips.addModelled("tall", bvh.replace(/OFFSET .*/g, "OFFSET 0 20 0"));
  completing.show();
  await workers.settled();
  expect([stage.content?.kind, completing.shown]).toEqual(["model", false]);
  expect(notices.all.at(-1)?.text).toMatch(/^tall is not of the body of the model/);
});
