import { beforeEach, describe, expect, it } from "vitest";
import { bvhText } from "../engine/documents.fake";
import { EngineStore } from "../engine/engine-store";
import { HeldWorkers } from "../engine/held.fake";
import { FakeAddressBar } from "../settings/address.fake";
import { SettingsStore } from "../settings/settings-store";
import { Playback } from "../stage/playback";
import { StageStore } from "../stage/stage-store";
import { ClipsStore } from "./clips-store";

let workers: HeldWorkers;
let stage: StageStore;
let clips: ClipsStore;
beforeEach(async () => {
  workers = new HeldWorkers();
  workers.bring("walk-1", "walk-2", "walk-wave-1");
  const [settings, store] = [new SettingsStore(new FakeAddressBar()), new EngineStore()];
  stage = new StageStore(new Playback(settings));
  clips = new ClipsStore(store, settings, stage);
  await store.start(
    async () => workers.started(),
    async () => {},
  );
  const motion = { positions: new Float32Array(60), frames: 10, nodes: 2, frameTime: 0.1 };
  stage.showModel({ kind: "first", figure: { nodes: [] }, joints: [], parts: [], motion });
  await clips.loadSamples();
});

const file = (name: string, text = bvhText()) => new File([text], name);
const tickedKeys = () => clips.ticked.map(({ key }) => key);

describe("the clips that come with the page", () => {
  it("are all loaded, with the walks ticked", () => {
    expect(clips.samplesLoaded).toBe(true);
    expect(clips.all.map(({ key, ticked }) => [key, ticked])).toEqual([
      ["made-walk-1", true],
      ["made-walk-2", true],
      ["made-walk-wave-1", false],
    ]);
  });

  it("of passing a bottle come when asked for, ticked alone, and again in a later visit", async () => {
    await clips.loadMade("pass a bottle");
    expect(tickedKeys()).toEqual(Array.from({ length: 10 }, (_, k) => `made-bottle-${k + 1}`));
    expect([stage.clip, clips.all.length]).toEqual(["made-bottle-1", 13]);
    const stored = clips.stored.find(({ key }) => key === "made-bottle-2")!;
    await clips.remove("made-bottle-2");
    expect(await clips.takeUp(stored)).toBe(clips.all.at(-1)?.loaded.id);
    expect(clips.all.at(-1)).toMatchObject({ key: "made-bottle-2", source: { sample: "bottle-2" } });
  });

  it("are unticked when a visitor opens clips, of which the first goes on the stage", async () => {
    await clips.open(file("mine.bvh"), true);
    await clips.open(file("other.bvh"), false);
    expect(tickedKeys()).toEqual(["own-4", "own-5"]);
    expect(clips.toTrainOn.map(({ id, title, first, end }) => [id, title, first, end])).toEqual([
      [4, "mine", 0, 60],
      [5, "other", 0, 60],
    ]);
    expect(stage.clip).toBe("own-4");
  });

  it("are unticked when a clip of another body is ticked that a model made, and the other way round", async () => {
    await clips.addModelled("Walk 1", bvhText(["Hips", "LeftArm"]));
    expect(tickedKeys()).toEqual(["made-walk-1", "made-walk-2"]);
    await clips.tick("model-4", true);
    expect(tickedKeys()).toEqual(["model-4"]);
    await clips.tick("made-walk-2", true);
    expect(tickedKeys()).toEqual(["made-walk-2"]);
    expect(clips.stored.at(-1)).toMatchObject({ key: "model-4", title: "Walk 1", origin: "model" });
  });

  it("are ticked again when the visitor's last own clip is removed", async () => {
    await clips.tick("made-walk-2", false);
    await clips.open(file("mine.bvh"), true);
    await clips.open(file("other.bvh"), false);
    await clips.remove("own-4");
    expect(tickedKeys()).toEqual(["own-5"]);
    await clips.remove("own-5");
    expect(tickedKeys()).toEqual(["made-walk-1"]);
  });

  it("stay as they are when a file cannot be read", async () => {
    await expect(clips.open(file("empty.bvh", ""), true)).rejects.toThrow(
      "expected HIERARCHY, found the end of the file",
    );
    expect(tickedKeys()).toEqual(["made-walk-1", "made-walk-2"]);
    expect(stage.clip).toBeNull();
  });
});

