import { expect, it } from "vitest";
import { PictureQuality } from "./picture-quality";

function run(pace: PictureQuality, frames: number, seconds: number, changed = true, playing = true) {
  let last = "";
  for (let i = 0; i < frames; i++) {
    last = pace.next(seconds, changed, playing);
    if (changed) pace.drawn();
  }
  return last;
}

it("draws in fine quality on a fast machine", () => {
  expect(run(new PictureQuality(), 100, 0.017)).toBe("fine");
  expect(run(new PictureQuality(), 100, 0.033)).toBe("fine");
});

it("changes to plain on a slow machine, and later back to fine", () => {
  const pace = new PictureQuality();
  expect(run(pace, 30, 0.07)).toBe("plain");
  expect(run(pace, 60, 0.017)).toBe("fine");
});

it("is coarse only during a drag", () => {
  const pace = new PictureQuality();
  run(pace, 30, 0.07);
  pace.next(0.5, false, false);
  expect(pace.next(0.07, true, false)).toBe("plain");
  expect(pace.next(0.07, true, false)).toBe("coarse");
  expect(pace.next(0.1, false, false)).toBe("coarse");
  expect(pace.next(0.2, false, false)).toBe("plain");
});

it("does not count idle frames as fast frames", () => {
  const pace = new PictureQuality();
  run(pace, 30, 0.07);
  expect(run(pace, 200, 0.016, false)).toBe("plain");
});
