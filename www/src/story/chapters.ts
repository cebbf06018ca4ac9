// The chapters of the story, in their order. Each is loaded when it is opened or about to be.
import type { App } from "../app/app";
import type { Words } from "../words/words";
import type { Chapter } from "./chapter";

export type ChapterName = keyof Words["chapters"];

type Loading = Promise<{ openChapter(app: App): Promise<Chapter> }>;

/** Chapter N has the address `#story=N`. */
export const CHAPTERS: readonly ChapterName[] = [
  "computer",
  "arms",
  "loop",
  "next",
  "points",
  "product",
  "push",
  "borrow",
  "belief",
  "gaussian",
];

export const LOAD: Partial<Record<ChapterName, () => Loading>> = {
  arms: () => import("./arms/chapter"),
  belief: () => import("./belief/chapter"),
  borrow: () => import("./borrow/chapter"),
  computer: () => import("./computer/chapter"),
  loop: () => import("./loop/chapter"),
  next: () => import("./next/chapter"),
  points: () => import("./points/chapter"),
  product: () => import("./product/chapter"),
  gaussian: () => import("./gaussian/chapter"),
  push: () => import("./push/chapter"),
};

/** Whether chapter N has been written. */
export const isThere = (number: number): boolean => CHAPTERS[number - 1]! in LOAD;
