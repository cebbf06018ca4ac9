// Do we know, or do we believe? A riddle with a known truth: vote, let a model learn, and draw the curtain.
import { html, nothing, svg } from "lit";
import type { WholeWorkers } from "../../engine/whole-workers";
import { ExperimentStore } from "../../experiment/experiment-store";
import type { Settings } from "../../settings/settings";
import { SettingsStore } from "../../settings/settings-store";
import type { WordsStore } from "../../words/words";
import { NO_ADDRESS } from "../../app/story-body";
import type { Chapter } from "../chapter";
import { GuessedChapter } from "../guessed-chapter";
import { randomNumbers } from "../../ui/random-numbers";
import { type Answer, type Belief, beliefOf, ratiosOf, type Round, threeRounds } from "./rounds";
import type { Ratio } from "../../words/en/belief";
import type { App } from "../../app/app";
import "./belief.css";
import { frameOf, linePath } from "../../experiment/paths";
import { eachFrame, prefersReducedMotion } from "../../ui/browser";
import { partColour } from "../../ui/palette";
import { partStyle } from "../../ui/styled";
import { View } from "../../ui/view";

const SIDE = 200;
/** Frames a second. */
const PACE = 20;
/** The two points on the screen. */
const POINTS = ["A", "B"] as const;
/** The places of A and B in a row of arrows, and the radius of their circles. */
const [LEFT, RIGHT, RADIUS] = [26, 134, 18];

const arrow = (from: number, to: number, y: number) => {
  const tip = to - Math.sign(to - from) * (RADIUS + 3);
  const start = from + Math.sign(to - from) * (RADIUS + 3);
  const back = tip - Math.sign(to - from) * 9;
  return svg`<path class="belief-arrow" d="M${start} ${y}H${tip}M${back} ${y - 6}L${tip} ${y}L${back} ${y + 6}"></path>`;
};

class BeliefView extends View {
  declare chapter: BeliefChapter;
  #seconds = 0;

  protected override arrived(): void {
    if (prefersReducedMotion()) return;
    this.whenLeaving(
      eachFrame((seconds) => {
        this.#seconds += seconds;
        this.#move();
      }),
    );
  }

  protected override updated(): void {
    this.#move();
  }

  /** The true latents of A or B. */
  #latents(point: number): readonly number[] {
    const { experiment, round } = this.chapter;
    return experiment.truth?.latents[round.isMirrored ? 1 - point : point] ?? [];
  }

  #move(): void {
    this.querySelectorAll<SVGCircleElement>(".belief-point").forEach((circle, point) => {
      const latents = this.#latents(point);
      const frames = latents.length / 2;
      if (frames === 0) return;
      const { middle, scale } = frameOf(latents, SIDE);
      const frame = Math.floor(this.#seconds * PACE) % frames;
      const [x = 0, y = 0] = latents.slice(2 * frame, 2 * frame + 2);
      circle.setAttribute("cx", String(SIDE / 2 + scale * (x - middle[0])));
      circle.setAttribute("cy", String(SIDE / 2 - scale * (y - middle[1])));
    });
  }

  /** The arrows between A and B; null: not known yet. */
  #row(title: string, answer: Belief | null, isTruth: boolean) {
    const [y, isOpen] = [26, answer !== null];
    return html`
      <div class="belief-row" data-testid=${isTruth ? "truth-row" : "belief-row"} data-answer=${answer ?? ""}>
        <svg viewBox="0 0 160 52" aria-hidden="true">
          ${answer === "ab" || answer === "both" ? arrow(LEFT, RIGHT, answer === "both" ? y - 8 : y) : nothing}
          ${answer === "ba" || answer === "both" ? arrow(RIGHT, LEFT, answer === "both" ? y + 8 : y) : nothing}
          ${[LEFT, RIGHT].map((x, point) => svg`<g style=${partStyle(partColour(point))}><circle class="belief-node" cx=${x} cy=${y} r=${RADIUS} /><text x=${x} y=${y + 5}>${POINTS[point]}</text></g>`)}
          ${isOpen || isTruth ? nothing : svg`<text class="belief-unknown" x="80" y=${y + 6}>?</text>`}
        </svg>
        ${isTruth ? html`<span class="belief-curtain" ?data-open=${isOpen} aria-hidden="true"></span>` : nothing}
        <p class="hint">${title}</p>
      </div>`;
  }

  protected override render() {
    const { belief, truth, words } = this.chapter;
    const path = (point: number) => {
      const latents = this.#latents(point);
      return svg`<path class="belief-path" d=${linePath(latents, frameOf(latents, SIDE))} />`;
    };
    return html`
      <div class="belief" role="group" aria-label=${words.figure}>
        ${POINTS.map(
          (name, point) => html`
          <figure style=${partStyle(partColour(point))}>
            <svg class="cover" viewBox="0 0 ${SIDE} ${SIDE}" aria-hidden="true">${path(point)}<circle class="belief-point" r="7" cx="-20" cy="-20" /></svg>
            <figcaption>${name}</figcaption>
          </figure>`,
        )}
        <div class="belief-rows">
          ${this.#row(words.modelRow, belief, false)}
          ${this.#row(words.truthRow, truth, true)}
        </div>
      </div>`;
  }
}
customElements.define("pg-belief", BeliefView);

