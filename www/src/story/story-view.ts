// The frame of the story: a stage above, a card below, and the way from chapter to chapter.
import { html, nothing } from "lit";
import type { App } from "../app/app";
import { isUsedByControl } from "../ui/keyboard";
import { addressOf, type ChapterName, chapterAt, ORDER } from "../settings/chapters";
import { initialSettings, writeSettings } from "../settings/settings";
import { IN_LAB } from "../settings/settings-store";
import { momentOf, takeMoment } from "../stage/moment";
import { whenIdle, prefersReducedMotion } from "../ui/browser";
import { View } from "../ui/view";
import { noticeCard } from "../ui/notices-view";
import type { Guess } from "./chapter";
import { siteHead } from "../app/site-head";
import { OpenChapters } from "./open-chapters";
import { Slides } from "./slides";
import { swipes } from "./swipe";
import { loadReplies, type Replies, repliesNow } from "../words/sections";
import "./story.css";
import "./story-foot.css";
import type { Words } from "../words/words";

interface Place {
  words: Words;
  /** The open chapter. */
  name: ChapterName;
  step(direction: 1 | -1): void;
}

const chevron = (path: string) => html`<svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"
  fill="none" stroke="currentColor" stroke-width="1.8" stroke-linecap="round" stroke-linejoin="round"><path d=${path}></path></svg>`;
const LEFT = "M10 3L5 8l5 5";
const RIGHT = "M6 3l5 5-5 5";

/** The list hides when a chapter is chosen. */
const hide = ({ currentTarget }: Event) =>
  (currentTarget as HTMLElement).closest<HTMLElement>("[popover]")?.hidePopover();

function list({ words, name }: Place) {
  return html`
    <ol id="story-chapters" popover data-testid="chapter-list">
      ${ORDER.map(
        (other, place) => html`
        <li>
          <a class="row" href="#story=${addressOf(other)}" aria-current=${other === name ? "step" : "false"} @click=${hide}>
            <span class="hint">${place + 1}</span> ${words.chapters[other].title}</a>
        </li>`,
      )}
    </ol>`;
}

function chapterPlace(place: Place) {
  const { words, name, step } = place;
  const [number, count] = [ORDER.indexOf(name) + 1, ORDER.length];
  const { frame } = words;
  return html`
    <nav class="story-place row" aria-label=${frame.chapters}>
      ${
        number > 1
          ? html`<button class="story-step quiet" aria-label=${frame.back} data-testid="chapter-back" @click=${() => step(-1)}>${chevron(LEFT)}</button>`
          : nothing
      }
      <button class="story-dots hint" popovertarget="story-chapters" data-testid="chapters">
        <span class="dots" aria-hidden="true">${Array.from(
          { length: count },
          (_, i) => html`<i class=${i + 1 === number ? "now" : i + 1 < number ? "past" : ""}></i>`,
        )}</span>
        <span>${frame.place(number, count)}</span>
      </button>
      ${
        number < count
          ? html`<button class="story-next" aria-label=${frame.nextChapter} data-testid="chapter-next" @click=${() => step(1)}>${frame.next} ${chevron(RIGHT)}</button>`
          : nothing
      }
      ${list(place)}
    </nav>`;
}

/** Milliseconds from one state to the next. */
const FADE = 300;

/** A measure in the browser's performance timeline: from the choice of a chapter to its stage and card. */
const TURN_MEASURE = "chapter-turn";

/** Keys of a keyboard and of a clicker. */
const STEPS: Record<string, 1 | -1> = { ArrowRight: 1, PageDown: 1, ArrowLeft: -1, PageUp: -1 };
/** Keys that show the answer in a lecture; so does a step forward, for a clicker. */
const REVEALS: readonly string[] = [" ", "Enter"];

export class StoryView extends View {
  declare app: App;
  #chapters!: OpenChapters;
  #slides!: Slides;
  /** The last guess in each chapter: the sentence about it, and its answer; null: nobody has said anything. */
  readonly #guesses = new Map<ChapterName, { sentence: string; answer: string } | null>();

