// Push it: a hand of the walking figure is pulled away, and the walk comes back to its loop.
import { html, nothing } from "lit";
import type { LiveStore, Mark, TracePoint } from "../../live/live-store";
import { nodeNamed } from "../../scene/joints";
import "../../live/wheel-view";
import { eachFrame, clearCanvas } from "../../ui/browser";
import type { WordsStore } from "../../words/words";
import type { StoryBody } from "../../app/story-body";
import type { Chapter } from "../chapter";
import { GuessedChapter } from "../guessed-chapter";
import { EndlessWalk } from "../endless-walk";
import { letDragLimbs } from "../../live/drag-limbs";
import type { StageView } from "../../stage/stage-view";
import "../../stage/stage-view";
import { View } from "../../ui/view";
import type { App } from "../../app/app";
import "./push.css";
import { Plane } from "../../latents/plane";
import { principalAxes, type Projection } from "../../latents/projection";
import { fillDot } from "../../latents/shapes";
import { partColourNow } from "../../ui/palette";

/** Seconds of the learned motion that make the loop, and of the walk behind the dot. */
const LOOP_SECONDS = 3;
const TRAIL_SECONDS = 1.2;
const FLAT = { about: 0, tilt: 0 };

class PushLoops extends View {
  declare chapter: PushChapter;
  /** The name of the picture, and the names of the parts. */
  declare label: string;
  declare names: readonly string[];
  /** The learned paths, and the projection of each. */
  #paths: readonly Float64Array[] = [];
  #projections: Projection[] = [];

  protected override arrived(): void {
    this.whenLeaving(eachFrame(() => this.#draw()));
  }

  #project(): void {
    const { model, learned } = this.chapter.body.model;
    if (!model || !learned || this.#paths === learned.latents) return;
    this.#paths = learned.latents;
    this.#projections = learned.latents.map((path, part) =>
      principalAxes(path, model.info.parts[part]?.latent ?? 1),
    );
  }

  #draw(): void {
    this.#project();
    const canvas = this.querySelector("canvas");
    const surface = canvas && canvas.clientWidth > 0 ? clearCanvas(canvas) : null;
    if (!surface || this.#projections.length === 0) return;
    const { draw, width } = surface;
    const height = surface.height / this.#projections.length;
    draw.lineJoin = draw.lineCap = "round";
    this.#projections.forEach((projection, part) => {
      draw.save();
      // Above each other as on the body: the last part, the arms, on top.
      draw.translate(0, (this.#projections.length - 1 - part) * height);
      this.#drawPart(draw, new Plane({ width, height, projection, turn: FLAT }), part);
      draw.restore();
    });
  }

  #drawPart(draw: CanvasRenderingContext2D, plane: Plane, part: number): void {
    const { live, body } = this.chapter;
    const { frameTime = 1 / 30, parts = [] } = body.model.model?.info ?? {};
    const learned = this.#paths[part];
    const rows = (learned?.length ?? 0) / (parts[part]?.latent ?? 1);
    draw.strokeStyle = draw.fillStyle = partColourNow(part);
    draw.font = "600 15px system-ui, sans-serif";
    draw.fillText(this.names[part] ?? "", 4, 16);
    draw.globalAlpha = 0.35;
    draw.lineWidth = 6;
    if (learned)
      line(draw, plane, learned, Math.max(0, rows - Math.round(LOOP_SECONDS / frameTime)), rows - 1);
    const track = live?.track;
    const path = track?.paths[part];
    if (!track || !path) return;
    const now = Math.floor(Math.min(body.playback.frame, track.last)) - track.first;
    draw.globalAlpha = 1;
    draw.lineWidth = 2.5;
    line(draw, plane, path, Math.max(0, now - Math.round(TRAIL_SECONDS / frameTime)), now);
    const [x, y] = plane.inFrame(...plane.place(path, Math.max(0, now)));
    fillDot(draw, x, y, 6);
  }

