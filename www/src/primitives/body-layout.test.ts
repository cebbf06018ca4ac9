import { expect, it } from "vitest";
import { HeldWorkers } from "../engine/held.fake";
import { bodyOf, drawApart, HEIGHT, WIDTH } from "./body-layout";

it("moves nodes away from each other, also from the same spot, and keeps them in the map", () => {
  for (const spots of [
    [
      { x: 85, y: 90 },
      { x: 85, y: 90 },
    ],
    [
      { x: 85, y: 150 },
      { x: 85, y: 60 },
      { x: 60, y: 90 },
      { x: 110, y: 90 },
    ],
    [
      { x: -40, y: 500 },
      { x: 85, y: 60 },
    ],
  ]) {
    const apart = drawApart(spots);
    apart.forEach((a, i) => {
      expect(a.x > 0 && a.x < WIDTH && a.y > 0 && a.y < HEIGHT).toBe(true);
      for (const b of apart.slice(i + 1)) expect(Math.hypot(a.x - b.x, a.y - b.y)).toBeGreaterThan(40);
    });
  }
});

it("draws a body as tall as its map, upright, with each part where its joints are", async () => {
  const { info, motion } = await new HeldWorkers().started().clips.readClip({ sample: "walk-1" });
  const preset = info.presets.find(({ id }) => id === "lower-upper")!;
  const parts = preset.parts.map((part) => ({ ...part, latent: 1, poseIps: 1 }));
  const { spots, bones } = bodyOf({ ...info, parts }, motion);
  const heights = bones.flatMap(({ a, b }) => [a.y, b.y]);
  const [top, bottom] = [Math.min(...heights), Math.max(...heights)];
  expect(top).toBeGreaterThan(0);
  expect(bottom).toBeLessThan(HEIGHT);
  expect(bottom - top).toBeGreaterThan(0.8 * HEIGHT);
  const [lower, upper] = spots;
  expect(upper!.y).toBeLessThan(lower!.y);
});
