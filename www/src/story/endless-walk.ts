// The walk of a chapter without an end: the stored seconds at once, the live motion when the model is there.
import type { LiveStore } from "../live/live-store";
import { prefersReducedMotion } from "../ui/browser";
import type { StoryBody } from "../app/story-body";

export class EndlessWalk {
  readonly #changed: () => void;
  #isHere = false;

  /** `changed`: playing or live has changed; `begins`: the live motion is about to start, or goes on. */
  constructor(
    private readonly body: StoryBody,
    changed: () => void,
    private readonly begins: (live: LiveStore) => void = () => {},
  ) {
    this.#changed = changed;
  }

  /** Whether the chapter is on screen. */
  get isHere(): boolean {
    return this.#isHere;
  }

  arrive(): void {
    this.#isHere = true;
    void this.#arrive();
  }

  leave(): void {
    this.#isHere = false;
    this.body.reset();
  }

  async #arrive(): Promise<void> {
    const calm = prefersReducedMotion();
    try {
      await this.body.showFirstMotion();
      if (!calm) this.body.playback.play();
      this.#changed();
      await this.body.start();
      if (this.#isHere && !calm) await this.#walk();
    } catch {
      // The frame says why the model cannot run here.
    }
  }

  /** Plays, and lets the model walk on. */
  walk(): void {
    // The frame says why the model cannot run here.
    this.#walk().catch(() => {});
  }

  async #walk(): Promise<void> {
    this.body.playback.play();
    await this.body.start();
    const live = await this.body.live.get();
    if (!this.#isHere) return;
    this.begins(live);
    await live.start();
    this.#changed();
  }
}
