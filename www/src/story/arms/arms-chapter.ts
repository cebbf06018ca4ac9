// Who tells the arms when to swing? The coupling from the legs to the arms is cut while the figure walks.
import { html, nothing, svg } from "lit";
import { couplingsOf, START_PRESETS } from "../../couplings/presets";
import { isSwinging, stepOf } from "../../couplings/measures-text";
import { weights } from "../../couplings/weights";
import { initialSettings, type Settings } from "../../settings/settings";
import type { WordsStore } from "../../words/words";
import type { StoryBody } from "../../app/story-body";
import type { Chapter } from "../chapter";
import { GuessedChapter } from "../guessed-chapter";
import { EndlessWalk } from "../endless-walk";
import { nodeNamed } from "../../scene/joints";
import type { StageView } from "../../stage/stage-view";
import "../../stage/stage-view";
import { eachFrame, prefersReducedMotion } from "../../ui/browser";
import { View } from "../../ui/view";
import type { App } from "../../app/app";
import "../../couplings/phase-clock";
import "./arms.css";

/** Each thread goes from a knee to the hand of the other side, which swings with it. */
const TIED = [
  ["LeftLeg", "RightHand"],
  ["RightLeg", "LeftHand"],
] as const;

/** Seconds in which the thread snaps, and the share of it that stays at each end. */
const SNAP = 0.3;
const LOOSE = 0.1;
/** Pixels by which a thread hangs down, and by which it bends away from the body, where it can be seen. */
const SLACK = 14;
const BEND = 60;

class ThreadView extends View {
  declare chapter: ArmsChapter;
  /** 0: tied; 1: cut. */
  #cut = 0;

  protected override arrived(): void {
    const calm = prefersReducedMotion();
    this.whenLeaving(
      eachFrame((seconds) => {
        const towards = this.chapter.isCut ? 1 : 0;
        const step = calm ? 1 : seconds / SNAP;
        this.#cut += Math.max(-step, Math.min(step, towards - this.#cut));
        this.#draw();
      }),
    );
  }

  #draw(): void {
    const scene = this.parentElement?.querySelector<StageView>("pg-stage")?.scene;
    const { content } = this.chapter.body.stage;
    const paths = this.querySelectorAll<SVGPathElement>("path");
    const half = 0.5 - this.#cut * (0.5 - LOOSE);
    const middle = scene?.placeOf(0)?.x ?? 0;
    const label = this.querySelector("text");
    TIED.forEach((ends, i) => {
      const path = paths[i];
      const [from, to] = ends.map((name) => {
        const node = nodeNamed(content, name);
        return node < 0 ? null : (scene?.placeOf(node) ?? null);
      });
      if (!path || !from || !to) return;
      // From one side to the other it goes smoothly.
      const side = Math.max(-1, Math.min(1, ((from.x + to.x) / 2 - middle) / BEND));
      const [x, y] = [(from.x + to.x) / 2 + side * BEND, (from.y + to.y) / 2 + SLACK];
      path.setAttribute("d", `M${from.x} ${from.y}Q${x} ${y} ${to.x} ${to.y}`);
      path.setAttribute("stroke-dasharray", this.#cut === 0 ? "none" : `${half} ${1 - 2 * half} ${half} 1`);
      if (i > 0 || !label) return;
      label.setAttribute("x", String(middle - 1.4 * BEND));
      label.setAttribute("y", String(y));
    });
  }

  protected override render() {
    return html`<svg aria-hidden="true" data-cut=${this.chapter.isCut ? "yes" : "no"}>${TIED.map(() => svg`<path pathLength="1"></path>`)}${this.chapter.isCut ? nothing : svg`<text>${this.chapter.words.thread.label}</text>`}</svg>`;
  }
}
customElements.define("pg-thread", ThreadView);

/** The parts of the model, in its order. */
const [LEGS, ARMS] = [0, 1] as const;

/** The state of the thread, and the preset of the page that has this state. */
const THREADS = { tied: "as-learned", relearned: "arms-go", kept: "arms-hang" } as const;
type Thread = keyof typeof THREADS;

const presetOf = (thread: Thread) => START_PRESETS.find(({ id }) => id === THREADS[thread])!;

export class ArmsChapter extends GuessedChapter<"arms"> {
  #thread: Thread = "tied";
  readonly #walk: EndlessWalk;

  constructor(
    words: WordsStore,
    readonly body: StoryBody,
  ) {
    super(words, "arms");
    this.#walk = new EndlessWalk(body, () => this.changed());
  }

  get isCut(): boolean {
    return this.#thread !== "tied";
  }

