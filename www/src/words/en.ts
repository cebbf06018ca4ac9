// The English words of the page. The other languages have the type of this file, so that the compiler finds a
// missing sentence.
import { arms } from "./en/arms";
import { belief } from "./en/belief";
import { borrow } from "./en/borrow";
import { computer } from "./en/computer";
import { frame } from "./en/frame";
import { end } from "./en/end";
import { gaussian } from "./en/gaussian";
import { loop } from "./en/loop";
import { next } from "./en/next";
import { points } from "./en/points";
import { product } from "./en/product";
import { push } from "./en/push";

export const words = {
  frame,
  /** The chapters of the story, in their order. */
  chapters: { computer, arms, loop, next, points, product, push, borrow, belief, gaussian, end },
};

export type Words = typeof words;