  protected override render() {
    return html`<canvas role="img" aria-label=${this.label}></canvas>`;
  }
}
customElements.define("pg-push-loops", PushLoops);

/** Draws rows `from` to `to` of a path. */
function line(
  draw: CanvasRenderingContext2D,
  plane: Plane,
  path: Float64Array,
  from: number,
  to: number,
): void {
  draw.beginPath();
  for (let row = from; row <= to; row++) {
    const [x, y] = plane.inFrame(...plane.place(path, row));
    draw.lineTo(x, y);
  }
  draw.stroke();
}

const HANDS = ["LeftHand", "RightHand"];

class PushHands extends View {
  declare chapter: PushChapter;
  #stage: StageView | null = null;
  #stopDrag: (() => void) | null = null;

  protected override arrived(): void {
    this.#stage = this.parentElement?.querySelector<StageView>("pg-stage") ?? null;
    this.whenLeaving(eachFrame(() => this.#follow()));
    this.whenLeaving(() => this.#stopDrag?.());
  }

  protected override updated(): void {
    const { live, isOpen } = this.chapter;
    if (!isOpen || !live || !this.#stage || this.#stopDrag) return;
    this.#stopDrag = letDragLimbs(this.#stage, live);
  }

  /** Moves the rings onto the hands. */
  #follow(): void {
    if (!this.chapter.isOpen) return;
    const { content } = this.chapter.body.stage;
    const rings = this.querySelectorAll<HTMLElement>(".push-ring");
    HANDS.forEach((name, i) => {
      const node = nodeNamed(content, name);
      const place = node < 0 ? null : this.#stage?.scene?.placeOf(node);
      const ring = rings[i];
      if (ring && place) ring.style.transform = `translate(${place.x}px, ${place.y}px)`;
    });
  }

  protected override render() {
    return this.chapter.isOpen ? HANDS.map(() => html`<i class="push-ring" aria-hidden="true"></i>`) : [];
  }
}
customElements.define("pg-push-hands", PushHands);

/** Home is at most this many times as far from the loop as the walk strays without a push. */
const STRAYS = 2;
/** Seconds in which a walk settles on its loop, and seconds after them that show how far it strays. */
const SETTLES = 1;
const UNDISTURBED = 2;
/** Seconds that a part must stay near its loop to be home, and after which it is lost. */
const STAYS = 1;
const LOST = 8;

type Push = Extract<Mark, { kind: "push" }>;

const farthestOf = ({ distances }: TracePoint) => Math.max(0, ...distances);

/** The distance within which the walk is home, in radii of the loop; null after too few frames. */
export function homeLimit(trace: readonly TracePoint[], frameTime: number): number | null {
  if (trace.length * frameTime < SETTLES + UNDISTURBED) return null;
  return STRAYS * Math.max(...trace.slice(-Math.round(UNDISTURBED / frameTime)).map(farthestOf));
}

interface Homecoming {
  /** The largest distance of a part from its loop since the push began, in radii of the loop. */
  farthest: number;
  /** Seconds from the end of the push until all parts were near their loops to stay; null: not yet. */
  seconds: number | null;
  /** Whether it is not expected to come home any more. */
  isLost: boolean;
}

/** The way home after a push. */
export function homecoming(
  trace: readonly TracePoint[],
  { began, from }: Push,
  limit: number,
  frameTime: number,
): Homecoming {
  const since = trace.filter(({ frame }) => frame >= began);
  const after = since.filter(({ frame }) => frame >= from);
  const lastAway = after.findLast((point) => farthestOf(point) > limit)?.frame ?? from - 1;
  const newest = after.at(-1)?.frame ?? from;
  const isHome = (newest - lastAway) * frameTime >= STAYS;
  return {
    farthest: Math.max(0, ...since.map(farthestOf)),
    seconds: isHome ? (lastAway + 1 - from) * frameTime : null,
    isLost: !isHome && (newest - from) * frameTime >= LOST,
  };
}

/** The pull of the button: a hand, metres upwards for each picture, and pictures. */
const HAND = "RightHand";
const METRES = 0.08;
const PICTURES = 12;
/** Milliseconds between two looks whether the walk can be pulled. */
const AGAIN = 100;

/** Whether the walk has come home, or is not expected to. */
const isDone = (way: Homecoming | null) => way !== null && (way.seconds !== null || way.isLost);

export class PushChapter extends GuessedChapter<"push"> {
  #live: LiveStore | null = null;
  readonly #walk: EndlessWalk;
  #stopPull = () => {};
  /** The distance within which the walk is home, measured before the first push; in radii of the loop. */
  #limit: number | null = null;
  #push: Push | null = null;
  #way: Homecoming | null = null;

  constructor(
    words: WordsStore,
    readonly body: StoryBody,
  ) {
    super(words, "push");
    this.#walk = new EndlessWalk(
      body,
      () => this.changed(),
      (live) => this.#watch(live),
    );
  }

  /** The live walk; null while it does not run. */
  get live(): LiveStore | null {
    return this.#live?.running ? this.#live : null;
  }

  /** Whether the visitor may pull limbs: not before the guess. */
  get isOpen(): boolean {
    return this.choice !== null;
  }

  stage() {
    const { stage, playback } = this.body;
    const { figure, loops, parts, wheel } = this.words;
    const legs = isDone(this.#way) ? this.live : null;
    return html`<div class="push">
      <pg-stage class="cover" .stage=${stage} .playback=${playback} .running=${true} .label=${figure}></pg-stage>
      <pg-push-hands class="cover passive" .chapter=${this}></pg-push-hands>
      <pg-push-loops class="passive" .chapter=${this} .label=${loops} .names=${parts}></pg-push-loops>
      ${
        legs
          ? html`<div class="push-wheel"><b>${wheel.youAre}</b>
              <pg-wheel .live=${legs} .playback=${playback} .index=${0} .name=${parts[0] ?? ""} .words=${wheel}></pg-wheel></div>`
          : nothing
      }
    </div>`;
  }

  override guessed(choice: string): void {
    this.choice = choice;
    this.#walk.walk();
    this.pull();
  }

  control() {
    const { walk, pull, drag } = this.words;
    if (!this.isOpen && this.body.playback.playing) return null;
    if (!this.isOpen)
      return html`<button class="story-button" data-testid="walk" @click=${() => this.#walk.walk()}>${walk}</button>`;
    return html`<button class="story-button" data-testid="pull" @click=${() => this.pull()}>${pull}</button> <span>${drag}</span>`;
  }

  reveal() {
    if (!this.isOpen) return null;
    const { measuring, parts, away, home, lost, back, noFall, wheel } = this.words;
    const [push, way] = [this.#push, this.#way];
    if (!push || !way || !isDone(way)) return html`<p>${measuring}</p>`;
    return html`
      <p data-testid="homecoming" data-seconds=${way.seconds ?? "never"}>
        ${away(parts[push.part] ?? "", way.farthest)}
        <b>${way.seconds === null ? lost : home(way.seconds)}</b>
        ${this.choice === "fall" ? noFall : way.seconds === null ? nothing : back}
      </p>
      <p>${wheel.invites}</p>`;
  }

  equation() {
    const order = this.body.model.model?.info.order;
    return this.equations(["dynamics"], order === undefined ? null : this.words.equation(order));
  }

  override arrive(): void {
    this.stops = [this.body.model.on(() => this.changed())];
    this.#walk.arrive();
  }

  override leave(): void {
    super.leave();
    this.#stopPull();
    this.#walk.leave();
    this.#live = null;
    [this.#limit, this.#push, this.#way] = [null, null, null];
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
    this.stops.push(live.on(() => this.#follow(live)));
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

export async function openChapter(app: App): Promise<Chapter> {
  return new PushChapter(app.words, app.story);
}
