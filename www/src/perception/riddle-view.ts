// The view begins with a riddle: two walkers as points of light, of which one is a model's. It counts in no study.
import { html, nothing } from "lit";
import type { StudyTrial, StudyView } from "../engine/whole-protocol";
import { eachFrame, prefersReducedMotion } from "../ui/browser";
import { randomNumbers } from "../ui/random-numbers";
import { View } from "../ui/view";
import { motionsOf, pairOf } from "./motions";
import { CanvasPair } from "./pair-stage";
import type { PerceptionStore } from "./perception-store";
import { perceptionWords } from "./view-words";

type Side = "left" | "right";

/** Seconds in which the walkers come and go. */
const COMING = 0.25;
/** The riddle asks about movements of this kind of model. */
const ASKED = "vcgpdm";
/** In the sources of the natural walks of this project's study. Nobody learns answers to another study. */
const OWN = "(made by this project)";

/** All pairs of a natural walk and a model's one, in an order of their own for each visit, on random sides. */
function riddlesOf({ info }: StudyView, random: () => number): StudyTrial[] {
  const generated = info.stimuli.filter(
    ({ kind, failed, model, trial }) => kind === "generated" && !failed && model && trial.includes(OWN),
  );
  const asked = generated.filter(({ model }) => model === ASKED);
  return (asked.length > 0 ? asked : generated)
    .map(({ id }) => ({ id, key: random() }))
    .sort((a, b) => a.key - b.key)
    .flatMap(({ id }) => {
      const pair = pairOf(info, id);
      if (!pair) return [];
      const { left, right } = pair;
      return [random() < 0.5 ? pair : { ...pair, left: right, right: left, naturalSide: "right" as const }];
    });
}

export class RiddleView extends View {
  static override properties = { choice: { state: true }, playing: { state: true }, place: { state: true } };
  declare perception: PerceptionStore;
  /** The visitor's guess; null before. */
  choice: Side | null = null;
  playing: boolean = !prefersReducedMotion();
  place = 0;
  #study: StudyView | null = null;
  #riddles: StudyTrial[] = [];
  #stage: CanvasPair | null = null;
  #seconds = 0;
  #found = 0;

  protected override arrived(): void {
    this.whenLeaving(eachFrame((seconds) => this.#draw(seconds)));
    this.whenLeaving(() => this.#drop());
  }

  protected override updated(): void {
    const { study } = this.perception;
    if (study?.info.hash === this.#study?.info.hash) return;
    this.#drop();
    this.#study = study;
    if (study) void this.#open(study);
  }

  #drop(): void {
    this.#stage?.dispose();
    [this.#stage, this.#study] = [null, null];
  }

  async #open(study: StudyView): Promise<void> {
    const seed = Math.floor(performance.timeOrigin);
    this.#riddles = riddlesOf(study, randomNumbers(seed));
    [this.place, this.#found, this.choice] = [0, 0, null];
    this.requestUpdate();
    try {
      const motionOf = motionsOf(study.info, await this.perception.movements());
      const box = this.querySelector(".riddle-scene");
      if (this.#study !== study || !this.#riddle || !box) return;
      this.#stage = new CanvasPair({ ...study.info, look: "points" }, motionOf);
      box.replaceChildren(this.#stage.element);
      this.#show();
    } catch {
      [this.#riddles, this.choice] = [[], null];
      this.requestUpdate();
      // Without WebGL, or without the study, there is no riddle; the view says what is wrong when one begins.
    }
  }

  get #riddle(): StudyTrial | null {
    return this.#riddles[this.place] ?? null;
  }

  #show(): void {
    this.#seconds = 0;
    if (this.#riddle) this.#stage?.take(this.#riddle);
    this.requestUpdate();
  }

  #draw(seconds: number): void {
    const length = this.#study?.info.seconds ?? 0;
    // The experiment draws on a stage of its own.
    if (!this.#stage || !this.playing || length === 0 || this.perception.active) return;
    this.#seconds = (this.#seconds + seconds) % length;
    this.#stage.draw(this.#seconds, () => {});
    const edge = Math.min(this.#seconds, length - this.#seconds) / COMING;
    this.#stage.element.style.opacity = String(Math.min(1, 0.1 + edge));
  }

  #guess(side: Side): void {
    if (this.choice || !this.#riddle || !this.#stage || !this.playing) return;
    this.choice = side;
    if (side !== this.#riddle.naturalSide) this.#found += 1;
  }

  #tap({ offsetX, currentTarget }: MouseEvent): void {
    this.#guess(offsetX < (currentTarget as HTMLElement).clientWidth / 2 ? "left" : "right");
  }

  #next(): void {
    this.choice = null;
    this.place = (this.place + 1) % this.#riddles.length;
    if (this.place === 0) this.#found = 0;
    this.#show();
  }

  #controls(riddle: StudyTrial) {
    const { riddle: words, run } = perceptionWords();
    if (!this.playing)
      return html`<button class="small" data-testid="riddle-play" @click=${() => {
        this.playing = true;
      }}>${words.play}</button>`;
    if (!this.choice)
      return html`<span>${words.question}</span>
        ${(["left", "right"] as const).map(
          (side) =>
            html`<button class="small" data-testid="riddle-${side}" @click=${() => this.#guess(side)}>${run[side]}</button>`,
        )}`;
    const isRight = this.choice !== riddle.naturalSide;
    return html`<span data-testid="riddle-answer">${isRight ? words.right : words.wrong} ${words.score(this.#found, this.place + 1)}</span>
      <button class="small" data-testid="riddle-next" @click=${() => this.#next()}>${words.next}</button>`;
  }

  protected override render() {
    const { look, riddle: words } = perceptionWords();
    const riddle = this.#riddle;
    if (this.perception.study && this.#study && !riddle) return nothing;
    const names =
      riddle?.naturalSide === "left" ? [look.natural, look.generated] : [look.generated, look.natural];
    return html`
      <div class="card riddle" aria-label=${words.title} role="group">
        <h2>${words.title}</h2>
        <div class="riddle-scene pair-scene" data-testid="riddle" @click=${this.#tap}></div>
        <p class="look-sides hint">${names.map((name) => html`<span>${this.choice ? name : nothing}</span>`)}</p>
        <div class="riddle-controls row wrap" aria-live="polite">${this.#stage && riddle ? this.#controls(riddle) : nothing}</div>
        <p class="hint">${words.about}</p>
      </div>`;
  }
}
customElements.define("pg-perception-riddle", RiddleView);
