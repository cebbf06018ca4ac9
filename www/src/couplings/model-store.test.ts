import { beforeEach, describe, expect, it, vi } from "vitest";
import { HeldLab } from "./lab.fake";
import { modelText } from "../engine/documents.fake";
import { hashOf } from "../engine/held.fake";
import { readSettings, writeSettings } from "../settings/settings";
import { presetWords, START_PRESETS } from "./presets";

let { workers, settings, stage, notices, model, bar } = new HeldLab();

async function begin(fragment = "", sequences = 1): Promise<void> {
  const lab = new HeldLab(fragment);
  ({ workers, settings, stage, notices, model, bar } = lab);
  await lab.start(modelText(1, sequences), { couplings: "link", clip: false });
  await workers.settled();
}
beforeEach(() => begin());

/** The start of the hash of a model. */
const id = (seed: number, sequences = 1) => hashOf(modelText(seed, sequences)).slice(0, 8);
const rollouts = () => workers.asked("rollout").map(([request]) => request);
const held = () => workers.held("rollout");

/** A coupling of the rollout on the stage, whose weights follow from it. */
function rolledOut(source: number, target: number): number | undefined {
  const { request, weights } = model.rollout!;
  expect(weights[source]?.[target]).toBeCloseTo(model.couplings.weight(source, target), 12);
  return (request.alpha ?? model.couplings.learned)[source]?.[target];
}

const clip = () => ({
  kind: "clip" as const,
  clip: "a",
  figure: { nodes: [] },
  joints: [],
  parts: [],
  motion: { positions: new Float32Array(60), frames: 10, nodes: 2, frameTime: 0.1 },
});

describe("a coupling", () => {
  it("asks for one rollout with the exact value, before the address is written", async () => {
    const lab = new HeldLab();
    const write = vi.spyOn(lab.bar, "write");
    ({ settings, model, workers } = lab);
    await lab.start();
    const listener = vi.fn(() => expect(write).not.toHaveBeenCalled());
    model.on(listener);
    model.couplings.set(0, 1, 7.123456789);
    expect(listener).toHaveBeenCalled();
    const learned = model.model!.info.alpha;
    const alpha = [[learned[0]![0], 7.123456789], learned[1]];
    await workers.settled();
    expect(rollouts()).toEqual([{ frames: 300, sequence: 0, alpha, reading: "re-inferred" }]);
    expect([model.couplings.alphaOf(0, 1), rolledOut(0, 1), model.couplings.learnedAlpha(0, 1)]).toEqual([
      7.123456789,
      7.123456789,
      learned[0]![1],
    ]);
  });

  it("changes its weight before the motion has arrived", () => {
    workers.hold("rollout");
    const into = model.couplings.weightsInto(1);
    expect(into).toEqual(model.rollout!.weights.map((row) => expect.closeTo(row[1]!, 12)));
    model.couplings.set(0, 1, model.couplings.alphaOf(1, 1));
    expect(model.couplings.weight(0, 1)).toBe(0.5);
  });

  it("drops older changes that still wait", async () => {
    workers.hold("rollout");
    for (let i = 1; i <= 20; i++) model.couplings.set(0, 1, 10 + i);
    for (let count = 1; count <= 2; count++) {
      await workers.settled();
      expect(held()).toHaveLength(count);
      held()[count - 1]!.go();
    }
    await workers.settled();
    expect([rolledOut(0, 1), held().length]).toEqual([30, 2]);
  });

  it("shows the motion as learned as a ghost while it differs", async () => {
    model.couplings.set(0, 1, 8);
    expect(stage.ghost).toBe(model.learned?.motion);
    await workers.settled();
    expect(model.rollout?.motion.positions).not.toEqual(stage.ghost?.positions);
    expect([
      model.couplings.altered,
      model.couplings.isChanged(0, 1),
      model.couplings.isChanged(1, 0),
    ]).toEqual([true, true, false]);
    model.couplings.set(0, 1, 1.002 * model.couplings.learnedAlpha(0, 1));
    expect([model.couplings.altered, stage.ghost]).toEqual([false, null]);
    await workers.settled();
    expect(model.rollout?.request.alpha).toBeNull();
  });

  it("takes a clip off the stage", () => {
    stage.showClip(clip());
    model.couplings.set(0, 1, 8);
    expect(stage.clip).toBeNull();
  });

  it("is reset alone or with all others", () => {
    model.couplings.set(0, 1, 8);
    model.couplings.set(1, 0, 9);
    model.couplings.reset(0, 1);
    expect(settings.values.alpha).toEqual({ "1.0": 9 });
    model.couplings.resetAll();
    expect(settings.values.alpha).toEqual({});
  });

  it("reports a failed rollout, and computes the next one", async () => {
    workers.hold("rollout");
    model.couplings.set(0, 1, 8);
    await workers.settled();
    held()[0]!.fail(new Error("not positive definite"));
    await workers.settled();
    expect(notices.all.map(({ title, text }) => `${title}: ${text}`)).toEqual([
      "This rollout failed: not positive definite",
    ]);
    workers.letGo("rollout");
    model.couplings.set(0, 1, 9);
    await workers.settled();
    expect(rolledOut(0, 1)).toBe(9);
  });
});

