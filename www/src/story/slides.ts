// The keys of a lecturer in the story: hands, notes and the QR code. Their program loads at its first use.
import type { App } from "../app/app";
import { Lazy } from "../ui/lazy";
import type { Lecture, Shown as ShownInLecture } from "../teach/lecture";
import type { NoticesStore } from "../ui/notices-store";

/** What the story shows now. */
export interface Shown extends ShownInLecture {
  /** The fragment of an address with this state. */
  fragment(): string;
  changed(): void;
}

export class Slides {
  readonly #lecture: Lazy<Lecture>;

  constructor(
    private readonly app: App,
    private readonly notices: NoticesStore,
    private readonly shown: Shown,
  ) {
    this.#lecture = new Lazy(async () => {
      const { Lecture } = await import("../teach/lecture");
      const lecture = await Lecture.open(app, notices, shown);
      lecture.tally.on(() => shown.changed());
      return lecture;
    });
  }

  /** The number of hands for an answer in the open chapter, and of all hands. */
  hands(choice: string): { count: number; total: number } {
    const { tally } = this.#lecture.loaded ?? {};
    const { chapter } = this.shown.slide();
    return { count: tally?.count(chapter, choice) ?? 0, total: tally?.total(chapter) ?? 0 };
  }

  /** The answer of most hands in the open chapter; null: none. */
  get favourite(): string | null {
    return this.#lecture.loaded?.tally.favourite(this.shown.slide().chapter) ?? null;
  }

  /** Another chapter or another answer is on the screen. */
  update(): void {
    this.#lecture.loaded?.showSlide();
  }

  /** Does what a key asks for; false: nothing. */
  key(event: KeyboardEvent): boolean {
    const { lecture } = this.app;
    const isOfLecture = lecture.isOn && /^([1-9]|Backspace)$/.test(event.key);
    if (event.key === "Escape" && lecture.isOn) this.end();
    else if (event.key === "q") this.#try(this.#showCode());
    else if (event.key === "n" || isOfLecture)
      this.#try(this.#lecture.get().then((opened) => opened.key(event.key)));
    else return false;
    return true;
  }

  async #showCode(): Promise<void> {
    await (await import("../app/code-dialog")).showCode(this.app, this.shown.fragment());
  }

  /** The page for teachers again, in the window. */
  end(): void {
    if (!this.app.lecture.isOn) return;
    this.app.lecture.turn(false);
    if (document.fullscreenElement) void document.exitFullscreen();
    this.app.settings.change({ chapter: 0, teach: true });
  }

  #try(work: Promise<void>): void {
    const { teach, notLoaded } = this.app.words.now.frame;
    work.catch(() => this.notices.addError(teach, notLoaded));
  }
}
