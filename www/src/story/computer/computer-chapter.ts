// Which one is a computer? Two walkers as points of light: a program's walk, and a model that predicts it.
import { html, nothing } from "lit";
import { prefersReducedMotion, eachFrame } from "../../ui/browser";
import { Store } from "../../ui/store";
import type { WordsStore } from "../../words/words";
import { type Chapter, tellGuess } from "../chapter";
import { randomNumbers } from "../../ui/random-numbers";
import { meanDistance, type WalkerPair, type Walkers, fetchWalkers } from "./walkers";
import type { App } from "../../app/app";
import { Columns } from "../../scene/columns";
import { underWay } from "../../scene/under-way";
import { View } from "../../ui/view";
import "./computer.css";

/** The heading of both: sideways, and a little towards the visitor. */
const HEADING = Math.PI / 3;
/** Seconds in which a movement comes and goes. */
const COMING = 0.25;

class WalkersView extends View {
  declare chapter: ComputerChapter;
  #columns: Columns | null = null;
  #drawn: unknown = null;
  #seconds = 0;

  protected override stores() {
    return [this.chapter];
  }

  protected override arrived(): void {
    const canvas = this.querySelector("canvas");
    if (!canvas) return;
    try {
      this.#columns = new Columns(canvas, { from: 0, turns: false });
    } catch {
      // Without WebGL the buttons of the card still work.
      return;
    }
    const columns = this.#columns;
    this.whenLeaving(() => {
      columns.dispose();
      [this.#columns, this.#drawn] = [null, null];
    });
    this.#show();
    this.whenLeaving(eachFrame((seconds) => this.#draw(columns, canvas, seconds)));
  }

  #draw(columns: Columns, canvas: HTMLCanvasElement, seconds: number): void {
    const { pair, playing } = this.chapter;
    const { frames, frameTime } = pair.program.motion;
    const length = (frames - 1) * frameTime;
    if (playing) this.#seconds = (this.#seconds + seconds) % length;
    columns.draw(this.#seconds / frameTime, true, seconds, playing);
    const edge = Math.min(this.#seconds, length - this.#seconds) / COMING;
    canvas.style.opacity = String(playing ? Math.min(1, 0.1 + edge) : 1);
  }

  /** Shows the pair from its first pose. */
  #show(): void {
    const { pair, body, modelSide } = this.chapter;
    if (!this.#columns || pair === this.#drawn) return;
    this.#drawn = pair;
    this.#seconds = 0;
    const walkers = modelSide === "left" ? [pair.model, pair.program] : [pair.program, pair.model];
    this.#columns.show(
      body,
      walkers.map(({ motion, speed }) => underWay(motion, speed, HEADING)),
    );
  }

  protected override updated(): void {
    this.#show();
  }

  #tap({ offsetX, currentTarget }: MouseEvent): void {
    const { clientWidth } = currentTarget as HTMLElement;
    tellGuess(this, offsetX < clientWidth / 2 ? "left" : "right");
  }

  protected override render() {
    const { names, isOpen } = this.chapter;
    return html`
      <div class="walker-screen"><canvas class=${isOpen ? "asks" : ""} aria-hidden="true" data-testid="walkers" @click=${this.#tap}></canvas></div>
      <ol class="walker-names">${names.map((name) => html`<li>${name || nothing}</li>`)}</ol>`;
  }
}
customElements.define("pg-walkers", WalkersView);

export type WalkerSide = "left" | "right";

/** With this seed the model is not on the same side in both pairs. */
const SEED = 1;

const otherSide = (side: WalkerSide): WalkerSide => (side === "left" ? "right" : "left");

export class ComputerChapter extends Store implements Chapter {
  readonly #words: WordsStore;
  /** The side of the model in each pair. */
  readonly #sides: WalkerSide[];
  #place = 0;
  #choice: WalkerSide | null = null;
  #found = 0;
  #playing = false;

  /** `random`: the model is on the left below 0.5. */
  constructor(
    words: WordsStore,
    private readonly walkers: Walkers,
    random = randomNumbers(SEED),
  ) {
    super();
    this.#words = words;
    this.#sides = walkers.pairs.map(() => (random() < 0.5 ? "left" : "right"));
  }

  get #now() {
    return this.#words.now.chapters.computer;
  }

  get body() {
    return this.walkers.body;
  }

  get pair(): WalkerPair {
    return this.walkers.pairs[this.#place]!;
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
    const isLast = this.#place === this.walkers.pairs.length - 1;
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
    if (this.#place === this.walkers.pairs.length) {
      [this.#place, this.#found] = [0, 0];
      this.#sides.forEach((side, i) => {
        this.#sides[i] = otherSide(side);
      });
    }
    this.changed();
  }
}

export async function openChapter({ words }: App): Promise<Chapter> {
  return new ComputerChapter(words, await fetchWalkers());
}