describe("presets", () => {
  it("fit the parts, and set couplings and reading at once", async () => {
    expect(model.presets.map((preset) => presetWords(preset).name)).toContain("Arms alone");
    expect(model.preset?.id).toBe("as-learned");
    model.couplings.setReading("as-learned");
    stage.showClip(clip());
    await workers.settled();
    const before = rollouts().length;
    model.takePreset(model.presets.find(({ id }) => id === "1-alone")!);
    await workers.settled();
    expect([model.preset?.id, settings.values.reading, stage.clip]).toEqual(["1-alone", "re-inferred", null]);
    expect(rollouts().length - before).toBe(1);
    model.couplings.setReading("as-learned");
    expect(model.preset).toBeNull();
  });

  it("give the visitor's reading back with a reset", () => {
    const other = model.presets.find(({ id }) => id === "1-alone")!;
    model.couplings.setReading("as-learned");
    model.takePreset(other);
    model.couplings.set(0, 1, 8);
    model.couplings.resetAll();
    expect([model.couplings.altered, settings.values.reading]).toEqual([false, "as-learned"]);
  });

  it("of the model that comes with the page are used again when it is opened again", async () => {
    await model.openStart(modelText(1));
    expect(model.presets).toBe(START_PRESETS);
    await model.open(modelText(2));
    expect(model.presets).not.toBe(START_PRESETS);
    await model.open(modelText(1));
    expect(model.presets).toBe(START_PRESETS);
  });
});

describe("another model", () => {
  it("drops the couplings of the model before, and brings its training latents", async () => {
    model.couplings.set(0, 1, 8);
    const latents = [new Float64Array(2)];
    await model.open(modelText(2), undefined, latents);
    const found = [model.couplings.altered, stage.ghost, model.model?.trainingLatents];
    expect(found).toEqual([false, null, latents]);
    expect(model.model?.info.provenance.settings.seed).toBe(2);
  });

  it("is another page of the browser: Back brings the couplings of the model before", async () => {
    await model.open(modelText(3));
    expect(bar.pages).toHaveLength(1);
    model.couplings.set(0, 1, 8);
    await model.open(modelText(2));
    expect(bar.pages).toEqual([`model=${id(3)}&alpha=0.1:8`, "view=play"]);
    bar.pages.pop();
    settings.readAddress();
    model.restart();
    expect([model.couplings.altered, model.link.model]).toEqual([false, id(3)]);
    await model.open(modelText(3));
    expect(model.couplings.alphaOf(0, 1)).toBe(8);
  });

  it("keeps the couplings and the clip in front on request", async () => {
    model.couplings.set(0, 1, 8);
    stage.showClip(clip());
    await model.open(modelText(2), { couplings: "visitor", clip: true });
    await workers.settled();
    expect([model.couplings.alphaOf(0, 1), rolledOut(0, 1), stage.clip]).toEqual([8, 8, "a"]);
    expect(model.learned?.request.alpha).toBeNull();
  });

  it("drops the answer to a rollout of the model before", async () => {
    workers.hold("rollout");
    model.couplings.set(0, 1, 8);
    await workers.settled();
    const end = await held()[0]!.late();
    await model.open(modelText(2));
    const { rollout } = model;
    end();
    await workers.settled();
    expect(model.rollout).toBe(rollout);

    // The worker has opened a third model, and its answer has not arrived.
    workers.hold("openModel");
    const opened = model.open(modelText(3));
    await workers.settled();
    const answer = await workers.held("openModel")[0]!.late();
    model.couplings.set(0, 1, 9);
    await workers.settled();
    held()[1]!.go();
    await workers.settled();
    expect(model.rollout).toBe(rollout);
    answer();
    await opened;
    expect(model.model?.info.provenance.settings.seed).toBe(3);
  });

  it("keeps the model before where the new one cannot be opened", async () => {
    await expect(model.open("no model")).rejects.toThrow(/^expected a model as JSON/);
    expect(model.model?.info.provenance.settings.seed).toBe(1);
  });
});

