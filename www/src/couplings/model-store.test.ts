import { beforeEach, describe, expect, it, vi } from "vitest";
import { FakeLab } from "./lab.fake";
import { modelHash, modelText, settled } from "../engine/engine.fake";
import { readSettings, writeSettings } from "../settings/settings";
import { presetWords, START_PRESETS } from "./presets";

let { engine, settings, stage, notices, model, bar } = new FakeLab();

async function begin(fragment = "", sequences = 1): Promise<void> {
  const lab = new FakeLab(fragment);
  ({ engine, settings, stage, notices, model, bar } = lab);
  await lab.start(modelText(1, sequences), { couplings: "link", clip: false });
  await settled();
}
beforeEach(() => begin());

/** The weight of a coupling in the rollout on the stage. */
const weightOf = (source: number, target: number) => model.rollout?.weights[source]?.[target];

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
    const lab = new FakeLab();
    const write = vi.spyOn(lab.bar, "write");
    ({ settings, model, engine } = lab);
    await lab.start();
    const before = engine.rollouts.length;
    const listener = vi.fn(() => expect(write).not.toHaveBeenCalled());
    model.on(listener);
    model.couplings.set(0, 1, 7.123456789);
    expect(listener).toHaveBeenCalled();
    const alpha = [
      [1, 7.123456789],
      [4, 1],
    ];
    expect(engine.rollouts.slice(before)).toEqual([
      { frames: 300, sequence: 0, alpha, reading: "re-inferred" },
    ]);
    await settled();
    expect([model.couplings.alphaOf(0, 1), weightOf(0, 1), model.couplings.learnedAlpha(0, 1)]).toEqual([
      7.123456789, 7.123456789, 4,
    ]);
  });

  it("changes its weight before the motion has arrived", () => {
    engine.holding.add("rollout");
    expect(model.couplings.weightsInto(1)).toEqual([0.2, 0.8]);
    model.couplings.set(0, 1, 1);
    expect(model.couplings.weight(0, 1)).toBe(0.5);
  });

  it("drops older changes that still wait", async () => {
    engine.holding.add("rollout");
    for (let i = 1; i <= 20; i++) model.couplings.set(0, 1, 10 + i);
    expect(engine.held).toHaveLength(1);
    engine.held[0]?.end();
    await settled();
    expect(engine.held).toHaveLength(2);
    engine.held[1]?.end();
    await settled();
    expect(model.rollout?.request.alpha?.[0]?.[1]).toBe(30);
    expect(engine.held).toHaveLength(2);
  });

  it("shows the motion as learned as a ghost while it differs", async () => {
    model.couplings.set(0, 1, 8);
    expect(stage.ghost).toBe(model.learned?.motion);
    expect([
      model.couplings.altered,
      model.couplings.isChanged(0, 1),
      model.couplings.isChanged(1, 0),
    ]).toEqual([true, true, false]);
    model.couplings.set(0, 1, 4.01);
    expect([model.couplings.altered, stage.ghost]).toEqual([false, null]);
    await settled();
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
    engine.holding.add("rollout");
    model.couplings.set(0, 1, 8);
    engine.held[0]?.fail(new Error("not positive definite"));
    await settled();
    expect(notices.all.map(({ title, text }) => `${title}: ${text}`)).toEqual([
      "This rollout failed: not positive definite",
    ]);
    engine.holding.clear();
    model.couplings.set(0, 1, 9);
    await settled();
    expect(weightOf(0, 1)).toBe(9);
  });
});

describe("presets", () => {
  it("fit the parts, and set couplings and reading at once", async () => {
    expect(model.presets.map((preset) => presetWords(preset).name)).toContain("Arms alone");
    expect(model.preset?.id).toBe("as-learned");
    model.couplings.setReading("as-learned");
    stage.showClip(clip());
    const before = engine.rollouts.length;
    model.takePreset(model.presets.find(({ id }) => id === "1-alone")!);
    await settled();
    expect([model.preset?.id, settings.values.reading, stage.clip]).toEqual(["1-alone", "re-inferred", null]);
    expect(engine.rollouts.length - before).toBe(1);
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
    expect(bar.pages).toEqual([`model=${modelHash(3).slice(0, 8)}&alpha=0.1:8`, "view=play"]);
    bar.pages.pop();
    settings.readAddress();
    model.restart();
    expect([model.couplings.altered, model.link.model]).toEqual([false, modelHash(3).slice(0, 8)]);
    await model.open(modelText(3));
    expect(model.couplings.alphaOf(0, 1)).toBe(8);
  });

  it("keeps the couplings and the clip in front on request", async () => {
    model.couplings.set(0, 1, 8);
    stage.showClip(clip());
    await model.open(modelText(2), { couplings: "visitor", clip: true });
    await settled();
    expect([model.couplings.alphaOf(0, 1), weightOf(0, 1), stage.clip]).toEqual([8, 8, "a"]);
    expect(model.learned?.request.alpha).toBeNull();
  });

  it("drops the answer to a rollout of the model before", async () => {
    engine.holding.add("rollout");
    model.couplings.set(0, 1, 8);
    await model.open(modelText(2));
    const rollout = model.rollout;
    engine.held[0]?.end();
    await settled();
    expect(model.rollout).toBe(rollout);

    // The worker has opened a third model, and its answer has not arrived.
    engine.holding.add("openModel");
    engine.held.length = 0;
    const opened = model.open(modelText(3));
    model.couplings.set(0, 1, 9);
    engine.held.find(({ name }) => name === "rollout")?.end();
    await settled();
    expect(model.rollout).toBe(rollout);
    engine.held.find(({ name }) => name === "openModel")?.end();
    await opened;
    expect(model.model?.info.provenance.settings.seed).toBe(3);
  });

  it("keeps the model before where the new one cannot be opened", async () => {
    await expect(model.open("no model")).rejects.toThrow("expected a model");
    expect(model.model?.info.provenance.settings.seed).toBe(1);
  });
});

