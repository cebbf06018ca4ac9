import { beforeEach, expect, it } from "vitest";
import { FakeLab } from "../couplings/lab.fake";
import { settled } from "../engine/engine.fake";
import { FakeProgram } from "../engine/whole-workers.fake";
import { loadCompleting } from "../words/sections";
import { WordsStore } from "../words/words";
import { CompletingStore } from "./completing-store";
import { Recordings } from "./recordings";

let { model, stage, notices } = new FakeLab();
let whole: FakeProgram;
let completing: CompletingStore;
beforeEach(async () => {
  await loadCompleting(new WordsStore());
  const lab = new FakeLab();
  ({ model, stage, notices } = lab);
  whole = new FakeProgram();
  completing = new CompletingStore(new Recordings(lab.store, model, lab.clips, whole), model, stage, notices);
  await lab.start();
});

const kinds = () => [stage.content?.kind, stage.ghost !== null, completing.scores?.length ?? 0];

it("shows a recording that the model has completed, with the recording as an outline", async () => {
  completing.show();
  await settled();
  await settled();
  expect(kinds()).toEqual(["completed", true, 1]);
  expect(whole.completions.at(-1)).toMatchObject({ until: null, alpha: null });
  completing.hide();
  expect(kinds()).toEqual(["model", false, 0]);
});

it("asks again for other couplings, another part and an earlier end, and once for each", async () => {
  completing.show();
  await settled();
  completing.give(1);
  await settled();
  const [, last] = completing.times;
  completing.observeUntil(last / 2);
  await settled();
  completing.observeUntil(last / 2);
  model.couplings.set(0, 1, 2);
  await settled();
  await settled();
  expect(whole.completions.map(({ given, until, alpha }) => [given, until, alpha?.[0]?.[1]])).toEqual([
    [model.model?.info.parts[0]?.name, null, undefined],
    [model.model?.info.parts[1]?.name, null, undefined],
    [model.model?.info.parts[1]?.name, last / 2, undefined],
    [model.model?.info.parts[1]?.name, last / 2, 2],
  ]);
  completing.observeUntil(last);
  expect(completing.until).toBeNull();
});

it("ends with a notice when the recording is refused", async () => {
  whole.failures.push(new Error("the body differs"));
  completing.show();
  await settled();
  await settled();
  const found = [stage.content?.kind, completing.shown, notices.all.at(-1)?.text];
  expect(found).toEqual(["model", false, "the body differs"]);
});
