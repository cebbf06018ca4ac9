import { expect, it } from "vitest";
import { kernel, type Point, Process } from "./process";

const of = { lambda: 0.7, variance: 1.3 };
const data: Point[] = [
  [-1, 0.4],
  [0.5, -0.3],
  [1.6, 0.8],
];
const noise = 0.05;

it("is the exact process with an inducing point at each data point", () => {
  const exact = new Process(
    data,
    data.map(([x]) => x),
    of,
    noise,
  );
  // k^T (K + n I)^-1 y and k(x, x) - k^T (K + n I)^-1 k, solved by elimination.
  const x = 0.1;
  const matrix = data.map(([a], i) => data.map(([b], j) => kernel(of, a, b) + (i === j ? noise : 0)));
  const k = data.map(([a]) => kernel(of, x, a));
  const solveFor = (right: number[]) => {
    const rows = matrix.map((row, i) => [...row, right[i]!]);
    for (let i = 0; i < 3; i++) {
      const pivot = rows[i]!;
      for (let j = 0; j < 3; j++) {
        if (i === j) continue;
        const factor = rows[j]![i]! / pivot[i]!;
        rows[j] = rows[j]!.map((value, c) => value - factor * pivot[c]!);
      }
    }
    return rows.map((row, i) => row[3]! / row[i]!);
  };
  const dot = (a: number[], b: number[]) => a.reduce((sum, value, i) => sum + value * b[i]!, 0);
  const found = exact.at(x);
  expect(found.mean).toBeCloseTo(dot(k, solveFor(data.map(([, y]) => y))), 5);
  expect(found.variance).toBeCloseTo(of.variance - dot(k, solveFor(k)), 5);
});

it("falls back to its prior far from all points", () => {
  const { mean, variance } = new Process(data, [-1, 1], of, noise).at(40);
  expect(mean).toBeCloseTo(0, 9);
  expect(variance).toBeCloseTo(of.variance, 9);
});

it("has the moments of its predictions over an uncertain input", () => {
  const process = new Process(data, [-1.2, 0, 1.5], of, noise);
  const [x, variance] = [0.4, 0.3];
  let [weight, first, second] = [0, 0, 0];
  for (let step = -4000; step <= 4000; step++) {
    const z = step / 500;
    const share = Math.exp(-0.5 * z * z);
    const at = process.at(x + Math.sqrt(variance) * z);
    weight += share;
    first += share * at.mean;
    second += share * (at.variance + at.mean ** 2);
  }
  const mean = first / weight;
  const found = process.at(x, variance);
  expect(found.mean).toBeCloseTo(mean, 6);
  expect(found.variance).toBeCloseTo(second / weight - mean ** 2, 6);
});