  override connectedCallback(): void {
    this.#chapters ??= new OpenChapters(this.app);
    this.#slides ??= new Slides(this.app, this.app.story.notices, {
      slide: () => ({ chapter: this.#name, choices: this.#chapters.chapter?.guess()?.choices ?? {} }),
      fragment: () => this.#fragment(),
      key: (event) => this.#obey(event),
      changed: () => this.requestUpdate(),
    });
    super.connectedCallback();
  }

  protected override stores() {
    const { settings, words, lecture } = this.app;
    const { notices, engine } = this.app.story;
    return [settings, words, lecture, this.#chapters, notices, engine];
  }

  protected override arrived(): void {
    this.#follow();
    // The first chapter needs no engine, the others do.
    whenIdle(() => void this.app.story.start().catch(() => {}));
    this.whenLeaving(this.app.settings.on(() => this.#follow()));
    this.whenLeaving(this.app.story.stage.on(() => this.#restore()));
    this.whenLeaving(() => this.#chapters.leave());
    this.listen(document, "keydown", (event) => this.#obey(event as KeyboardEvent));
    const card = this.querySelector<HTMLElement>(".story-card");
    if (card) this.whenLeaving(swipes(card, (direction) => this.#step(direction)));
    this.listen(document, "fullscreenchange", () => !document.fullscreenElement && this.#slides.end());
    // A failed download may work now.
    this.listen(window, "online", () => this.#chapters.state === "failed" && location.reload());
  }

  get #name(): ChapterName {
    return chapterAt(this.app.settings.values.chapter);
  }

  /** Opens the chapter of the address. */
  #follow(): void {
    if (!this.app.isStory || this.#chapters.name === this.#name) return;
    const isFirst = this.#chapters.name === null;
    const [name, start] = [this.#name, performance.now()];
    const opened = this.#chapters.open(name);
    if (!isFirst) void this.#turn();
    void opened.then(async () => {
      await this.updateComplete;
      if (this.#chapters.chapter && this.#chapters.name === name)
        performance.measure(TURN_MEASURE, { start, detail: name });
      this.#restore();
    });
  }

  /** Shows the state of a link, once its chapter and its motion are there. */
  #restore(): void {
    const { settings } = this.app;
    const { cut } = settings.values;
    const { chapter, name } = this.#chapters;
    if (!chapter || name !== this.#name) return;
    if (cut !== "") {
      settings.change({ cut: "" });
      chapter.restore?.({ cut });
    }
    const { stage, playback } = this.app.story;
    takeMoment(settings, stage, playback);
  }

  /** The fragment of an address with this state. */
  #fragment(): string {
    const { stage, playback } = this.app.story;
    const { chapter } = this.#chapters;
    const moment = stage.live ? { camera: stage.camera() ?? [] } : momentOf(stage, playback, null);
    return writeSettings({
      ...initialSettings(),
      ...(stage.content ? moment : {}),
      ...chapter?.link?.(),
      chapter: addressOf(this.#name),
    });
  }

  /** The fragment with which the Lab shows this state, with camera and time. */
  #labFragment(): string {
    const { model, stage, playback } = this.app.story;
    const lab = { ...UNCOUPLED, ...this.#chapters.chapter?.lab(), ...IN_LAB };
    const moment = lab.view === "play" ? momentOf(stage, playback, model.rollout?.motion ?? null) : {};
    return writeSettings({ ...this.app.settings.written, ...lab, ...moment });
  }

  /** Fades stage and card, and tells screen readers of the new chapter by its title. */
  async #turn(): Promise<void> {
    await this.updateComplete;
    if (!prefersReducedMotion())
      for (const part of this.querySelectorAll(".story-stage, .story-card"))
        part.animate({ opacity: [0, 1] }, { duration: FADE, easing: "ease-out" });
    this.querySelector<HTMLElement>(".story-card h1")?.focus({ preventScroll: true });
    this.querySelector(".story-card")?.scrollTo(0, 0);
    scrollTo(0, 0);
  }

  #step(direction: 1 | -1): void {
    const next = ORDER[ORDER.indexOf(this.#name) + direction];
    if (next) this.app.settings.change({ chapter: addressOf(next) });
  }

  /** In a lecture a key shows the answer first, as most hands have guessed it; false: there is nothing to show. */
  #reveal(): boolean {
    const guess = this.#chapters.chapter?.guess();
    if (!guess || !this.app.lecture.isOn) return false;
    this.#guess(this.#slides.favourite ?? Object.keys(guess.choices)[0]!, this.#slides.favourite !== null);
    return true;
  }

  #obey(event: KeyboardEvent): void {
    if (event.defaultPrevented || isUsedByControl(event)) return;
    const direction = STEPS[event.key];
    const shows = direction === 1 || REVEALS.includes(event.key);
    if (shows && this.#reveal()) return void event.preventDefault();
    if (direction) this.#step(direction);
    else if (!this.#slides.key(event)) return;
    event.preventDefault();
  }

  /** The visitor's guess, or that of most hands of a class. */
  #said({ choices }: Guess, choice: string): { sentence: string; answer: string } {
    const { frame } = this.app.words.now;
    const answer = this.#slides.favourite ?? choice;
    const label = choices[answer] ?? answer;
    const { count, total } = this.#slides.hands(answer);
    return { sentence: total > 0 ? frame.hands(count, total, label) : frame.guessed(label), answer };
  }

  /** `isSaid`: somebody has said so. */
  #guess(choice: string, isSaid = true): void {
    const { chapter } = this.#chapters;
    const guess = chapter?.guess();
    if (!chapter || !guess) return;
    // A pin is on the stage; its button alone says nothing.
    const isChoice = Object.keys(guess.choices).length > 1;
    this.#guesses.set(this.#name, isSaid && isChoice ? this.#said(guess, choice) : null);
    this.#loadReplies();
    chapter.guessed(choice);
    // The pressed button leaves; the focus stays in the card.
    void this.updateComplete.then(() => {
      this.querySelector<HTMLElement>(".story-answer")?.focus({ preventScroll: true });
      scrollTo(0, 0);
    });
  }

  /** A message in place of a chapter that is not there. */
  #missing() {
    const { frame } = this.app.words.now;
    if (this.#chapters.state === "failed")
      return html`<div class="story-missing stack quiet" role="alert"><p>${frame.notLoaded}</p>
        <button class="story-button" data-testid="try-again" @click=${() => location.reload()}>${frame.tryAgain}</button></div>`;
    return html`<p class="visually-hidden" role="status">${frame.loading}</p>`;
  }

  /** What the visitor should know of the story's model. */
  #notices() {
    const { frame } = this.app.words.now;
    const { engine, notices } = this.app.story;
    const isBroken = engine.state === "failed" || engine.state === "stopped";
    return html`
      <div class="story-notices">
        ${isBroken ? html`<p class="banner" role="alert">${frame.noModel(engine.problem)}</p>` : nothing}
        ${notices.all.map((notice) => noticeCard(notices, notice, frame.dismiss))}
      </div>`;
  }

  get #isAnswered(): boolean {
    const { chapter } = this.#chapters;
    return chapter !== null && chapter.guess() === null && this.#guesses.has(this.#name);
  }

  /** The number of hands for an answer, once one was counted. */
  #hands(choice: string) {
    const { count, total } = this.#slides.hands(choice);
    return total > 0
      ? html` <b class="story-hands tabular" data-testid="hands-${choice}">${count}</b>`
      : nothing;
  }

  #question() {
    const guess = this.#chapters.chapter?.guess();
    if (!guess) return nothing;
    return html`
      <fieldset class="story-guess">
        <legend>${guess.question}</legend>
        <div class="wrap loose">${Object.entries(guess.choices).map(
          ([choice, label]) =>
            html`<button class="story-button" data-testid="choice-${choice}" @click=${() => this.#guess(choice)}>${label}${this.#hands(choice)}</button>`,
        )}</div>
      </fieldset>`;
  }

  #loadReplies(): void {
    loadReplies(this.app.words).then(
      () => this.requestUpdate(),
      () => {}, // The measured answer is there all the same.
    );
  }

  /** Whether the guess was right, wrong, or right for another question. */
  #reply(answer: string): string {
    const replies = repliesNow()?.[this.#name as keyof Replies] as
      | Readonly<Record<string, string>>
      | undefined;
    const reply = replies?.[answer];
    return reply ? `. ${reply}` : "";
  }

  /** What follows a guess: the guess, the measured answer, and the control. */
  #answer() {
    const { chapter } = this.#chapters;
    const guess = chapter?.guess();
    const said = this.#guesses.get(this.#name);
    const reveal = chapter?.reveal();
    return html`
      <div class="story-answer stack" tabindex="-1" data-testid="answer">
        ${!guess && said ? html`<p class="story-said quiet">${said.sentence}${this.#reply(said.answer)}</p>` : nothing}
        <div class="stack" aria-live="polite" data-testid="reveal">${reveal ?? nothing}</div>
      </div>
      <div class="story-control">${chapter?.control() ?? nothing}</div>`;
  }

  #more() {
    const { frame } = this.app.words.now;
    const { chapter } = this.#chapters;
    // Both would give an answer away.
    if (!chapter || (chapter.guess() && !chapter.reveal())) return nothing;
    const equation = chapter.equation();
    // The time of the motion goes on: the link takes it when it is used.
    const update = ({ currentTarget }: Event) => {
      (currentTarget as HTMLAnchorElement).href = `#${this.#labFragment()}`;
    };
    return html`
      <div class="story-more row">
        ${equation ? html`<details><summary class="row quiet">${frame.equation}</summary><div class="story-equation">${equation}</div></details>` : nothing}
        <a class="row quiet" href="#${this.#labFragment()}" data-testid="open-in-lab" @pointerdown=${update} @focus=${update} @click=${update}>${frame.openInLab}</a>
      </div>`;
  }

  protected override updated(): void {
    this.#slides.update();
    document.title = `${this.app.words.now.chapters[this.#name].title} · ${this.app.words.now.frame.page}`;
  }

  protected override render() {
    const { embedded, lecture, words } = this.app;
    const { title, text } = words.now.chapters[this.#name];
    return html`
      <div class="story column" data-embed=${embedded ? "1" : "0"} data-state=${this.#chapters.state} data-engine=${this.app.story.engine.state} data-chapter=${this.#name} ?data-lecture=${lecture.isOn}>
        ${embedded || lecture.isOn ? nothing : siteHead(this.app, "story")}
        <main class="column">
          <section class="story-stage" aria-label=${words.now.frame.stage}>
            ${this.#chapters.chapter?.stage() ?? this.#missing()}
          </section>
          <article class="story-card" ?data-answered=${this.#isAnswered}>
            <h1 tabindex="-1">${title}</h1>
            <p class="story-text">${text}</p>
            <div class="story-side column">${this.#question()}${this.#answer()}</div>
          </article>
          <div class="story-foot row spread">
            ${embedded ? nothing : chapterPlace({ words: words.now, name: this.#name, step: (by) => this.#step(by) })}
            ${this.#more()}
          </div>
        </main>
        ${this.#notices()}
      </div>`;
  }
}
customElements.define("pg-story", StoryView);

const { alpha, view, reading, model, start, startFrame } = initialSettings();
/** The settings of the Lab that belong to the state of a chapter. */
const UNCOUPLED = { alpha, view, reading, model, start, startFrame };
