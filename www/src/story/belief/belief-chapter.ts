// Do we know, or do we believe? A riddle with a known truth: vote, let a model learn, and draw the curtain.
import { html, nothing } from "lit";
import { unsafeHTML } from "lit/directives/unsafe-html.js";
import type { WholeWorkers } from "../../engine/whole-workers";
import { ExperimentStore } from "../../experiment/experiment-store";
import { EQUATIONS } from "../../method/equations";
import type { Settings } from "../../settings/settings";
import { SettingsStore } from "../../settings/settings-store";
import { Store } from "../../ui/store";
import type { WordsStore } from "../../words/words";
import { NO_ADDRESS } from "../../app/story-body";
import type { Chapter } from "../chapter";
import { randomNumbers } from "../../ui/random-numbers";
import { type Answer, type Belief, beliefOf, ratiosOf, type Round, threeRounds } from "./rounds";
import { TO_RHYTHMIC_DMP, WITHOUT_COUPLINGS } from "./worth";

/** The order of the rounds when a visitor comes for the first time. */
const SEED = 1;

export class BeliefChapter extends Store implements Chapter {
  readonly #words: WordsStore;
  readonly #random: () => number;
  readonly #settings = new SettingsStore(NO_ADDRESS);
  readonly experiment: ExperimentStore;
  #rounds: Round[] = [];
  #vote: Answer | null = null;
  #isCurtainOpen = false;
  #score = { you: 0, model: 0, rounds: 0 };
  #stop = () => {};

  constructor(words: WordsStore, whole: WholeWorkers, random = randomNumbers(SEED)) {
    super();
    this.#words = words;
    this.#random = random;
    this.experiment = new ExperimentStore(this.#settings, whole);
  }

  get #now() {
    return this.#words.now.chapters.belief;
  }

  /** The round on screen. */
  get round(): Round {
    if (this.#rounds.length === 0) this.#rounds = threeRounds(this.#random);
    return this.#rounds[0]!;
  }

  get words() {
    return this.#now;
  }

  /** The truth; null behind the curtain. */
  get truth(): Answer | null {
    return this.#isCurtainOpen ? this.round.truth : null;
  }

  /** What the trained model believes; null before. */
  get belief(): Belief | null {
    const found = this.#found();
    return found && beliefOf(found.ratios, found.much);
  }

  #found() {
    const { shown, truth } = this.experiment;
    if (this.#vote === null || shown?.state !== "done" || !shown.findings || !truth) return null;
    return { ratios: ratiosOf(shown.findings, this.round), much: truth.much };
  }

  stage() {
    return html`<pg-belief .chapter=${this}></pg-belief>`;
  }

  guess() {
    return this.#vote === null ? this.#now.guess : null;
  }

  guessed(choice: string): void {
    this.#vote = choice as Answer;
    void this.#train();
    this.changed();
  }

  control() {
    if (this.belief === null) return null;
    const { again, curtain } = this.#now;
    return this.#isCurtainOpen
      ? html`<button class="story-button" data-testid="another-pair" @click=${() => this.#next()}>${again}</button>`
      : html`<button class="story-button" data-testid="curtain" @click=${() => this.#openCurtain()}>${curtain}</button>`;
  }

  reveal() {
    if (this.#vote === null) return null;
    const { believes, drawing, failed, measured, score, training, truth } = this.#now;
    const { problem, shown } = this.experiment;
    const why = problem || (shown?.state === "failed" ? shown.ending : "");
    if (why) return html`<p role="alert">${failed(why)}</p>`;
    const [found, { belief }] = [this.#found(), this];
    if (!found || !belief) return html`<p>${shown ? training(shown.fraction) : drawing}</p>`;
    const { you, model, rounds } = this.#score;
    return html`
      <p data-testid="belief" data-belief=${belief}><b>${believes[belief]}</b> ${this.#isCurtainOpen ? nothing : measured(found.ratios.ab, found.ratios.ba, found.much)}</p>
      ${
        this.#isCurtainOpen
          ? html`<p data-testid="truth" data-truth=${this.round.truth}><b>${truth[this.round.truth]}</b> ${score(you, model, rounds)}</p>`
          : nothing
      }`;
  }

  equation() {
    const { training, heldOut } = WITHOUT_COUPLINGS;
    const worth = this.#now.closing(training, heldOut, TO_RHYTHMIC_DMP);
    return html`${unsafeHTML(EQUATIONS.dynamics)}${unsafeHTML(EQUATIONS.weights)}<p data-testid="worth">${worth}</p>`;
  }

  lab(): Partial<Settings> {
    const { seed, driving } = this.round.experiment;
    // The Lab names the truth, so that a link with it would open the curtain.
    return { view: "synthetic", ...(this.#isCurtainOpen ? { drawn: seed, driving } : {}) };
  }

  arrive(): void {
    this.#show();
    const stopDrawing = this.experiment.follow();
    const stopListening = this.experiment.on(() => this.changed());
    this.#stop = () => {
      stopDrawing();
      stopListening();
    };
  }

  leave(): void {
    this.#stop();
    this.experiment.cancel();
    [this.#vote, this.#isCurtainOpen, this.#rounds] = [null, false, []];
    this.#score = { you: 0, model: 0, rounds: 0 };
  }

  /** Draws the data of the round. */
  #show(): void {
    const { seed, driving } = this.round.experiment;
    this.#settings.change({ drawn: seed, driving });
  }

  async #train(): Promise<void> {
    await this.experiment.train([this.round.experiment]);
  }

  #openCurtain(): void {
    if (this.#isCurtainOpen) return;
    this.#isCurtainOpen = true;
    const { truth } = this.round;
    const { you, model, rounds } = this.#score;
    this.#score = {
      you: you + Number(this.#vote === truth),
      model: model + Number(this.belief === truth),
      rounds: rounds + 1,
    };
    this.changed();
  }

  #next(): void {
    this.#rounds.shift();
    [this.#vote, this.#isCurtainOpen] = [null, false];
    this.#show();
    this.changed();
  }
}
