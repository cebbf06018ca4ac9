// The chapters of the story. Each is loaded when it is opened or about to be.
import type { App } from "../app/app";
import type { Words } from "../words/words";
import type { Chapter } from "./chapter";

export type ChapterName = keyof Words["chapters"];

type Loading = Promise<{ openChapter(app: App): Promise<Chapter> }>;

/** In their order: chapter N has the address `#story=N`. The last one is extra. */
export const LOAD: Readonly<Record<ChapterName, () => Loading>> = {
  computer: () => import("./computer/chapter"),
  arms: () => import("./arms/chapter"),
  loop: () => import("./loop/chapter"),
  next: () => import("./next/chapter"),
  points: () => import("./points/chapter"),
  product: () => import("./product/chapter"),
  push: () => import("./push/chapter"),
  borrow: () => import("./borrow/chapter"),
  belief: () => import("./belief/chapter"),
  gaussian: () => import("./gaussian/chapter"),
};

export const CHAPTERS = Object.keys(LOAD) as ChapterName[];
