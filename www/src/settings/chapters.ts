// The chapters of the story: their addresses and their order.
import type { Words } from "../words/words";

export type ChapterName = keyof Words["chapters"];

/** `#story=N` opens the Nth of them, so that a new chapter changes no address. */
const ADDRESSES: readonly ChapterName[] = [
  ...(["hand", "arms", "loop", "next", "points", "product"] as const),
  ...(["push", "borrow", "belief", "gaussian", "end"] as const),
];

/** In the order of the story. A Gaussian process comes before the chapter that uses one. */
export const ORDER: readonly ChapterName[] = [
  ...(["hand", "arms", "loop", "gaussian", "next", "points"] as const),
  ...(["product", "push", "borrow", "belief", "end"] as const),
];

export const LAST_CHAPTER = ADDRESSES.length;

/** The chapter of an address; the first for 0. */
export const chapterAt = (address: number): ChapterName => ADDRESSES[Math.max(1, address) - 1] ?? "hand";

/** The number of a chapter in its address; 0: it is none. */
export const addressOf = (name: string): number => ADDRESSES.indexOf(name as ChapterName) + 1;