describe("a clip on the stage", () => {
  beforeEach(() => clips.open(file("mine.bvh"), true));

  it("is shown with the frames that it is cut to, at least ten", () => {
    clips.cut("own-4", 5.2, 40);
    expect(stage.content?.motion.frames).toBe(35);
    expect(stage.content?.motion.positions).toHaveLength(35 * 9);
    clips.cut("own-4", 55, 2);
    expect([clips.ticked[0]?.first, clips.ticked[0]?.end]).toEqual([50, 60]);
    clips.cut("own-4", Number.NaN, 20);
    expect([clips.ticked[0]?.first, clips.ticked[0]?.end]).toEqual([50, 60]);
  });

  it("is shown in the parts that are chosen", () => {
    clips.setParts({
      parts: "hand",
      split: [
        { name: "all but the chest", joints: [0] },
        { name: "chest", joints: [1] },
      ],
    });
    expect(stage.content?.parts.map(({ name }) => name)).toEqual(["all but the chest", "chest"]);
    expect(clips.parts).toEqual(stage.content?.parts);
  });

  it("leaves the stage to the model when it is removed", async () => {
    await clips.remove("own-4");
    expect([stage.clip, stage.content?.kind]).toEqual([null, "first"]);
    expect(clips.all.map(({ key }) => key)).not.toContain("own-4");
  });

  it("stays there while another clip is cut or removed", async () => {
    await clips.open(file("other.bvh"), false);
    clips.cut("own-5", 0, 20);
    expect(stage.content?.motion.frames).toBe(60);
    await clips.remove("own-5");
    expect(stage.clip).toBe("own-4");
  });
});

describe("the frames a second of a file", () => {
  it("are stated for an own clip whose frame time is wrong", async () => {
    await clips.open(file("crab.bvh"), true);
    await clips.state("own-4", { fps: 120 });
    expect(clips.toTrainOn[0]).toMatchObject({ source: { name: "crab", fps: 120 } });
    expect(clips.all.at(-1)?.loaded.info.frameTime).toBe(1 / 120);
    expect(stage.content?.motion.frameTime).toBe(1 / 120);
    await clips.state("own-4", { fps: Number.NaN });
    expect(clips.all.at(-1)?.loaded.info.frameTime).toBe(1 / 120);
  });
});

describe("the axis that points up", () => {
  it("is stated for an own clip, which keeps its cut and its place, also for trainings and later visits", async () => {
    await clips.open(file("crab.bvh"), true);
    clips.cut("own-4", 10, 40);
    await clips.state("own-4", { up: "z" });
    const [clip] = clips.ticked;
    expect([clip?.key, clip?.loaded.info.upAxis, clip?.first, clip?.end]).toEqual(["own-4", "z", 10, 40]);
    expect(clips.toTrainOn[0]).toMatchObject({ id: 5, source: { name: "crab", up: "z" } });
    expect(stage.clip).toBe("own-4");
    const stored = clips.stored.find(({ key }) => key === "own-4");
    await clips.remove("own-4");
    if (stored) await clips.takeUp(stored);
    expect(clips.ticked.at(-1)?.loaded.info.upAxis).toBe("z");
  });

  it("is not asked of clips that come with the page", async () => {
    await clips.state("made-walk-1", { up: "z" });
    expect(clips.all[0]?.loaded.info.upAxis).toBe("y");
  });
});

describe("ticked clips that do not go together", () => {
  it("are named as long as they are ticked", async () => {
    await clips.open(file("mine.bvh"), false);
    await clips.tick("own-4", true);
    expect(clips.clash).toMatch(/^mine cannot be trained together with walk-1 .*expected 21 joints, found 2/);
    await clips.tick("own-4", false);
    expect(clips.clash).toBe("");
  });

  it("are judged by the last tick, also when an earlier answer comes later", async () => {
    workers.hold("checkTogether");
    void clips.tick("made-walk-wave-1", true);
    void clips.tick("made-walk-wave-1", false);
    const [older, newer] = workers.held("checkTogether");
    newer?.go();
    await workers.settled();
    older?.fail(new Error("their bodies differ"));
    await workers.settled();
    expect(clips.clash).toBe("");
  });
});

describe("clips of one skeleton with other bones", () => {
  beforeEach(async () => {
    await clips.open(file("mine.bvh"), true);
    await clips.open(file("longer.bvh", bvhText(undefined, 60)), false);
    await clips.checkClash();
  });

  it("go together with the bones of the first, until each has its own again", async () => {
    expect([clips.clash, clips.bonesClash]).toEqual([
      expect.stringMatching(/^longer .*offset differs/),
      true,
    ]);
    await clips.setFirstBones(true);
    expect([clips.clash, clips.bonesClash, clips.firstBones]).toEqual(["", false, true]);
    expect(clips.toTrainOn.map(({ firstBones }) => firstBones)).toEqual([undefined, true]);
    await clips.setFirstBones(false);
    expect([clips.bonesClash, clips.toTrainOn[1]?.firstBones]).toEqual([true, undefined]);
  });

  it("differ from clips of other joints", async () => {
    await clips.open(file("other.bvh", bvhText(["Hips", "LeftArm"])), false);
    await clips.setFirstBones(true);
    expect([clips.clash, clips.bonesClash]).toEqual([expect.stringMatching(/^other .*"LeftArm"$/), false]);
  });
});
