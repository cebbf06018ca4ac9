import { beforeEach, describe, expect, it, vi } from "vitest";
import { HeldLab } from "./lab.fake";
import type { LiveChange } from "../engine/protocol";
import { startModel } from "../engine/start-model.fake";
import { LiveTrack } from "../scene/live-track";
import { BodyStore } from "./body-store";
import { PhasesStore } from "./phases-store";

/** It walks. As learned its parts keep step; without a coupling from below the upper part is slower. */
const { text, info } = await startModel();

let { store, playback, stage, model } = new HeldLab();
let phases: PhasesStore;

beforeEach(async () => {
  vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout"] });
  const lab = new HeldLab();
  ({ store, playback, stage, model } = lab);
  phases = new PhasesStore(model, new BodyStore(store, model), stage, playback);
  await lab.start(text);
  await measured();
  return () => vi.useRealTimers();
});

async function measured(): Promise<void> {
  await vi.advanceTimersByTimeAsync(500);
}

/** The difference of the turns of both parts at a frame. */
function apart(frame: number): number {
  playback.scrub(frame);
  return phases.turns(0) - phases.turns(1);
}

describe("the phases of the parts", () => {
  it("are equal as learned, and part when the couplings change", async () => {
    const periods = () => [0, 1].map((part) => Number(phases.period(part)));
    const found = () => [...periods().map((seconds) => seconds.toFixed(2)), phases.step];
    expect([apart(30), apart(150)]).toEqual([expect.closeTo(0, 2), expect.closeTo(0, 2)]);
    expect(found()).toEqual(["1.13", "1.13", "in step"]);
    model.couplings.set(0, 1, 900);
    model.setSeconds(20);
    await measured();
    expect(found()).toEqual(["1.13", "1.44", "out of step"]);
    const [lower, upper] = periods() as [number, number];
    const turns = 560 * info.frameTime * (1 / lower - 1 / upper);
    expect(apart(580) - apart(20)).toBeCloseTo(turns, 1);
  });

  it("are measured on a live motion while it goes on", async () => {
    const engine = store.engine!;
    const alpha = [[info.alpha[0]![0]!, 900], info.alpha[1]!];
    const couplings = { kind: "couplings", alpha, reading: "re-inferred" } as const;
    await engine.startLive(model.rolloutRequest(), 0);
    const { figure, frameTime, parts } = info;
    const widths = parts.map(({ latent }) => latent);
    const track = new LiveTrack({ nodes: figure.nodes.length, frameTime }, 360, widths);
    const append = async (frames: number, change: LiveChange) => {
      const { motion, latents } = await engine.advanceLive({ back: 0, changes: [change], frames });
      track.append(motion, latents);
    };
    await append(30, couplings);
    stage.showLive(track);
    expect([phases.period(0), phases.step]).toEqual([null, null]);
    await append(300, couplings);
    expect(phases.period(1)).toBeCloseTo(1.44, 2);
    expect(phases.step).toBe("out of step");
    await append(60, { kind: "drive", part: 1, turns: 0 });
    expect(phases.period(1)).toBe("still");
    expect(phases.step).toBeNull();
    stage.endLive();
    expect(phases.step).toBe("in step");
  });

  it("do not exist for a clip", () => {
    expect(phases.parts).toHaveLength(2);
    stage.showClip({ ...stage.content!, kind: "clip", clip: "a" });
    expect(phases.parts).toHaveLength(0);
  });
});
