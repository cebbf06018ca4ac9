// Which one is a computer? Two walkers as points of light: a program's walk, and a model that predicts it.
import { html, nothing } from "lit";
import { prefersReducedMotion } from "../../ui/reduced-motion";
import { Store } from "../../ui/store";
import type { WordsStore } from "../../words/words";
import type { Chapter } from "../chapter";
import { randomNumbers } from "../../ui/random-numbers";
import { meanDistance, type WalkerPair, type Walkers } from "./walkers";

export type WalkerSide = "left" | "right";

/** With this seed the model is not on the same side in both pairs. */
const SEED = 1;

const otherSide = (side: WalkerSide): WalkerSide => (side === "left" ? "right" : "left");

export class ComputerChapter extends Store implements Chapter {
  readonly #words: WordsStore;
  readonly #walkers: Walkers;
  /** The side of the model in each pair. */
  readonly #sides: WalkerSide[];
  #place = 0;
  #choice: WalkerSide | null = null;
  #found = 0;
  #playing = false;

  /** `random`: the model is on the left below 0.5. */
  constructor(words: WordsStore, walkers: Walkers, random = randomNumbers(SEED)) {
    super();
    this.#words = words;
    this.#walkers = walkers;
    this.#sides = walkers.pairs.map(() => (random() < 0.5 ? "left" : "right"));
  }

  get #now() {
    return this.#words.now.chapters.computer;
  }

  get body() {
    return this.#walkers.body;
  }

  get pair(): WalkerPair {
    return this.#walkers.pairs[this.#place]!;
  }

  get modelSide(): WalkerSide {
    return this.#sides[this.#place]!;
  }

  get playing(): boolean {
    return this.#playing;
  }

  /** Whether the visitor has not answered for this pair. */
  get isOpen(): boolean {
    return this.#choice === null;
  }

  /** The names below the walkers, from left to right; empty before the guess. */
  get names(): readonly string[] {
    const { program, model } = this.#now.names;
    if (this.isOpen) return ["", ""];
    return this.modelSide === "left" ? [model, program] : [program, model];
  }

  stage() {
    return html`<pg-walkers class="walkers" .chapter=${this}></pg-walkers>`;
  }

  guess() {
    return this.isOpen ? this.#now.guess : null;
  }

  guessed(choice: string): void {
    if (!this.isOpen || (choice !== "left" && choice !== "right")) return;
    this.#choice = choice;
    if (choice === this.modelSide) this.#found += 1;
    this.changed();
  }

  control() {
    const { play, next, again } = this.#now;
    if (!this.#playing)
      return html`<button class="story-button" data-testid="walk" @click=${() => this.#play()}>${play}</button>`;
    if (this.isOpen) return null;
    const isLast = this.#place === this.#walkers.pairs.length - 1;
    return html`<button class="story-button" data-testid="next-pair" @click=${() => this.#turn()}>${isLast ? again : next}</button>`;
  }

  reveal() {
    if (this.isOpen) return null;
    const { right, wrong, apart, score } = this.#now;
    const asked = this.#place + 1;
    return html`
      <p data-testid="verdict">${(this.#choice === this.modelSide ? right : wrong)[this.modelSide]} ${apart(meanDistance(this.pair))}</p>
      ${asked > 1 ? html`<p data-testid="score">${score(this.#found, asked)}</p>` : nothing}`;
  }

  equation() {
    return null;
  }

  lab() {
    return { view: "perception" as const };
  }

  arrive(): void {
    if (!prefersReducedMotion()) this.#play();
  }

  leave(): void {
    this.#playing = false;
  }

  #play(): void {
    this.#playing = true;
    this.changed();
  }

  /** The next pair; after the last one the first again, with the sides exchanged. */
  #turn(): void {
    this.#choice = null;
    this.#place += 1;
    if (this.#place === this.#walkers.pairs.length) {
      [this.#place, this.#found] = [0, 0];
      this.#sides.forEach((side, i) => {
        this.#sides[i] = otherSide(side);
      });
    }
    this.changed();
  }
}