describe("the start", () => {
  it("can be in another sequence, for the ghost too", async () => {
    await begin("alpha=0.1:8", 3);
    model.setStart(2);
    await workers.settled();
    expect([model.learned?.request.sequence, model.rollout?.request.sequence]).toEqual([2, 2]);
    expect([model.learned?.request.alpha, model.rollout?.request.alpha?.[0]?.[1]]).toEqual([null, 8]);
    expect(stage.ghost).toBe(model.learned?.motion);
  });

  it("needs only one rollout where no coupling differs", async () => {
    await begin("", 3);
    const before = rollouts().length;
    model.setStart(1);
    await workers.settled();
    expect(rollouts().length - before).toBe(1);
    expect(model.rollout).toBe(model.learned);
    expect(model.rollout?.request.sequence).toBe(1);
  });

  it("can be any frame whose latents the model's file has", async () => {
    const document = JSON.parse(modelText(1, 2)) as { sequences: { start: number[][][] }[] };
    const next = ([first]: number[][]) => [1, 2, 3].map((factor) => first!.map((value) => factor * value));
    document.sequences[1]!.start = document.sequences[1]!.start.map(next);
    await model.open(JSON.stringify(document));
    model.setStart(1, 1);
    await workers.settled();
    expect(rollouts().at(-1)).toMatchObject({ sequence: 1, frame: 1 });
    const [, start] = document.sequences[1]!.start[0]!;
    expect([...model.learned!.latents[0]!.slice(0, 2)]).toEqual(start);
    // A link has the frame and the model.
    expect([settings.values.startFrame, settings.values.model]).toEqual([1, model.id]);
    model.setStart(1, 500);
    expect(model.rolloutRequest().frame).toBe(2);
    model.setStart(0);
    expect(model.rolloutRequest()).toEqual({ frames: 300, sequence: 0, alpha: null, reading: "as-learned" });
  });

  it("comes from the address, or is the first where the model has no such sequence", async () => {
    await begin("start=1", 2);
    expect(model.rollout?.request.sequence).toBe(1);
    await begin("start=5", 2);
    expect([settings.values.start, model.rollout?.request.sequence]).toEqual([0, 0]);
  });

  it("of another model drops a rollout that was under way", async () => {
    await begin("", 3);
    workers.hold("rollout");
    model.setStart(1);
    await workers.settled();
    const end = await held()[0]!.late();
    await model.open(modelText(2, 3));
    end();
    await workers.settled();
    expect(model.learned?.request.sequence).toBe(0);
  });
});

it("takes couplings from a changed address", async () => {
  await begin("alpha=0.1:50");
  expect(rolledOut(0, 1)).toBe(50);
  bar.pages.push("alpha=1.0:3");
  settings.readAddress();
  model.restart();
  await workers.settled();
  expect([rolledOut(0, 1), rolledOut(1, 0)]).toEqual([model.couplings.learnedAlpha(0, 1), 3]);
  bar.pages.push("alpha=2.2:3");
  settings.readAddress();
  model.restart();
  expect(settings.values.alpha).toEqual({});
});

