import { describe, expect, it } from "vitest";
import { PairClock } from "./pair-clock";

const FRAME = 1000 / 60;

/** Asks the clock at each of these display frames, and returns how often each phase came. */
function run(clock: PairClock, times: readonly number[]) {
  const phases = times.map((now) => clock.at(now).phase);
  return {
    cross: phases.filter((p) => p === "cross").length,
    movement: phases.filter((p) => p === "movement").length,
  };
}
const steady = (count: number, frame = FRAME) => Array.from({ length: count }, (_, i) => 100 + i * frame);

describe("the clock of a trial", () => {
  it("shows the cross, then the movement from its beginning, then nothing", () => {
    const clock = new PairClock({ crossSeconds: 0.75, seconds: 3.5 });
    const times = steady(280);
    expect(run(clock, times)).toEqual({ cross: 45, movement: 210 });
    expect(clock.shown.lasted).toBeCloseTo(3500, 6);
    expect(clock.shown.dropped).toBe(0);
    expect(clock.shown.frame).toBeCloseTo(FRAME, 6);
  });

  it("ends each phase on time, within half a frame of any display", () => {
    for (const rate of [50, 75, 90, 144, 165]) {
      const clock = new PairClock({ crossSeconds: 0.75, seconds: 1.8 });
      run(clock, steady(3 * rate, 1000 / rate));
      expect(Math.abs((clock.shown.lasted ?? 0) - 1800), `${rate} Hz`).toBeLessThanOrEqual(500 / rate + 1e-6);
    }
  });

  it("ends on time on a slow machine, where the last picture stays", () => {
    for (const taken of [2, 3, 7, 12]) {
      const clock = new PairClock({ crossSeconds: 0.75, seconds: 3.5 });
      let [now, held] = [0, 0];
      for (let phase = ""; phase !== "over"; ) {
        const shown = clock.at(now);
        phase = shown.phase;
        held += Number(shown.hold);
        // Without a picture the display keeps its own rate.
        now += phase === "movement" && !shown.hold ? taken * FRAME : FRAME;
      }
      expect(Math.abs((clock.shown.lasted ?? 0) - 3500), `${taken} frames`).toBeLessThanOrEqual(
        FRAME / 2 + 1e-6,
      );
      expect(held).toBeGreaterThan(0);
      expect(held).toBeLessThanOrEqual(1.5 * taken + 1);
    }
  });

  it("begins with the first pose after a cross of any length", () => {
    const clock = new PairClock({ crossSeconds: 0.05, seconds: 1 });
    clock.at(0);
    expect(clock.at(400)).toMatchObject({ phase: "movement", seconds: 0 });
    expect(clock.at(417)).toMatchObject({ phase: "movement", seconds: 0.017 });
  });

  it("counts the display frames at which the movement did not move", () => {
    const clock = new PairClock({ crossSeconds: 0.1, seconds: 0.2 });
    const times = steady(40);
    times.splice(10, 3);
    run(clock, times);
    expect(clock.shown.dropped).toBe(3);
    // Frames after the end do not count.
    clock.at(5000);
    expect(clock.shown.dropped).toBe(3);
  });

  it("measures the time between the first pictures of the two movements", () => {
    const clock = new PairClock({ crossSeconds: 0, seconds: 1 });
    expect(clock.shown.startedApart).toBe(null);
    clock.drawn(0, 20.1);
    clock.drawn(1, 20.4);
    clock.drawn(1, 37);
    expect(clock.shown.startedApart).toBeCloseTo(0.3);
    const rightFirst = new PairClock({ crossSeconds: 0, seconds: 1 });
    rightFirst.drawn(1, 20.1);
    rightFirst.drawn(0, 20.4);
    expect(rightFirst.shown.startedApart).toBeCloseTo(0.3);
  });

  it("is stopped by an answer", () => {
    const clock = new PairClock({ crossSeconds: 0.1, seconds: 1 });
    clock.stop(50);
    expect(clock.shown.lasted).toBe(null);
    run(clock, steady(20));
    clock.stop(600);
    expect(clock.shown.lasted).toBeCloseTo(600 - (100 + 6 * FRAME), 6);
    expect(clock.at(700).phase).toBe("over");
  });
});
