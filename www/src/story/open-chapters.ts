// The chapters that have been loaded, the one on screen, and the one that is about to be.
import type { App } from "../app/app";
import { firstMove, whenIdle } from "../ui/browser";
import { Lazy } from "../ui/lazy";
import { Store } from "../ui/store";
import type { Chapter } from "./chapter";
import { type ChapterName, ORDER } from "../settings/chapters";

type Loading = Promise<{ openChapter(app: App): Promise<Chapter> }>;

const LOAD: Readonly<Record<ChapterName, () => Loading>> = {
  hand: () => import("./hand/hand-chapter"),
  arms: () => import("./arms/arms-chapter"),
  loop: () => import("./loop/loop-chapter"),
  next: () => import("./next/next-chapter"),
  points: () => import("./points/points-chapter"),
  product: () => import("./product/product-chapter"),
  push: () => import("./push/push-chapter"),
  borrow: () => import("./borrow/borrow-chapter"),
  belief: () => import("./belief/belief-chapter"),
  gaussian: () => import("./gaussian/gaussian-chapter"),
  end: () => import("./end/end-chapter"),
};

/** "loading" and "failed" are about the chapter that the visitor asked for last. */
export type ChapterState = "loading" | "open" | "failed";

export class OpenChapters extends Store {
  readonly #loaded = new Map<ChapterName, Lazy<Chapter>>();
  #name: ChapterName | null = null;
  #chapter: Chapter | null = null;
  #state: ChapterState = "loading";
  #stop = () => {};
  readonly #moved = firstMove();

  constructor(private readonly app: App) {
    super();
  }

  /** The chapter that the visitor asked for last; null before the first. */
  get name(): ChapterName | null {
    return this.#name;
  }

  /** The chapter on screen; null while it loads. */
  get chapter(): Chapter | null {
    return this.#chapter;
  }

  get state(): ChapterState {
    return this.#state;
  }

  /** Opens a chapter; the one on screen leaves. */
  async open(name: ChapterName): Promise<void> {
    if (name === this.#name) return;
    this.leave();
    this.#name = name;
    this.#state = "loading";
    try {
      const opened = this.#lazy(name);
      if (!opened.loaded) this.changed();
      const chapter = await opened.get();
      if (this.#name !== name) return;
      this.#chapter = chapter;
      this.#state = "open";
      this.#stop = chapter.on(() => this.changed());
      chapter.arrive();
      // A visit that only looks does without the next chapter.
      void this.#moved.then(() => whenIdle(() => this.#preload(name)));
    } catch {
      if (this.#name !== name) return;
      this.#state = "failed";
    }
    this.changed();
  }

  /** The chapter on screen leaves. */
  leave(): void {
    this.#stop();
    this.#stop = () => {};
    this.#chapter?.leave();
    [this.#chapter, this.#name] = [null, null];
  }

  #lazy(name: ChapterName): Lazy<Chapter> {
    const before = this.#loaded.get(name);
    if (before) return before;
    const opened = new Lazy(async () => (await LOAD[name]()).openChapter(this.app));
    this.#loaded.set(name, opened);
    return opened;
  }

  /** Loads the program of the next chapter. */
  #preload(name: ChapterName): void {
    const next = ORDER[ORDER.indexOf(name) + 1];
    if (next) LOAD[next]().catch(() => {});
  }
}
