import { describe, expect, it } from "vitest";
import { type Box, placeLabels, shortenLabels, spreadLabels } from "./labels";

describe("labels at the ends of lines", () => {
  it("stay in the wanted places where these are free", () =>
    expect(spreadLabels([50, 10, 90], 12, 0, 100)).toEqual([50, 10, 90]));

  it("move apart by as little as possible, in their order", () => {
    expect(spreadLabels([50, 50, 10], 12, 0, 100)).toEqual([44, 56, 10]);
    expect(spreadLabels([52, 48, 50], 10, 0, 100)).toEqual([60, 40, 50]);
  });

  it("stay within their space", () => {
    expect(spreadLabels([99, 100, 98], 10, 0, 100)).toEqual([90, 100, 80]);
    expect(spreadLabels([1, 0], 10, 0, 100)).toEqual([10, 0]);
    const many = spreadLabels([5, 5, 5, 5, 5], 30, 0, 100);
    expect(many).toEqual([0, 25, 50, 75, 100]);
    expect(spreadLabels([], 10, 0, 100)).toEqual([]);
    expect(spreadLabels([200], 10, 0, 100)).toEqual([100]);
  });

  it("keep their distance at a border", () => {
    const places = spreadLabels([0, 1, 2, 30, 31, 95, 97, 99], 10, 0, 100).sort((a, b) => a - b);
    for (const [i, place] of places.slice(1).entries()) expect(place - places[i]!).toBeGreaterThan(10 - 1e-9);
    expect(places[0]).toBeGreaterThanOrEqual(0);
    expect(places.at(-1)).toBeLessThanOrEqual(100 + 1e-9);
  });
});

describe("labels of points", () => {
  const within = { x: 0, y: 0, width: 200, height: 100 };

  it("are at the right, or at the left where the space ends", () => {
    const [middle, edge] = placeLabels(
      [
        { x: 60.3, y: 50.7 },
        { x: 195, y: 20 },
      ],
      [40.123, 40],
      14.1,
      5,
      within,
    );
    expect(middle!.x).toBeCloseTo(68.3);
    expect(middle!.y).toBeCloseTo(43.65);
    expect(edge!.x + edge!.width).toBeLessThan(190);
  });

  it("cover neither each other nor other marks", () => {
    const points = [
      { x: 100, y: 50 },
      { x: 112, y: 54 },
      { x: 104, y: 66 },
      { x: 40, y: 50 },
    ];
    const boxes = placeLabels(points, [36, 36, 36, 36], 12, 4, within);
    const apart = (a: Box, b: Box) =>
      a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;
    const placed = boxes.filter((box) => box !== null);
    expect(placed).toHaveLength(points.length);
    placed.forEach((box, i) => {
      placed.forEach((other, j) => {
        expect(i === j || apart(box, other), `labels ${i}, ${j}`).toBe(true);
      });
      points.forEach(({ x, y }, j) => {
        expect(apart(box, { x: x - 4, y: y - 4, width: 8, height: 8 }), `label ${i}, mark ${j}`).toBe(true);
      });
    });
  });
});

it("places no label over the mark at its left", () => {
  const within = { x: 0, y: 0, width: 200, height: 100 };
  const points = [
    { x: 190, y: 50 },
    { x: 146, y: 56 },
  ];
  const [label] = placeLabels(points, [36, 36], 12, 4, within);
  // At its left the mark ends at x = 150, and there is no space at its right.
  expect(label!.x > 150 || label!.y + label!.height <= 52 || label!.y >= 60).toBe(true);
  expect(label!.x + label!.width).toBeLessThanOrEqual(200);
});

it("leaves out a label that would overlap another one", () => {
  const crowd = Array.from({ length: 12 }, (_, i) => ({ x: 50 + i, y: 50 }));
  const boxes = placeLabels(crowd, new Array(12).fill(60), 14, 4, { x: 0, y: 0, width: 140, height: 100 });
  const placed = boxes.filter((box) => box !== null);
  expect(placed.length).toBeGreaterThan(0);
  expect(placed.length).toBeLessThan(12);
  for (const [i, a] of placed.entries())
    for (const b of placed.slice(i + 1))
      expect(
        a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y,
      ).toBe(true);
});

describe("short labels", () => {
  it("keep what differs, and name the unit and the common clauses", () => {
    expect(shortenLabels(["4 + 4 inducing points", "12 + 12 inducing points"])).toEqual({
      short: ["4 + 4", "12 + 12"],
      units: "inducing points",
      all: "",
    });
    expect(shortenLabels(["4 + 8 inducing points", "8 + 8 inducing points"]).short).toEqual([
      "4 + 8",
      "8 + 8",
    ]);
    expect(
      shortenLabels(["12 + 12 inducing points, 800 iterations", "12 + 12 inducing points, 150 iterations"]),
    ).toEqual({
      short: ["800", "150"],
      units: "iterations",
      all: "12 + 12 inducing points",
    });
    expect(
      shortenLabels([
        "8 + 8 inducing points, Q = 3, 800 iterations",
        "4 + 4 inducing points, Q = 2, 800 iterations",
      ]),
    ).toEqual({
      short: ["8 + 8, Q = 3", "4 + 4, Q = 2"],
      units: "inducing points",
      all: "800 iterations",
    });
  });

  it("are unchanged where the labels have different forms", () => {
    for (const labels of [
      ["primitives by the bound", "3 primitives"],
      ["8 + 8 inducing points"],
      ["same", "same"],
      ["8 + 8 inducing points", "8 + 8 inducing points, 800 iterations"],
      [],
    ])
      expect(shortenLabels(labels)).toEqual({ short: labels, units: "", all: "" });
  });
});
