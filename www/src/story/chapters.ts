// The chapters of the story. Each is loaded when it is opened or about to be.
import type { App } from "../app/app";
import type { ChapterName } from "../settings/chapters";
import type { Chapter } from "./chapter";

type Loading = Promise<{ openChapter(app: App): Promise<Chapter> }>;

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
  end: () => import("./end/chapter"),
};