  stage() {
    const { stage, playback, phases } = this.body;
    const { clock, parts, figure } = this.words;
    const words = { clock, seconds: () => "", still: "", step: NO_STEPS };
    return html`<div class="arms">
      <pg-stage class="cover" .stage=${stage} .playback=${playback} .running=${true} .label=${figure}></pg-stage>
      <pg-thread class="cover passive" .chapter=${this}></pg-thread>
      <pg-phase-clock class="passive" .phases=${phases} .playback=${playback} .names=${parts} .words=${words}></pg-phase-clock>
    </div>`;
  }

  override guessed(choice: string): void {
    this.choice = choice;
    // Who says "stop" is right to another question, and sees that one first.
    this.#pull(choice === "stop" ? "kept" : "relearned");
  }

  control() {
    if (!this.hasGuessed) {
      if (this.body.playback.playing) return null;
      return html`<button class="story-button" data-testid="walk" @click=${() => this.#walk.walk()}>${this.words.walk}</button>`;
    }
    const { label, ...names } = this.words.thread;
    return html`<div class="story-choice" role="group" aria-label=${label}>
      ${Object.entries(names).map(
        ([thread, name]) => html`
        <button aria-pressed=${this.#thread === thread ? "true" : "false"} data-testid="thread-${thread}"
          @click=${() => this.#pull(thread as Thread)}>${name}</button>`,
      )}</div>`;
  }

  /** What hands and feet of this walk do, as the library measures it. */
  #measured() {
    const { reports, isCurrent } = this.body.measures;
    const [legs, arms] = [reports?.now.measures.parts[LEGS], reports?.now.measures.parts[ARMS]];
    const learned = reports?.learned.measures.parts[ARMS];
    return isCurrent && legs && arms && learned ? { legs, arms, learned } : null;
  }

  reveal() {
    if (!this.hasGuessed) return null;
    const { measuring, periods, swing, tied, outcome, relearned, kept } = this.words;
    const measured = this.#measured();
    if (!measured) return html`<p>${measuring}</p>`;
    const { legs, arms, learned } = measured;
    const swings = isSwinging(arms, learned);
    const inStep = arms.locking !== null && stepOf(arms.locking) === "in step";
    const found = !swings ? "stop" : inStep ? "step" : "pace";
    return html`
      <p data-testid="measured" data-thread=${this.#thread} data-outcome=${found}>
        <b>${
          swings && legs.period !== null && arms.period !== null
            ? periods(legs.period, arms.period)
            : swing(arms.swing ?? 0, learned.swing ?? 0)
        }</b>
        ${this.#thread === "tied" ? (inStep ? tied : nothing) : outcome[found]}
        ${this.#thread === "relearned" ? relearned : nothing}
        ${this.#thread === "kept" && found === "stop" ? kept : nothing}
      </p>`;
  }

  equation() {
    const shares = this.#shares();
    return this.equations(["dynamics", "weights"], shares && this.words.equation(shares.tied, shares.cut));
  }

  /** The share of the legs in the steps of the arms. */
  #shares(): { tied: number; cut: number } | null {
    const info = this.body.model.model?.info;
    if (!info) return null;
    const share = (thread: Thread) => {
      const changed = couplingsOf(presetOf(thread), info) ?? {};
      const into = info.alpha.map((row, source) => changed[`${source}.${ARMS}`] ?? row[ARMS] ?? 1);
      return weights(into)[LEGS] ?? 0;
    };
    return { tied: share("tied"), cut: share("relearned") };
  }

  override lab(): Partial<Settings> {
    const { model } = this.body;
    const alpha = (model.model && couplingsOf(presetOf(this.#thread), model.model.info)) ?? {};
    const { reading } = presetOf(this.#thread);
    return this.isCut ? { alpha, reading, model: model.id } : { reading: initialSettings().reading };
  }

  link() {
    return { cut: this.#thread === "tied" ? ("" as const) : this.#thread };
  }

  restore({ cut }: Pick<Settings, "cut">): void {
    if (cut === "") return;
    this.choice = cut;
    this.#pull(cut);
  }

  override arrive(): void {
    const { measures, model, phases, playback } = this.body;
    this.stops = [measures, model, phases].map((store) => store.on(() => this.changed()));
    this.#walk.arrive();
    if (playback.playing) this.changed();
  }

  override leave(): void {
    super.leave();
    this.#walk.leave();
    this.#thread = "tied";
  }

  /** Ties or cuts the thread. */
  #pull(thread: Thread): void {
    this.#thread = thread;
    this.#walk.walk();
    void this.#applyThread();
    this.changed();
  }

  /** Gives the model the couplings of the thread; a guess may come before the model. */
  async #applyThread(): Promise<void> {
    try {
      await this.body.start();
    } catch {
      return; // The frame says why the model cannot run here.
    }
    if (this.#walk.isHere) this.body.model.takePreset(presetOf(this.#thread));
  }
}

const NO_STEPS = { "in step": "", "partly in step": "", "out of step": "" };

export async function openChapter(app: App): Promise<Chapter> {
  return new ArmsChapter(app.words, app.story);
}
