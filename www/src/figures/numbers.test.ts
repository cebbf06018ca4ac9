import { expect, it } from "vitest";
import { evenLabels, percent, plain, powerLabels, ratio, estimateText, twoDecimals } from "./numbers";

it.each([
  [0, "0.00"],
  [0.0011, "0.00110"],
  [2.34567, "2.35"],
  [33.4, "33.4"],
  [431.7, "432"],
  [101234, "101,234"],
  [-20.5, "−20.5"],
  [9.999, "10.00"],
  [1.23e-9, "1.23 × 10⁻⁹"],
  [4.5e13, "4.50 × 10¹³"],
  [Number.NaN, "unknown"],
  [Infinity, "unknown"],
])("writes %s as %s", (value, words) => expect(plain(value)).toBe(words));

it("writes a mean with the digits that its standard error allows", () => {
  const words = (mean: number, standardError: number | null, count = 10) =>
    estimateText({ mean, standardError, count });
  expect(words(0.0015394, 0.000123)).toEqual({ mean: "0.00154", error: "± 0.00012" });
  expect(words(0.0015394, 0.0000996)).toEqual({ mean: "0.00154", error: "± 0.00010" });
  expect(words(28990.4, 398.7)).toEqual({ mean: "28,990", error: "± 399" });
  expect(words(-1234.56, 1.2)).toEqual({ mean: "−1,234.6", error: "± 1.2" });
  expect(words(-0.001, 0.2)).toEqual({ mean: "0.00", error: "± 0.20" });
  expect(words(2652, 0)).toEqual({ mean: "2,652", error: "± 0" });
  expect(words(1.5, 1e-12)).toEqual({ mean: "1.50", error: "± 1.0 × 10⁻¹²" });
});

it("writes a mean without a standard error", () => {
  expect(estimateText({ mean: 0.0104, standardError: null, count: 1 })).toEqual({
    mean: "0.0104",
    error: "one trial",
  });
  expect(estimateText({ mean: 0.0104, standardError: Number.NaN, count: 3 })).toEqual({
    mean: "0.0104",
    error: "",
  });
  for (const [mean, count] of [
    [Number.NaN, 0],
    [Number.NaN, 3],
    [0.5, 0],
  ] as const)
    expect(estimateText({ mean, standardError: null, count })).toEqual({ mean: "unknown", error: "" });
});

it("labels equal steps with equal decimals, and powers one by one", () => {
  const labels = (ticks: { label: string }[]) => ticks.map(({ label }) => label);
  expect(labels(evenLabels([0, 0.5, 1]))).toEqual(["0.0", "0.5", "1.0"]);
  expect(labels(powerLabels([0.001, 0.01, 1, 1000]))).toEqual(["0.001", "0.01", "1", "1,000"]);
  expect(labels(powerLabels([2e-8, 1e9]))).toEqual(["2 × 10⁻⁸", "10⁹"]);
});

it("writes ratios with up to two decimals, and shares with one decimal", () => {
  expect([4.176, 12.34, 1847.7].map(ratio)).toEqual(["4.18", "12.3", "1,848"]);
  expect([0.99234, 1, -0.125].map(percent)).toEqual(["99.2 %", "100.0 %", "−12.5 %"]);
});

it("writes a rank correlation or an exponent", () => {
  expect(twoDecimals(-0.9)).toBe("−0.90");
  expect(twoDecimals(Number.NaN)).toBe("unknown");
});
