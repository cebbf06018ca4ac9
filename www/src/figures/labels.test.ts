import { describe, expect, it } from "vitest";
import { beside, spread, withoutCommonEnd } from "./labels";

describe("labels beside the ends of lines", () => {
  it("stay where they are wanted when there is room", () =>
    expect(spread([50, 10, 90], 12, 0, 100)).toEqual([50, 10, 90]));

  it("move apart by as little as possible, in their order", () => {
    expect(spread([50, 50, 10], 12, 0, 100)).toEqual([44, 56, 10]);
    expect(spread([52, 48, 50], 10, 0, 100)).toEqual([60, 40, 50]);
  });

  it("stay within their room", () => {
    expect(spread([99, 100, 98], 10, 0, 100)).toEqual([90, 100, 80]);
    expect(spread([1, 0], 10, 0, 100)).toEqual([10, 0]);
    const many = spread([5, 5, 5, 5, 5], 30, 0, 100);
    expect(many).toEqual([0, 25, 50, 75, 100]);
    expect(spread([], 10, 0, 100)).toEqual([]);
    expect(spread([200], 10, 0, 100)).toEqual([100]);
  });

  it("keep their distance when several groups meet a border", () => {
    const places = spread([0, 1, 2, 30, 31, 95, 97, 99], 10, 0, 100).sort((a, b) => a - b);
    for (const [i, place] of places.slice(1).entries()) expect(place - places[i]!).toBeGreaterThan(10 - 1e-9);
    expect(places[0]).toBeGreaterThanOrEqual(0);
    expect(places.at(-1)).toBeLessThanOrEqual(100 + 1e-9);
  });
});

describe("labels of points", () => {
  const within = { x: 0, y: 0, width: 200, height: 100 };

  it("stand to the right, or left where the room ends", () => {
    const [middle, edge] = beside(
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

  it("cover neither each other nor the marks of others", () => {
    const points = [
      { x: 100, y: 50 },
      { x: 112, y: 54 },
      { x: 104, y: 66 },
      { x: 40, y: 50 },
    ];
    const boxes = beside(points, [36, 36, 36, 36], 12, 4, within);
    const apart = (a: (typeof boxes)[0], b: (typeof boxes)[0]) =>
      a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;
    boxes.forEach((box, i) => {
      boxes.forEach((other, j) => {
        expect(i === j || apart(box, other), `labels ${i}, ${j}`).toBe(true);
      });
      points.forEach(({ x, y }, j) => {
        expect(apart(box, { x: x - 4, y: y - 4, width: 8, height: 8 }), `label ${i}, mark ${j}`).toBe(true);
      });
    });
  });
});

it("takes off the words that all labels share", () => {
  expect(withoutCommonEnd(["4 + 4 inducing points", "12 + 12 inducing points"])).toEqual({
    short: ["4 + 4", "12 + 12"],
    end: "inducing points",
  });
  expect(withoutCommonEnd(["4 + 8 inducing points", "8 + 8 inducing points"])).toEqual({
    short: ["4 + 8", "8 + 8"],
    end: "inducing points",
  });
  expect(withoutCommonEnd(["primitives by the bound", "3 primitives"])).toEqual({
    short: ["primitives by the bound", "3 primitives"],
    end: "",
  });
  expect(withoutCommonEnd(["8 + 8 inducing points"])).toEqual({ short: ["8 + 8 inducing points"], end: "" });
  expect(withoutCommonEnd(["same", "same"])).toEqual({ short: ["same", "same"], end: "" });
  expect(withoutCommonEnd([])).toEqual({ short: [], end: "" });
});
