// The chapters as slides of a lecture: hands are counted by keys, and the notes are in a second window.
import { html, nothing, render } from "lit";
import type { App } from "../app/app";
import { type ChapterName, ORDER } from "../settings/chapters";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { loadTeach, teachWords } from "../words/sections";
import { languageChanges } from "../ui/language";
import { lengthOfPlan, type Step, type StepWords, timesOf } from "./plans";
import "./notes.css";

export class Tally extends Store {
  readonly #hands = new Map<string, string[]>();

  /** Counts a hand for an answer to a question. */
  add(question: string, answer: string): void {
    const hands = this.#hands.get(question) ?? [];
    this.#hands.set(question, [...hands, answer]);
    this.changed();
  }

  /** Takes the last hand of a question back. */
  takeBack(question: string): void {
    this.#hands.set(question, this.#hands.get(question)?.slice(0, -1) ?? []);
    this.changed();
  }

  count(question: string, answer: string): number {
    return this.#hands.get(question)?.filter((hand) => hand === answer).length ?? 0;
  }

  total(question: string): number {
    return this.#hands.get(question)?.length ?? 0;
  }

  /** The answer with the most hands; null: no hand was counted, or two answers have as many. */
  favourite(question: string): string | null {
    const answers = [...new Set(this.#hands.get(question))];
    const [first, second] = answers
      .map((answer) => ({ answer, hands: this.count(question, answer) }))
      .sort((a, b) => b.hands - a.hands);
    return first && first.hands !== second?.hands ? first.answer : null;
  }
}

/** What the story shows. */
export interface Shown {
  slide(): Slide;
  /** A key of the window with the notes. */
  key(event: KeyboardEvent): void;
}

/** The open chapter of the story, and its open question. */
export interface Slide {
  chapter: Step;
  /** The answers by id; none after the answer. */
  choices: Readonly<Record<string, string>>;
}

const WINDOW = "popup,width=520,height=720";

export class Lecture extends Store {
  readonly #app: App;
  readonly #notices: NoticesStore;
  readonly #shown: Shown;
  readonly tally = new Tally();
  #window: Window | null = null;

  private constructor(app: App, notices: NoticesStore, shown: Shown) {
    super();
    [this.#app, this.#notices, this.#shown] = [app, notices, shown];
    for (const store of [this.tally, languageChanges]) store.on(() => this.changed());
    this.on(() => this.showSlide());
  }

  static async open(app: App, notices: NoticesStore, shown: Shown): Promise<Lecture> {
    await loadTeach(app.words);
    return new Lecture(app, notices, shown);
  }

  /** Does what a key asks for. */
  key(key: string): void {
    const { chapter, choices } = this.#shown.slide();
    const answer = Object.keys(choices)[Number(key) - 1];
    if (key === "n") this.#openNotes();
    else if (answer !== undefined) this.tally.add(chapter, answer);
    else if (key === "Backspace") this.tally.takeBack(chapter);
  }

  #openNotes(): void {
    const { notes } = teachWords();
    if (this.#window && !this.#window.closed) {
      this.#window.focus();
      return;
    }
    this.#window = window.open("", "vcgpdm-notes", WINDOW);
    if (!this.#window) {
      this.#notices.addError(notes.title, notes.blocked);
      return;
    }
    const { document: page } = this.#window;
    for (const link of document.querySelectorAll<HTMLLinkElement>("link[rel=stylesheet]")) {
      const copy = page.createElement("link");
      Object.assign(copy, { rel: "stylesheet", href: link.href });
      page.head.append(copy);
    }
    page.addEventListener("keydown", (event) => this.#shown.key(event));
    this.showSlide();
  }

  /** Shows the notes of the open chapter. */
  showSlide(): void {
    if (!this.#window || this.#window.closed) return;
    const { document: page } = this.#window;
    const { notes, steps } = teachWords();
    const words = this.#app.words.now;
    const { chapter, choices } = this.#shown.slide();
    const titleOf = (name: string | undefined) => words.chapters[name as ChapterName]?.title;
    const { say, wrong, answer, asked }: StepWords = steps[chapter];
    const time = timesOf(lengthOfPlan()).find(({ step }) => step === chapter);
    const next = titleOf(ORDER[ORDER.indexOf(chapter as ChapterName) + 1]);
    page.documentElement.lang = this.#app.words.language;
    page.title = notes.title;
    const hands = Object.entries(choices);
    render(
      html`<main class="notes">
        <h1>${titleOf(chapter)}</h1>
        ${time ? html`<p>${notes.minutes(time.from, time.to)}</p>` : nothing}
        <h2>${notes.say}</h2><p>${say}</p>
        ${answer ? html`<h2>${notes.answer}</h2><p>${answer}</p>` : nothing}
        ${asked ? html`<h2>${notes.asked}</h2><dl>${asked.map(([question, reply]) => html`<dt>${question}</dt><dd>${reply}</dd>`)}</dl>` : nothing}
        <h2>${notes.wrong}</h2><p>${wrong}</p>
        ${
          hands.length > 0
            ? html`<h2>${notes.hands}</h2><ol>${hands.map(([id, label]) => html`<li>${label}: <b>${this.tally.count(chapter, id)}</b></li>`)}</ol>`
            : nothing
        }
        ${next ? html`<p class="notes-next quiet">${notes.next(next)}</p>` : nothing}
      </main>`,
      page.body,
    );
  }
}
