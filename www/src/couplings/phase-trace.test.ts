import { describe, expect, it } from "vitest";
import { LearnedCycle } from "./learned-cycle";
import { PhaseTrace } from "./phase-trace";

const FRAMES = 300;
const TURN = 2 * Math.PI;

/** A circle with this period in frames, radius and start in turns [FRAMES x 2]. */
const circle = (period: number, radius = 1, start = 0) =>
  Float64Array.from({ length: 2 * FRAMES }, (_, i) => {
    const angle = TURN * (Math.floor(i / 2) / period + start);
    return radius * (i % 2 === 0 ? Math.cos(angle) : Math.sin(angle));
  });

const cycle = () => LearnedCycle.from(circle(30), 2, 2, 30)!;

/** The phases of two parts that learned a circle of 30 frames and now move like this. */
function traceOf(first: Float64Array, second: Float64Array, frames = FRAMES): PhaseTrace {
  const trace = new PhaseTrace([cycle(), cycle()], 200);
  for (let frame = 0; frame < frames; frame++) trace.add(frame, [first, second], frame);
  return trace;
}

describe("a learned cycle", () => {
  it("finds the phase between two frames, also of a smaller swing, and tells its distance", () => {
    const learned = cycle();
    learned.place(circle(30), 100);
    const start = learned.phase;
    learned.place(circle(30, 0.5, 0.51), 100);
    expect(((learned.phase - start + 1) % 1).toFixed(2)).toBe("0.51");
    expect(learned.distance).toBeCloseTo(0.5, 1);
  });

  it("keeps the two arms of a figure of eight apart, which cross at one point", () => {
    const eight = (start: number) =>
      Float64Array.from({ length: 240 }, (_, i) =>
        i % 2 === 0
          ? Math.sin(TURN * (Math.floor(i / 2) / 40 + start))
          : Math.sin(2 * TURN * (Math.floor(i / 2) / 40 + start)),
      );
    const learned = LearnedCycle.from(eight(0), 2, 2, 40)!;
    const phases = [0, 0.5].map((start) => {
      learned.place(eight(start), 80);
      return learned.phase;
    });
    expect(Math.abs(phases[0]! - phases[1]!)).toBeCloseTo(0.5, 2);
  });

  it("is null for a path that stands still, for a path that is too short, and without a period", () => {
    expect(LearnedCycle.from(new Float64Array(600), 2, 2, 30)).toBeNull();
    expect(LearnedCycle.from(circle(30).subarray(0, 60), 2, 2, 30)).toBeNull();
    expect(LearnedCycle.from(circle(30), 2, 2, 0)).toBeNull();
  });
});

describe("a trace of phases", () => {
  it("gives each part the period of its own turns", () => {
    const trace = traceOf(circle(30), circle(38.5, 0.8));
    expect(trace.period(0)).toBeCloseTo(30, 1);
    expect(trace.period(1)).toBeCloseTo(38.5, 1);
    expect(trace.turns(0, 290) - trace.turns(0, 275)).toBeCloseTo(0.5, 2);
    expect(trace.locking(1, 120)).toBeLessThan(0.5);
  });

  it("calls parts at one pace locked, also when one is ahead of the other", () => {
    const trace = traceOf(circle(30), circle(30, 1, 0.2));
    expect(trace.turns(1, 250.5) - trace.turns(0, 250.5)).toBeCloseTo(0.2, 2);
    expect(trace.locking(1, 120)).toBeGreaterThan(0.99);
  });

  it("sees that a part stands still one learned turn after it has stopped", () => {
    const stopped = circle(30);
    for (let i = 400; i < stopped.length; i++) stopped[i] = stopped[i - 2]! * 0.8;
    expect(traceOf(circle(30), stopped, 199).isStanding(1)).toBe(false);
    const trace = traceOf(circle(30), stopped, 240);
    expect(trace.isStanding(0)).toBe(false);
    expect(trace.isStanding(1)).toBe(true);
    expect(trace.distance(1, 239)).toBeGreaterThan(0.9);
  });

  it("has no period before two turns, and forgets frames before a gap", () => {
    const trace = traceOf(circle(30), circle(30), 50);
    expect(trace.period(0)).toBeNull();
    expect(trace.locking(1, 60)).toBeNull();
    trace.add(120, [circle(30), circle(30)], 120);
    expect(trace.turns(0, 30)).toBe(trace.turns(0, 120));
    expect(trace.locking(1, 60)).toBeNull();
  });
});
