import { beforeEach, describe, expect, it, vi } from "vitest";
import { FakeLab } from "./lab.fake";
import { FakeEngine } from "../engine/engine.fake";
import type { BodyReport, RolloutResult } from "../engine/protocol";
import { LiveTrack } from "../scene/live-track";
import { BodyStore } from "./body-store";
import { PhasesStore } from "./phases-store";

const TURN = 2 * Math.PI;
const circle = (frames: number, period: number) =>
  Float64Array.from({ length: 2 * frames }, (_, i) => {
    const angle = (TURN * Math.floor(i / 2)) / period;
    return i % 2 === 0 ? Math.cos(angle) : Math.sin(angle);
  });

/** Both parts go round in 30 frames as learned; with other couplings the second needs 40. */
class WalkingEngine extends FakeEngine {
  override async rollout(request: RolloutResult["request"]) {
    return walking(await super.rollout(request));
  }
  override async openModel(text: string, frames: number) {
    const opened = await super.openModel(text, frames);
    return { ...opened, rollout: walking(opened.rollout) };
  }
  override async bodyReport(request: RolloutResult["request"]): Promise<BodyReport> {
    const report = await super.bodyReport(request);
    const limbs = (period: number, locking: number) => ({ swing: 0.2, period, locking });
    const parts = request.alpha ? [limbs(1, 0.2), limbs(4 / 3, 0.2)] : [limbs(1, 1), limbs(1, 1)];
    return { ...report, measures: { ...report.measures, parts } };
  }
}
const walking = (rollout: RolloutResult): RolloutResult => {
  const { frames } = rollout.motion;
  return { ...rollout, latents: [circle(frames, 30), circle(frames, rollout.request.alpha ? 40 : 30)] };
};

let { playback, stage, model } = new FakeLab();
let phases: PhasesStore;

beforeEach(async () => {
  vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout"] });
  const lab = new FakeLab("", new WalkingEngine());
  ({ playback, stage, model } = lab);
  phases = new PhasesStore(model, new BodyStore(lab.store, model), stage, playback);
  await lab.start();
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
    expect([apart(30), apart(150)]).toEqual([0, 0]);
    expect([phases.period(0), phases.period(1), phases.step]).toEqual([1, 1, "in step"]);
    model.couplings.set(0, 1, 900);
    await measured();
    expect(apart(240) - apart(120)).toBeCloseTo(120 / 30 - 120 / 40, 1);
    expect([phases.period(0), phases.period(1), phases.step]).toEqual([1, 4 / 3, "out of step"]);
  });

  it("are measured on a live motion while it goes on", () => {
    const track = new LiveTrack({ nodes: 2, frameTime: 1 / 30 }, 360, [2, 2]);
    const append = (frames: number, second: Float64Array) =>
      track.append({ positions: new Float32Array(6 * frames), frames, nodes: 2, frameTime: 1 / 30 }, [
        circle(frames, 30),
        second,
      ]);
    append(30, circle(30, 30));
    stage.showLive(track);
    expect([phases.period(0), phases.step]).toEqual([null, null]);
    append(300, circle(300, 40));
    expect(phases.period(1)).toBeCloseTo(4 / 3, 1);
    expect(phases.step).toBe("out of step");
    append(60, new Float64Array(120));
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
