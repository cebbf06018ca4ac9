// Borrow arms: the legs of one recorded movement with the arms of another.
import { html, nothing } from "lit";
import { unsafeHTML } from "lit/directives/unsafe-html.js";
import { EQUATIONS } from "../../method/equations";
import { primitivesOf } from "../../primitives/combinations";
import type { LibraryStore } from "../../primitives/library-store";
import type { Settings } from "../../settings/settings";
import type { SettingsStore } from "../../settings/settings-store";
import { Store } from "../../ui/store";
import type { WordsStore } from "../../words/words";
import type { Chapter } from "../chapter";
import { type HandsAndFeet, measureHandsAndFeet } from "./hands-and-feet";

/** The parts of the library, in its order. */
const [LEGS, ARMS] = [0, 1] as const;
/** Arms whose hands are slower than this share of both recorded movements hardly move. */
const STILL = 0.5;

type Outcome = "own" | "legs" | "still";

/** The recorded movement that the arms are like: that of the arms, or that of the legs. */
export function outcomeOf(now: HandsAndFeet, own: HandsAndFeet, legs: HandsAndFeet): Outcome {
  if (now.speed < STILL * Math.min(own.speed, legs.speed)) return "still";
  return Math.abs(now.height - own.height) < Math.abs(now.height - legs.height) ? "own" : "legs";
}

export class BorrowChapter extends Store implements Chapter {
  readonly #words: WordsStore;
  readonly #settings: SettingsStore;
  readonly library: LibraryStore;
  #hasGuessed = false;
  /** The combination that the visitor left in the Lab; null: the chapter is not on screen. */
  #before: readonly number[] | null = null;
  #isHere = false;
  #stop = () => {};

  constructor(words: WordsStore, settings: SettingsStore, library: LibraryStore) {
    super();
    [this.#words, this.#settings, this.library] = [words, settings, library];
  }

  get words() {
    return this.#words.now.chapters.borrow;
  }

  get #recorded() {
    return this.library.current?.info.movements.filter(({ learned }) => learned) ?? [];
  }

  stage() {
    return html`<pg-borrow .library=${this.library} .label=${this.words.figure}></pg-borrow>`;
  }

  guess() {
    return this.#hasGuessed ? null : this.words.guess;
  }

  guessed(): void {
    this.#hasGuessed = true;
    this.#borrow();
    this.changed();
  }

  /** The legs of the first recorded movement with the arms of the second. */
  #borrow(): void {
    const [first, second] = this.#recorded;
    if (first && second) this.library.take([first.uses[LEGS]!, second.uses[ARMS]!]);
  }

  control() {
    const info = this.library.current?.info;
    if (!this.#hasGuessed || !info || info.parts.length !== 2) return null;
    const { parts } = this.words;
    const row = (part: number, label: string) => html`
      <span class="borrow-row"><span>${label}</span>
      <span class="story-choice" role="group" aria-label=${label}>
        ${primitivesOf(info, part).map(
          (primitive) => html`
          <button aria-pressed=${this.library.uses[part] === primitive ? "true" : "false"} data-testid="borrow-${part}-${primitive}"
            @click=${() => this.library.choose(part, primitive)}>${this.#name(info.primitives[primitive]?.name ?? "")}</button>`,
        )}</span></span>`;
    return html`<div class="borrow-choices">${row(LEGS, parts.legs)}${row(ARMS, parts.arms)}</div>`;
  }

  #name(movement: string): string {
    return this.words.movements[movement] ?? movement;
  }

  #measured(uses: readonly number[]): HandsAndFeet | null {
    const info = this.library.current?.info;
    const motion = this.library.motionOf(uses);
    return info && motion ? measureHandsAndFeet(info, motion) : null;
  }

  reveal() {
    if (!this.#hasGuessed) return null;
    const { compared, feet, hands, measuring, never, opening, outcome, recorded } = this.words;
    const { library } = this;
    if (!library.current) return html`<p>${library.problem || opening}</p>`;
    const { uses } = library;
    const now = this.#measured(uses);
    if (!now) return html`<p>${measuring}</p>`;
    const source = (part: number) => this.#recorded.find((movement) => movement.uses[part] === uses[part]);
    const [legs, arms] = [source(LEGS), source(ARMS)];
    const [own, before] = [arms && this.#measured(arms.uses), legs && this.#measured(legs.uses)];
    const isNew = library.recorded === null;
    const found = isNew && own && before ? outcomeOf(now, own, before) : null;
    return html`
      <p data-testid="borrowed" data-outcome=${found ?? ""}>
        <b>${library.recorded === null ? never : recorded(this.#name(library.recorded))} ${found ? outcome[found] : nothing}</b>
        ${hands(now.height, now.speed)}${isNew && own ? compared(own.height, own.speed) : nothing}.
        ${feet(now.steps)}
      </p>`;
  }

  equation() {
    return html`${unsafeHTML(EQUATIONS.dynamics)}${unsafeHTML(EQUATIONS.weights)}`;
  }

  lab(): Partial<Settings> {
    return { view: "primitives" };
  }

  arrive(): void {
    this.#isHere = true;
    this.#stop = this.library.on(() => this.changed());
    void this.#begin();
  }

  async #begin(): Promise<void> {
    await this.library.openFirst();
    if (!this.#isHere || !this.library.current) return;
    this.#before = this.library.uses;
    const [first] = this.#recorded;
    if (this.#hasGuessed) this.#borrow();
    else if (first) this.library.take(first.uses);
  }

  leave(): void {
    this.#isHere = false;
    this.#stop();
    const { chapter, view } = this.#settings.values;
    // The link to the Lab shows this combination there.
    const isInLab = chapter === 0 && view === "primitives";
    if (this.#before && !isInLab) this.library.take(this.#before);
    [this.#before, this.#hasGuessed] = [null, false];
  }
}
