// A chapter with one question: its words, its guess, and what it listens to while it is on screen.
import { html, nothing, type TemplateResult } from "lit";
import { unsafeHTML } from "lit/directives/unsafe-html.js";
import type { EQUATIONS } from "../method/equations";
import type { ChapterName } from "../settings/chapters";
import type { Settings } from "../settings/settings";
import { Store } from "../ui/store";
import type { Words, WordsStore } from "../words/words";
import type { Chapter, Guess } from "./chapter";

/** Loaded when the first chapter with equations is on screen: a first visit needs none. */
let loaded: typeof EQUATIONS | null = null;

export abstract class GuessedChapter<Name extends ChapterName> extends Store implements Chapter {
  protected readonly allWords: WordsStore;
  /** The visitor's guess; null before. */
  protected choice: string | null = null;
  /** Called when the chapter leaves the screen. */
  protected stops: (() => void)[] = [];

  constructor(
    words: WordsStore,
    private readonly name: Name,
  ) {
    super();
    this.allWords = words;
  }

  get words(): Words["chapters"][Name] {
    return this.allWords.now.chapters[this.name];
  }

  protected get hasGuessed(): boolean {
    return this.choice !== null;
  }

  abstract stage(): TemplateResult;
  abstract control(): TemplateResult | null;
  abstract reveal(): TemplateResult | null;
  abstract equation(): TemplateResult | null;

  /** `sentence`: null, if it needs a model that has not arrived. */
  protected equations(names: readonly (keyof typeof EQUATIONS)[], sentence: string | null): TemplateResult {
    const show = (all: { EQUATIONS: typeof EQUATIONS }) => {
      loaded = all.EQUATIONS;
      this.changed();
    };
    if (!loaded) import("../method/equations").then(show).catch(() => {});
    return html`${names.map((name) => loaded && unsafeHTML(loaded[name]))}${sentence === null ? nothing : html`<p>${sentence}</p>`}`;
  }

  guess(): Guess | null {
    return this.hasGuessed ? null : (this.words as { guess: Guess }).guess;
  }

  guessed(choice: string): void {
    this.choice = choice;
    this.changed();
  }

  lab(): Partial<Settings> {
    return {};
  }

  arrive(): void {}

  leave(): void {
    for (const stop of this.stops.splice(0)) stop();
    this.choice = null;
  }
}
