// The German words of the page.
import { arms } from "./de/arms";
import { belief } from "./de/belief";
import { borrow } from "./de/borrow";
import { computer } from "./de/computer";
import { frame } from "./de/frame";
import { end } from "./de/end";
import { gaussian } from "./de/gaussian";
import { loop } from "./de/loop";
import { next } from "./de/next";
import { points } from "./de/points";
import { product } from "./de/product";
import { push } from "./de/push";
import type { Words } from "./en";

export const words: Words = {
  frame,
  /** The chapters of the story, in their order. */
  chapters: { computer, arms, loop, next, points, product, push, borrow, belief, gaussian, end },
};
