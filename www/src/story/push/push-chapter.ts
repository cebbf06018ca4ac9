// Push it: a hand of the walking figure is pulled away, and the walk comes back to its loop.
import { html, nothing } from "lit";
import type { LiveStore, Mark } from "../../live/live-store";
import { nodeNamed } from "../../scene/joint-node";
import "../../live/wheel-view";
import type { Settings } from "../../settings/settings";
import { eachFrame } from "../../ui/each-frame";
import { Store } from "../../ui/store";
import type { WordsStore } from "../../words/words";
import type { StoryBody } from "../../app/story-body";
import type { Chapter } from "../chapter";
import { EndlessWalk } from "../endless-walk";
import { equation } from "../equation";
import { type Homecoming, homecoming, homeLimit } from "./homecoming";

/** The pull of the button: a hand, metres upwards for each picture, and pictures. */
const HAND = "RightHand";
const METRES = 0.08;
const PICTURES = 12;
/** Milliseconds between two looks whether the walk can be pulled. */
const AGAIN = 100;

type Push = Extract<Mark, { kind: "push" }>;

/** Whether the walk has come home, or is not expected to. */
const isDone = (way: Homecoming | null) => way !== null && (way.seconds !== null || way.isLost);

export class PushChapter extends Store implements Chapter {
  readonly #words: WordsStore;
  readonly body: StoryBody;
  #live: LiveStore | null = null;
  #guess: string | null = null;
  readonly #walk: EndlessWalk;
  #stops: (() => void)[] = [];
  #stopPull = () => {};
  /** The distance within which the walk is home, measured before the first push; in radii of the loop. */
  #limit: number | null = null;
  #push: Push | null = null;
  #way: Homecoming | null = null;

  constructor(words: WordsStore, body: StoryBody) {
    super();
    this.#words = words;
    this.body = body;
    this.#walk = new EndlessWalk(
      body,
      () => this.changed(),
      (live) => this.#watch(live),
    );
  }

  get #now() {
    return this.#words.now.chapters.push;
  }

  /** The live walk; null while it does not run. */
  get live(): LiveStore | null {
    return this.#live?.running ? this.#live : null;
  }

  /** Whether the visitor may pull limbs: not before the guess. */
  get isOpen(): boolean {
    return this.#guess !== null;
  }

  stage() {
    const { stage, playback } = this.body;
    const { figure, loops, parts, wheel } = this.#now;
    const legs = isDone(this.#way) ? this.live : null;
    return html`<div class="push">
      <pg-stage .stage=${stage} .playback=${playback} .running=${true} .label=${figure}></pg-stage>
      <pg-push-hands .chapter=${this}></pg-push-hands>
      <pg-push-loops .chapter=${this} .label=${loops} .names=${parts}></pg-push-loops>
      ${
        legs
          ? html`<div class="push-wheel"><b>${wheel.youAre}</b>
              <pg-wheel .live=${legs} .playback=${playback} .index=${0} .name=${parts[0] ?? ""} .words=${wheel}></pg-wheel></div>`
          : nothing
      }
    </div>`;
  }

  guess() {
    return this.#guess === null ? this.#now.guess : null;
  }

  guessed(choice: string): void {
    this.#guess = choice;
    this.#walk.walk();
    this.pull();
  }

  control() {
    const { walk, pull, drag } = this.#now;
    if (!this.isOpen && this.body.playback.playing) return null;
    if (!this.isOpen)
      return html`<button class="story-button" data-testid="walk" @click=${() => this.#walk.walk()}>${walk}</button>`;
    return html`<button class="story-button" data-testid="pull" @click=${() => this.pull()}>${pull}</button> <span>${drag}</span>`;
  }

  reveal() {
    if (!this.isOpen) return null;
    const { measuring, parts, away, home, lost, back, noFall, wheel } = this.#now;
    const [push, way] = [this.#push, this.#way];
    if (!push || !way || !isDone(way)) return html`<p>${measuring}</p>`;
    return html`
      <p data-testid="homecoming" data-seconds=${way.seconds ?? "never"}>
        ${away(parts[push.part] ?? "", way.farthest)}
        <b>${way.seconds === null ? lost : home(way.seconds)}</b>
        ${this.#guess === "fall" ? noFall : way.seconds === null ? nothing : back}
      </p>
      <p>${wheel.invites}</p>`;
  }

  equation() {
    const order = this.body.model.model?.info.order;
    return equation(["dynamics"], order === undefined ? null : this.#now.equation(order));
  }

  lab(): Partial<Settings> {
    return {};
  }

  arrive(): void {
    this.#stops = [this.body.model.on(() => this.changed())];
    this.#walk.arrive();
  }

  leave(): void {
    for (const stop of this.#stops) stop();
    this.#stopPull();
    this.#walk.leave();
    this.#live = null;
    [this.#guess, this.#limit, this.#push, this.#way] = [null, null, null, null];
  }

  /** Pulls a hand upwards, as soon as the walk without a push has been measured. */
  pull(): void {
    this.#stopPull();
    if (!this.#walk.isHere) return;
    const { stage } = this.body;
    const live = this.live;
    if (!live || this.#limit === null) {
      const timer = setTimeout(() => this.pull(), AGAIN);
      this.#stopPull = () => clearTimeout(timer);
      return;
    }
    const node = nodeNamed(stage.content, HAND);
    let left = PICTURES;
    this.#stopPull = eachFrame(() => {
      if (node >= 0) live.pull(node, [0, METRES, 0]);
      left -= 1;
      if (left === 0) this.#stopPull();
    });
  }

  /** Follows the live motion from its start on. */
  #watch(live: LiveStore): void {
    if (this.#live === live) return;
    this.#live = live;
    this.#stops.push(live.on(() => this.#follow(live)));
  }

  /** Measures the newest frames. */
  #follow(live: LiveStore): void {
    const frameTime = live.track?.motion.frameTime;
    if (frameTime === undefined) return;
    const push = live.marks.findLast((mark) => mark.kind === "push") ?? null;
    if (!push) this.#limit = homeLimit(live.trace, frameTime) ?? this.#limit;
    if (!push || this.#limit === null) return;
    // Who turns the wheel after the push takes the arms from their loop once more.
    if (live.marks.some((mark) => mark.kind === "drive" && mark.from > push.from)) return;
    const isOther = push !== this.#push;
    this.#push = push;
    const before = isOther ? null : this.#way;
    const way = homecoming(live.trace, push, this.#limit, frameTime);
    // The frames of the push are forgotten after some seconds, and the visitor may pull on.
    const isForgotten = isDone(before) && (live.trace[0]?.frame ?? 0) > push.began;
    if (!isForgotten) this.#way = way;
    if (isOther || isDone(way) !== isDone(before)) this.changed();
  }
}
