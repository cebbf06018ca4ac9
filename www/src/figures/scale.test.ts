import { describe, expect, it } from "vitest";
import { linearScale, logScale, type Scale } from "./scale";

const labels = (scale: Scale, most: number) => scale.ticks(most).map(({ label }) => label);

describe("a linear scale", () => {
  it("places its values with some space at both ends, in both directions", () => {
    const scale = linearScale([0, 100], 0, 112);
    expect(scale.at(0)).toBeCloseTo(6);
    expect(scale.at(100)).toBeCloseTo(106);
    expect(linearScale([0, 100], 112, 0).at(0)).toBeCloseTo(106);
  });

  it("places values outside at its end", () => {
    const scale = linearScale([0, 100], 10, 90);
    expect([scale.at(-1e9), scale.at(1e9)]).toEqual([10, 90]);
  });

  it("labels round values", () => {
    const found = labels(linearScale([0.0004, 0.012], 0, 1), 7);
    expect(found).toEqual(["0.000", "0.002", "0.004", "0.006", "0.008", "0.010", "0.012"]);
    expect(labels(linearScale([-1, 1], 0, 1), 5)).toEqual(["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
    const large = labels(linearScale([21034.3, 30344], 0, 1), 5);
    expect(large).toEqual(["22,000", "24,000", "26,000", "28,000", "30,000"]);
  });

  it("labels at most the allowed number of values, and two where two are allowed", () => {
    for (const values of [
      [0, 1],
      [0.1, 0.9],
      [-3, 17],
      [1e-4, 3e-4],
      [21034, 30344],
      [-7e6, -6.9e6],
    ]) {
      for (const most of [2, 3, 4, 5, 8]) {
        const { length } = linearScale(values, 0, 1).ticks(most);
        expect(length, `${values}, ${most}`).toBeLessThanOrEqual(most);
        if (most > 3) expect(length, `${values}, ${most}`).toBeGreaterThanOrEqual(2);
      }
    }
  });

  it("accepts one value, no value, and NaN", () => {
    const single = linearScale([5, Number.NaN, Infinity], 0, 100);
    expect(single.at(5)).toBeCloseTo(50);
    expect(single.ticks(4).length).toBeGreaterThan(0);
    expect(linearScale([], 0, 100).at(0.5)).toBeCloseTo(50);
    expect(linearScale([0, 0], 0, 100).at(0)).toBeCloseTo(50);
  });
});

describe("a logarithmic scale", () => {
  it("gives equal ratios equal distances", () => {
    const scale = logScale([1, 100], 0, 100);
    expect(scale.at(10) - scale.at(1)).toBeCloseTo(scale.at(100) - scale.at(10));
    expect(scale.at(10)).toBeCloseTo(50);
  });

  it("labels 1, 2, 5, or powers of ten, up to the allowed number", () => {
    const scale = logScale([0.0004, 0.012], 0, 1);
    expect(labels(scale, 6)).toEqual(["0.0005", "0.001", "0.002", "0.005", "0.01"]);
    expect(labels(scale, 3)).toEqual(["0.001", "0.003", "0.01"]);
    expect(labels(scale, 2)).toEqual(["0.001", "0.01"]);
    expect(labels(logScale([700, 110_000], 0, 1), 2)).toEqual(["1,000", "100,000"]);
    expect(labels(logScale([1e-4, 1e6], 0, 1), 4)).toEqual(["0.0001", "0.1", "100", "100,000"]);
  });

  it("labels round values between close values", () => {
    expect(labels(logScale([700, 1000, 1350], 0, 1), 5)).toEqual(["800", "1,000", "1,200", "1,400"]);
    expect(logScale([3.1, 3.1], 0, 100).at(3.1)).toBeCloseTo(50);
    expect(logScale([3.1, 3.1], 0, 100).ticks(4).length).toBeGreaterThan(1);
  });

  it("places values without a logarithm at its lower end, and accepts no value", () => {
    const scale = logScale([-1, 0, 10, 100], 20, 80);
    expect(scale.low).toBeGreaterThan(5);
    expect([scale.at(0), scale.at(-1)]).toEqual([20, 20]);
    expect(logScale([], 0, 1).ticks(3).length).toBeGreaterThan(0);
  });
});

it("labels some values of any range", () => {
  for (const values of [[1e-3, 1e300], [1e-300, 1], [1.7e308]]) {
    const scale = logScale(values, 0, 300);
    const ticks = scale.ticks(5);
    expect(ticks.length, values.join()).toBeGreaterThan(0);
    expect(ticks.length, values.join()).toBeLessThanOrEqual(5);
    for (const value of values) expect(scale.at(value)).toBeGreaterThanOrEqual(0);
  }
});
