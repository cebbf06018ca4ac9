import { describe, expect, it } from "vitest";
import { HANDS, strokesOf } from "./drawings.fake";
import { goesOn } from "./goes-on";
import {
  drawingOf,
  drawnBeside,
  lapOf,
  onPad,
  placeInRound,
  ROWS_A_SECOND,
  type Rows,
  type Strokes,
} from "./hand";

const round = (turn: number): [number, number] => [
  50 + 30 * Math.cos(2 * Math.PI * turn),
  66 + 30 * Math.sin(2 * Math.PI * turn),
];
/** A circle at 60 readings a second. */
const circle = (laps: number, lap: number, first = 0): Strokes => [
  Array.from({ length: Math.round(60 * laps * lap) }, (_, i) => {
    const [x, y] = round(i / 60 / lap);
    return { seconds: first + i / 60, x, y };
  }),
];
const steps = (rows: Rows) =>
  rows.slice(1).map((row, i) => Math.hypot(...row.map((value, k) => value - (rows[i]?.[k] ?? 0))));

describe("a drawing", () => {
  it("of several rounds stays as it was drawn, with the time of a round", () => {
    const drawing = drawingOf([circle(4, 1)]);
    expect(drawing?.once).toBe(false);
    expect(drawing?.lap).toBeCloseTo(ROWS_A_SECOND, -1);
    expect(drawing?.rows.length).toBeCloseTo(4 * ROWS_A_SECOND, -1);
  });

  it("of a slow hand has fewer rows a second", () => {
    const { rows = [], rate, lap } = drawingOf([circle(2, 9)]) ?? {};
    expect([rate, lap, rows.length]).toEqual([ROWS_A_SECOND / 2, 90, 180]);
  });

  it("of one round is repeated without a jump", () => {
    const drawing = drawingOf([circle(0.8, 1.5)]);
    expect(drawing?.once).toBe(true);
    const { rows = [], lap = 0 } = drawing ?? {};
    expect(rows.length).toBeGreaterThanOrEqual(3 * (lap - 1));
    const all = steps(rows);
    const usual = [...all].sort((a, b) => a - b)[Math.floor(all.length / 2)] ?? 0;
    expect(Math.max(...all)).toBeLessThan(2 * usual);
  });

  it("loses its rests, at both ends and within", () => {
    const [moving = []] = circle(2, 1);
    const still = (at: (typeof moving)[number] | undefined, from: number) =>
      Array.from({ length: 60 }, (_, i) => ({ x: at?.x ?? 0, y: at?.y ?? 0, seconds: from + i / 60 }));
    const half = moving.slice(0, 60).map((sample) => ({ ...sample, seconds: sample.seconds + 1 }));
    const rest = moving.slice(60).map((sample) => ({ ...sample, seconds: sample.seconds + 2 }));
    const rested = [
      ...still(moving[0], 0),
      ...half,
      ...still(half.at(-1), 2),
      ...rest,
      ...still(rest.at(-1), 4),
    ];
    const drawing = drawingOf([[rested]]);
    expect(drawing?.rows.length).toBeLessThan(2.5 * ROWS_A_SECOND);
  });

  it("is refused when it is a dot, a moment, or on no pad", () => {
    const dot = [Array.from({ length: 90 }, (_, i) => ({ seconds: i / 60, x: 50 + (i % 2), y: 50 }))];
    expect(drawingOf([dot])).toBeNull();
    expect(drawingOf([circle(0.1, 1)])).toBeNull();
    expect(drawingOf([[]])).toBeNull();
    expect(drawingOf([circle(2, 1), []])).toBeNull();
  });

  it("of two hands has the rows of the time that both drew", () => {
    const both = drawingOf([circle(4, 1), circle(3, 1.2, 0.5)]);
    expect(both?.rows[0]?.length).toBe(4);
    expect(both?.rows.length).toBeLessThanOrEqual(3.6 * ROWS_A_SECOND);
  });

  it("of a second hand gets the tempo of the first, when both are near", () => {
    const [first, near, far] = [1, 1.1, 1.5].map((lap) => drawingOf([circle(5, lap)]));
    if (!first || !near || !far) throw new Error("too little");
    const [round = []] = first.rounds;
    expect(placeInRound(round, 1000)).toHaveLength(2);
    expect(lapOf(Array.from({ length: 300 }, (_, i) => placeInRound(round, i / 60) ?? []))).toBe(60);
    const both = drawnBeside(round, near, 1);
    expect([0, 1].map((pad) => lapOf(onPad(both.readings, pad)))).toEqual([60, 60]);
    expect(both.tempo).toBeCloseTo(60 / 66, 6);
    expect(Math.max(...steps(onPad(both.rows, 0)))).toBeLessThan(
      1.5 * 2 * Math.PI * 30 * (1 / ROWS_A_SECOND),
    );
    const apart = drawnBeside(round, far, 0);
    expect(apart.tempo).toBeNull();
    expect([0, 1].map((pad) => lapOf(onPad(apart.readings, pad)))).toEqual([90, 60]);
    expect(drawingOf([circle(5, 1), circle(4, 1.5)])?.tempo).toBeNull();
  });

  it("goes on in itself, and neither in a rest nor in a smaller copy", () => {
    const { rows = [], lap = 0 } = drawingOf([circle(4, 1)]) ?? {};
    expect(goesOn(rows, rows, lap).goesOn).toBe(true);
    const rest = rows.map(() => rows[0] ?? []);
    expect(goesOn(rows, rest, lap).goesOn).toBe(false);
    const small = rows.map(([x = 0, y = 0]) => [50 + 0.3 * (x - 50), 66 + 0.3 * (y - 66)]);
    expect(goesOn(rows, small, lap).goesOn).toBe(false);
  });

  it("can be each of the thirty made ones", () => {
    for (const hand of HANDS) expect(drawingOf([strokesOf(hand)]), hand.shape).not.toBeNull();
  });
});
