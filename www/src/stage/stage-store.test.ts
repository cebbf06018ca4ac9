import { beforeEach, describe, expect, it, vi } from "vitest";
import { FakeAddressBar } from "../settings/address.fake";
import { SettingsStore } from "../settings/settings-store";
import { Playback } from "./playback";
import { type StageContent, StageStore } from "./stage-store";

/** A figure of two nodes that walks along x, a metre a second. */
function walk(kind: StageContent["kind"], clip?: string, frames = 120): StageContent {
  const positions = Float32Array.from({ length: frames * 6 }, (_, i) =>
    i % 3 === 0 ? Math.floor(i / 6) / 30 : i % 6,
  );
  const motion = { positions, frames, nodes: 2, frameTime: 1 / 30 };
  return {
    kind,
    figure: { nodes: [] },
    joints: [],
    parts: [],
    motion,
    ...(clip === undefined ? {} : { clip }),
  };
}

let settings: SettingsStore;
let playback: Playback;
let stage: StageStore;
beforeEach(() => {
  settings = new SettingsStore(new FakeAddressBar());
  playback = new Playback(settings);
  stage = new StageStore(playback);
});

describe("the stage", () => {
  it("continues with the model at the place and time of the first motion", () => {
    stage.showModel(walk("first"));
    playback.play();
    playback.advance(1);
    const [x] = playback.pose ?? [];
    stage.showModel(walk("model"));
    expect(playback.frame).toBeCloseTo(30);
    expect(playback.pose?.[0]).toBeCloseTo(x ?? NaN);
    expect(stage.content?.kind).toBe("model");
  });

  it("keeps a clip in front of new motions of the model until the clip is removed", () => {
    stage.showModel(walk("first"));
    stage.showClip(walk("clip", "a"));
    playback.scrub(50);
    stage.showModel(walk("model"));
    expect([stage.clip, stage.content?.kind, playback.frame]).toEqual(["a", "clip", 50]);
    stage.endClip();
    expect([stage.clip, stage.content?.kind, playback.frame]).toEqual([null, "model", 0]);
  });

  it("continues the same clip, but starts another clip at frame 0", () => {
    stage.showClip(walk("clip", "a"));
    playback.scrub(50);
    stage.showClip(walk("clip", "a", 100));
    expect([playback.frame, playback.lastFrame]).toEqual([50, 99]);
    stage.showClip(walk("clip", "b"));
    expect(playback.frame).toBe(0);
  });

  it("changes once when the same recording is outlined again and again", () => {
    const shown = vi.fn();
    stage.on(shown);
    const { motion } = walk("clip", "a");
    for (let times = 0; times < 3; times++) stage.setRecording(motion);
    expect(shown).toHaveBeenCalledTimes(1);
    stage.setRecording(null);
    expect(shown).toHaveBeenCalledTimes(2);
  });

  it("keeps the clip while the model has no motion", () => {
    stage.showClip(walk("clip", "a"));
    stage.endClip();
    expect(stage.clip).toBe("a");
  });
});

describe("the clock of the stage", () => {
  it("takes its speed and its loop from the settings", () => {
    stage.showModel(walk("model"));
    settings.change({ speed: 0.5, loop: false });
    playback.play();
    playback.advance(1);
    expect(playback.frame).toBeCloseTo(15);
    playback.advance(60);
    expect([playback.frame, playback.playing]).toEqual([119, false]);
  });

  it("notifies only its own listeners of frames", () => {
    stage.showModel(walk("model"));
    const [frames, shown] = [vi.fn(), vi.fn()];
    playback.on(frames);
    stage.on(shown);
    playback.togglePlay();
    playback.advance(0.1);
    playback.step(1);
    expect(frames).toHaveBeenCalledTimes(3);
    expect(shown).not.toHaveBeenCalled();
  });

  it("walks on lap after lap", () => {
    stage.showModel(walk("model"));
    playback.play();
    playback.advance(4.2);
    expect(playback.frame).toBeLessThan(30);
    expect(playback.pose?.[0]).toBeGreaterThan(3);
  });
});