describe("the start", () => {
  it("can be in another sequence, for the ghost too", async () => {
    await begin("alpha=0.1:8", 3);
    model.setStart(2);
    await settled();
    expect([model.learned?.request.sequence, model.rollout?.request.sequence]).toEqual([2, 2]);
    expect([model.learned?.request.alpha, model.rollout?.request.alpha?.[0]?.[1]]).toEqual([null, 8]);
    expect(stage.ghost).toBe(model.learned?.motion);
  });

  it("needs only one rollout where no coupling differs", async () => {
    await begin("", 3);
    const before = engine.rollouts.length;
    model.setStart(1);
    await settled();
    expect(engine.rollouts.length - before).toBe(1);
    expect(model.rollout).toBe(model.learned);
    expect(model.rollout?.request.sequence).toBe(1);
  });

  it("can be any frame whose latents the model's file has", async () => {
    await begin("", 2);
    model.setStart(1, 40);
    await settled();
    expect(engine.rollouts.at(-1)).toMatchObject({ sequence: 1, frame: 40 });
    expect(model.learned?.request.frame).toBe(40);
    // A link has the frame and the model.
    expect([settings.values.startFrame, settings.values.model]).toEqual([40, model.id]);
    model.setStart(1, 500);
    expect(model.rolloutRequest().frame).toBe(88);
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
    engine.holding.add("rollout");
    model.setStart(1);
    await model.open(modelText(2, 3));
    engine.held[0]?.end();
    await settled();
    expect(model.learned?.request.sequence).toBe(0);
  });
});

it("takes couplings from a changed address", async () => {
  await begin("alpha=0.1:50");
  expect(weightOf(0, 1)).toBe(50);
  bar.pages.push("alpha=1.0:3");
  settings.readAddress();
  model.restart();
  await settled();
  expect([weightOf(0, 1), weightOf(1, 0)]).toEqual([4, 3]);
  bar.pages.push("alpha=2.2:3");
  settings.readAddress();
  model.restart();
  expect(settings.values.alpha).toEqual({});
});

describe("a link", () => {
  const id = (seed: number) => modelHash(seed).slice(0, 8);

  it("names the model whose couplings or start it carries, and no model otherwise", async () => {
    await begin("", 3);
    expect(settings.values.model).toBe("");
    model.couplings.set(0, 1, 8);
    expect(settings.values.model).toBe(id(1));
    model.couplings.resetAll();
    expect(settings.values.model).toBe("");
    model.setStart(1);
    expect(settings.values.model).toBe(id(1));
  });

  it("to another model changes nothing until that model is opened", async () => {
    await begin(`model=${id(2)}&alpha=0.1:8&start=1`, 3);
    expect([model.couplings.altered, settings.values.start, model.link.model]).toEqual([false, 0, id(2)]);
    await model.open(modelText(3, 3));
    expect([model.couplings.altered, model.link.model]).toEqual([false, id(2)]);
    await model.open(modelText(2, 3));
    await settled();
    const found = [model.couplings.alphaOf(0, 1), model.link.model, model.rollout?.request.sequence];
    expect(found).toEqual([8, null, 1]);
    expect(settings.values.model).toBe(id(2));
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
    expect([weightOf(0, 1), model.link.model]).toEqual([8, null]);
    await begin("alpha=0.1:8");
    expect([weightOf(0, 1), settings.values.model]).toEqual([8, id(1)]);
  });

  it("keeps the visitor's couplings from one model of a training to the next", async () => {
    model.couplings.set(0, 1, 8);
    await model.open(modelText(2), { couplings: "visitor", clip: false });
    await settled();
    expect([model.couplings.alphaOf(0, 1), settings.values.model]).toEqual([8, id(2)]);
  });
});

describe("samples", () => {
  it("play in place of the mean, another one in each loop, under the couplings now", async () => {
    const seeds = () => engine.rollouts.map(({ sample }) => sample);
    model.nextSample();
    expect(seeds()).toEqual([]);
    model.playSamples(true);
    await settled();
    // The motion as learned stays the mean.
    expect([seeds(), model.rollout?.request.sample, model.learned?.request.sample]).toEqual([
      [undefined, 1],
      1,
      undefined,
    ]);
    model.nextSample();
    await settled();
    model.couplings.set(0, 1, 7);
    await settled();
    expect([model.rollout?.request.sample, weightOf(0, 1)]).toEqual([2, 7]);
    expect(writeSettings(settings.values)).toContain("samples=1");
    model.playSamples(false);
    await settled();
    expect([model.rollout?.request.sample, weightOf(0, 1)]).toEqual([undefined, 7]);
    model.playSamples(true);
    stage.showClip(clip());
    const before = engine.rollouts.length;
    await settled();
    model.nextSample();
    await settled();
    expect(engine.rollouts.length - before).toBeLessThanOrEqual(1);
  });
});

describe("the length", () => {
  it("is set in seconds within the limits, for the ghost too", async () => {
    model.couplings.set(0, 1, 8);
    model.setSeconds(5);
    await settled();
    expect([model.rollout?.request.frames, model.learned?.request.frames]).toEqual([150, 150]);
    model.setSeconds(1e6);
    await settled();
    expect(model.rollout?.motion.frames).toBe(1200);
  });
});
