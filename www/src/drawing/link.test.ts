import { assert, expect, it } from "vitest";
import { HeldWorkers } from "../engine/held.fake";
import { SettingsStore } from "../settings/settings-store";
import { DrawingStore } from "./drawing-store";
import { circle, drawnBy, eight } from "./example";
import { drawingOf, HEIGHT, type Rows, WIDTH } from "./hand";
import { drawingIn, keepInAddress, textOf } from "./link";

const drawing = drawingOf([[drawnBy(eight)], [drawnBy(circle)]]);

it("brings a drawing back, within a thousandth of the pad where it was smoothed once more", () => {
  const text = textOf(drawing ?? assert.fail(), [0, 1]);
  expect(text).toMatch(/^01\.[\w-]+$/);
  expect(text.length).toBeLessThan(1000);
  const found = drawingIn(text);
  expect(found?.pads).toEqual([0, 1]);
  const inner = (rows?: Rows) => rows?.slice(4, -4) ?? [];
  inner(found?.drawing.rows).forEach((row, i) =>
    row.forEach((value, axis) => {
      const before = inner(drawing?.rows)[i]?.[axis] ?? Number.NaN;
      expect(Math.abs(value - before)).toBeLessThan(0.015 * (axis % 2 === 0 ? WIDTH : HEIGHT));
    }),
  );
});

it("keeps the tempo of a slow hand", () => {
  const slow = drawingOf([[drawnBy((seconds) => circle(seconds / 8))]]) ?? assert.fail();
  const text = textOf(slow, [1]);
  expect(text).toMatch(/^1-2\./);
  const { rate, lap } = drawingIn(text)?.drawing ?? assert.fail();
  expect([rate, Math.abs(lap - slow.lap) < 3]).toEqual([10, true]);
});

it("finds no drawing in a damaged link", () => {
  for (const text of ["", "0.", "2.AAAA", "0.AAA", "01.AAAA", "0.AA!A", "0.AAAABBBB"])
    expect(drawingIn(text), text).toBe(null);
});

it("takes 20 seconds of two hands, though the drawing never repeats itself", () => {
  const scribble = (phase: number) =>
    Array.from({ length: 1200 }, (_, i) => {
      const t = i / 60;
      return {
        seconds: t,
        x: 50 + 40 * Math.sin(t * t * 0.3 + phase),
        y: 66 + 50 * Math.sin(t * 0.23 + phase),
      };
    });
  const long = drawingOf([[scribble(0)], [scribble(1)]]) ?? assert.fail();
  const text = textOf(long, [0, 1]);
  expect(text.length).toBeLessThan(8000);
  expect(drawingIn(text)).not.toBe(null);
});

it("says that a damaged link has no drawing, and removes it from the address", () => {
  const store = new DrawingStore(new HeldWorkers());
  const settings = new SettingsStore({ read: () => "", write() {}, push() {} });
  settings.change({ view: "draw", drawing: "0.AAA" });
  keepInAddress(store, settings);
  expect(store.words).toMatch(/no drawing that can be read/);
  expect(settings.values.drawing).toBe("");
});

it("writes what is drawn here into the address, and leaves a link as it was sent", async () => {
  const workers = new HeldWorkers();
  const small = { dynamicsIps: 4, poseIps: 4, maxIterations: 1 };
  workers.answer("trainSeries", (real, job, ...others) =>
    real({ ...job, settings: { ...job.settings, ...small } }, ...others),
  );
  const store = new DrawingStore(workers);
  const settings = new SettingsStore({ read: () => "", write() {}, push() {} });
  keepInAddress(store, settings);
  await store.example([0]);
  const own = settings.values.drawing;
  expect(own).toBe(textOf(store.drawn?.drawing ?? assert.fail(), [0]));
  const sent = { drawing: textOf(drawing ?? assert.fail(), [0, 1]), says: "for you" };
  const learned = new Promise<void>((done) => store.on(() => store.drawn?.pads.length === 2 && done()));
  settings.change(sent);
  await learned;
  expect(settings.values).toMatchObject(sent);
  await store.example([0]);
  expect(settings.values).toMatchObject({ drawing: own, says: "" });
});