describe("a link", () => {
  it("names the model whose couplings or start it carries, and no model otherwise", async () => {
    await begin("", 3);
    expect(settings.values.model).toBe("");
    model.couplings.set(0, 1, 8);
    expect(settings.values.model).toBe(id(1, 3));
    model.couplings.resetAll();
    expect(settings.values.model).toBe("");
    model.setStart(1);
    expect(settings.values.model).toBe(id(1, 3));
  });

  it("to another model changes nothing until that model is opened", async () => {
    await begin(`model=${id(2, 3)}&alpha=0.1:8&start=1`, 3);
    expect([model.couplings.altered, settings.values.start, model.link.model]).toEqual([false, 0, id(2, 3)]);
    await model.open(modelText(3, 3));
    expect([model.couplings.altered, model.link.model]).toEqual([false, id(2, 3)]);
    await model.open(modelText(2, 3));
    await workers.settled();
    const found = [model.couplings.alphaOf(0, 1), model.link.model, model.rollout?.request.sequence];
    expect(found).toEqual([8, null, 1]);
    expect(settings.values.model).toBe(id(2, 3));
  });

  it("stays in the address while it waits, so that a reload does not lose it", async () => {
    const link = `model=${id(2)}&alpha=0.1:8&start=1`;
    await begin(link, 3);
    settings.change({ latent: 4 });
    const written = () => writeSettings(settings.written);
    expect(readSettings(written())).toEqual({ ...readSettings(link), latent: 4 });
    model.forgetLink();
    expect(written()).toBe("latent=4");
  });

  it("stops waiting when the visitor moves a slider or forgets it", async () => {
    await begin(`model=${id(2)}&alpha=0.1:8`);
    model.couplings.set(1, 0, 9);
    expect(model.link.model).toBeNull();
    await begin(`model=${id(2)}&alpha=0.1:8`);
    model.forgetLink();
    await model.open(modelText(2));
    expect(model.couplings.altered).toBe(false);
  });

  it("to this model, or without the name of a model, brings its couplings", async () => {
    await begin(`model=${id(1)}&alpha=0.1:8`);
    expect([rolledOut(0, 1), model.link.model]).toEqual([8, null]);
    await begin("alpha=0.1:8");
    expect([rolledOut(0, 1), settings.values.model]).toEqual([8, id(1)]);
  });

  it("keeps the visitor's couplings from one model of a training to the next", async () => {
    model.couplings.set(0, 1, 8);
    await model.open(modelText(2), { couplings: "visitor", clip: false });
    await workers.settled();
    expect([model.couplings.alphaOf(0, 1), settings.values.model]).toEqual([8, id(2)]);
  });
});

describe("samples", () => {
  it("play in place of the mean, another one in each loop, under the couplings now", async () => {
    const seeds = () => rollouts().map(({ sample }) => sample);
    model.nextSample();
    expect(seeds()).toEqual([]);
    model.playSamples(true);
    await workers.settled();
    // The motion as learned stays the mean.
    expect([seeds(), model.rollout?.request.sample, model.learned?.request.sample]).toEqual([
      [undefined, 1],
      1,
      undefined,
    ]);
    model.nextSample();
    await workers.settled();
    model.couplings.set(0, 1, 7);
    await workers.settled();
    expect([model.rollout?.request.sample, rolledOut(0, 1)]).toEqual([2, 7]);
    expect(writeSettings(settings.values)).toContain("samples=1");
    model.playSamples(false);
    await workers.settled();
    expect([model.rollout?.request.sample, rolledOut(0, 1)]).toEqual([undefined, 7]);
    model.playSamples(true);
    stage.showClip(clip());
    await workers.settled();
    const before = rollouts().length;
    model.nextSample();
    await workers.settled();
    expect(rollouts().length).toBe(before);
  });
});

describe("the length", () => {
  it("is set in seconds within the limits, for the ghost too", async () => {
    model.couplings.set(0, 1, 8);
    model.setSeconds(50);
    await workers.settled();
    expect([model.rollout?.request.frames, model.learned?.request.frames]).toEqual([100, 100]);
    model.setSeconds(1e6);
    await workers.settled();
    expect(model.rollout?.motion.frames).toBe(1200);
  });
});