/** Errors with couplings : without them, in the mean of ten persons. */
export const TO_UNCOUPLED: Ratio = [0.73, 0.51, 1.06];

/** vCGPDM : rhythmic DMP, in the mean of ten persons. */
export const TO_RHYTHMIC_DMP: Ratio = [1.18, 0.98, 1.41];

/** The order of the rounds when a visitor comes for the first time. */
const SEED = 1;

export class BeliefChapter extends GuessedChapter<"belief"> {
  readonly #settings = new SettingsStore(NO_ADDRESS);
  readonly experiment: ExperimentStore;
  #rounds: Round[] = [];
  #isCurtainOpen = false;
  #score = { you: 0, model: 0, rounds: 0 };

  constructor(
    words: WordsStore,
    whole: WholeWorkers,
    private readonly random: () => number = randomNumbers(SEED),
  ) {
    super(words, "belief");
    this.experiment = new ExperimentStore(this.#settings, whole);
  }

  /** The round on screen. */
  get round(): Round {
    if (this.#rounds.length === 0) this.#rounds = threeRounds(this.random);
    return this.#rounds[0]!;
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
    if (this.choice === null || shown?.state !== "done" || !shown.findings || !truth) return null;
    return { ratios: ratiosOf(shown.findings, this.round), much: truth.much };
  }

  stage() {
    return html`<pg-belief .chapter=${this}></pg-belief>`;
  }

  override guessed(choice: string): void {
    super.guessed(choice);
    void this.experiment.train([this.round.experiment]);
  }

  control() {
    if (this.belief === null) return null;
    const { again, curtain } = this.words;
    return this.#isCurtainOpen
      ? html`<button class="story-button" data-testid="another-pair" @click=${() => this.#next()}>${again}</button>`
      : html`<button class="story-button" data-testid="curtain" @click=${() => this.#openCurtain()}>${curtain}</button>`;
  }

  reveal() {
    if (this.choice === null) return null;
    const { believes, drawing, failed, measured, score, training, truth } = this.words;
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
    const worth = this.words.closing(TO_UNCOUPLED, TO_RHYTHMIC_DMP);
    return html`${this.equations(["dynamics", "weights"], null)}<p data-testid="worth">${worth}</p>`;
  }

  override lab(): Partial<Settings> {
    const { seed, driving } = this.round.experiment;
    // The Lab names the truth, so that a link with it would open the curtain.
    return { view: "synthetic", ...(this.#isCurtainOpen ? { drawn: seed, driving } : {}) };
  }

  override arrive(): void {
    this.#show();
    this.stops = [this.experiment.follow(), this.experiment.on(() => this.changed())];
  }

  override leave(): void {
    super.leave();
    this.experiment.cancel();
    [this.#isCurtainOpen, this.#rounds] = [false, []];
    this.#score = { you: 0, model: 0, rounds: 0 };
  }

  /** Draws the data of the round. */
  #show(): void {
    const { seed, driving } = this.round.experiment;
    this.#settings.change({ drawn: seed, driving });
  }

  #openCurtain(): void {
    if (this.#isCurtainOpen) return;
    this.#isCurtainOpen = true;
    const { truth } = this.round;
    const { you, model, rounds } = this.#score;
    this.#score = {
      you: you + Number(this.choice === truth),
      model: model + Number(this.belief === truth),
      rounds: rounds + 1,
    };
    this.changed();
  }

  #next(): void {
    this.#rounds.shift();
    [this.choice, this.#isCurtainOpen] = [null, false];
    this.#show();
    this.changed();
  }
}

export async function openChapter(app: App): Promise<Chapter> {
  return new BeliefChapter(app.words, app.workers);
}
