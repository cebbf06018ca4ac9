import { expect, it } from "vitest";
import { popoverPlace } from "./card";

const phone = { width: 390, height: 600 };
const box = { width: 300, height: 120 };
const at = (x: number, y: number) => ({ x, y, width: 40, height: 20 });

it("a popover is below its control, or above it near the lower edge, and always within the window", () => {
  expect(popoverPlace(at(20, 100), box, phone)).toEqual({ left: 20, top: 124 });
  expect(popoverPlace(at(20, 550), box, phone)).toEqual({ left: 20, top: 426 });
  expect(popoverPlace(at(340, 100), box, phone)).toEqual({ left: 82, top: 124 });
  expect(popoverPlace(at(-30, 100), box, phone).left).toBe(8);
  expect(popoverPlace(at(20, 60), { width: 300, height: 560 }, phone).top).toBe(32);
});
