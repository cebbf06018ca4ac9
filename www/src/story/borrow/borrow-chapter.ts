// Borrow arms: the legs of one recorded movement with the arms of another.
import { html, nothing } from "lit";
import { primitivesOf } from "../../primitives/combinations";
import type { LibraryStore } from "../../primitives/library-store";
import type { Settings } from "../../settings/settings";
import type { SettingsStore } from "../../settings/settings-store";
import type { WordsStore } from "../../words/words";
import type { Chapter } from "../chapter";
import { GuessedChapter } from "../guessed-chapter";
import { WalkView } from "../../primitives/walk-view";
import type { LibraryInfo } from "../../engine/library-protocol";
import type { Motion } from "../../engine/protocol";
import { nodeOfJoint } from "../../scene/joints";
import type { App } from "../../app/app";
import "../../live/wheel-view";
import "./borrow.css";

interface HandsAndFeet {
  /** The mean height of the hands above the hips, in metres. */
  height: number;
  /** The mean speed of the hands against the hips, in metres a second. */
  speed: number;
  /** How often a foot overtakes the other one, in steps a second; 0 for a body that stays in its place. */
  steps: number;
}

/** Metres a second of a root that is slower than any walk. */
const SLOWEST_WALK = 0.3;

/** The node of the joint whose name ends like this; null: the body has no such joint. */
function nodeOf({ joints, figure }: Pick<LibraryInfo, "joints" | "figure">, end: RegExp): number | null {
  const joint = joints.findIndex(({ name }) => end.test(name));
  const node = nodeOfJoint(figure, joint);
  return joint < 0 || node < 0 ? null : node;
}

/** Null for a body without two hands and two feet whose names say so. */
export function measureHandsAndFeet(
  info: Pick<LibraryInfo, "joints" | "figure">,
  { positions, frames, nodes, frameTime }: Motion,
): HandsAndFeet | null {
  const [left, right] = [nodeOf(info, /left_?hand$/i), nodeOf(info, /right_?hand$/i)];
  const [leftFoot, rightFoot] = [nodeOf(info, /left_?foot$/i), nodeOf(info, /right_?foot$/i)];
  if (left === null || right === null || leftFoot === null || rightFoot === null || frames < 2) return null;
  const at = (frame: number, node: number, axis: number) => positions[3 * (frame * nodes + node) + axis] ?? 0;
  /** The place of a node against the root of the body. */
  const place = (frame: number, node: number) =>
    [0, 1, 2].map((axis) => at(frame, node, axis) - at(frame, 0, axis));
  const hands = [left, right];
  let [height, path, steps, before] = [0, 0, 0, 0];
  for (let frame = 0; frame < frames; frame++) {
    for (const hand of hands) height += place(frame, hand)[1]! / (hands.length * frames);
    if (frame === 0) continue;
    for (const hand of hands) {
      const [now, then] = [place(frame, hand), place(frame - 1, hand)];
      path += Math.hypot(...now.map((x, axis) => x - then[axis]!)) / hands.length;
    }
    // The distance between the feet along the way of the root.
    const [x, z] = [at(frame, 0, 0) - at(frame - 1, 0, 0), at(frame, 0, 2) - at(frame - 1, 0, 2)];
    const apart = (axis: number) => at(frame, leftFoot, axis) - at(frame, rightFoot, axis);
    const ahead = x * apart(0) + z * apart(2);
    if (ahead * before < 0) steps += 1;
    if (ahead !== 0) before = ahead;
  }
  const seconds = (frames - 1) * frameTime;
  const way = [0, 2].map((axis) => at(frames - 1, 0, axis) - at(0, 0, axis));
  if (Math.hypot(...way) < SLOWEST_WALK * seconds) steps = 0;
  return { height, speed: path / seconds, steps: steps / seconds };
}

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

export class BorrowChapter extends GuessedChapter<"borrow"> {
  /** The combination that the visitor left in the Lab; null: the chapter is not on screen. */
  #before: readonly number[] | null = null;
  #isHere = false;

  constructor(
    words: WordsStore,
    private readonly settings: SettingsStore,
    readonly library: LibraryStore,
  ) {
    super(words, "borrow");
  }

  /** Whether the visitor may drive the legs: not before the guess. */
  get isOpen(): boolean {
    return this.hasGuessed;
  }

  get #recorded() {
    return this.library.current?.info.movements.filter(({ learned }) => learned) ?? [];
  }

  stage() {
    return html`<pg-borrow .library=${this.library} .chapter=${this}></pg-borrow>`;
  }

  override guessed(choice: string): void {
    this.choice = choice;
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
    if (!this.hasGuessed || !info || info.parts.length !== 2) return null;
    const { parts } = this.words;
    const row = (part: number, label: string) => html`
      <span class="borrow-row row loose"><span>${label}</span>
      <span class="story-choice" role="group" aria-label=${label}>
        ${primitivesOf(info, part).map(
          (primitive) => html`
          <button aria-pressed=${this.library.uses[part] === primitive ? "true" : "false"} data-testid="borrow-${part}-${primitive}"
            @click=${() => this.library.choose(part, primitive)}>${this.#name(info.primitives[primitive]?.name ?? "")}</button>`,
        )}</span></span>`;
    return html`<div class="borrow-choices wrap">${row(LEGS, parts.legs)}${row(ARMS, parts.arms)}</div>`;
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
    if (!this.hasGuessed) return null;
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
    return this.equations(["dynamics", "weights"], null);
  }

  override lab(): Partial<Settings> {
    return { view: "primitives" };
  }

  override arrive(): void {
    this.#isHere = true;
    this.stops = [this.library.on(() => this.changed())];
    void this.#begin();
  }

  async #begin(): Promise<void> {
    await this.library.openFirst();
    if (!this.#isHere || !this.library.current) return;
    this.#before = this.library.uses;
    const [first] = this.#recorded;
    if (this.hasGuessed) this.#borrow();
    else if (first) this.library.take(first.uses);
  }

  override leave(): void {
    this.#isHere = false;
    super.leave();
    const { chapter, view } = this.settings.values;
    // The link to the Lab shows this combination there.
    const isInLab = chapter === 0 && view === "primitives";
    if (this.#before && !isInLab) this.library.take(this.#before);
    this.#before = null;
  }
}

class BorrowFigure extends WalkView {
  declare chapter: BorrowChapter;

  protected override stores() {
    return [this.library, this.library.walk];
  }

  protected override render() {
    const { walk, playback } = this.library;
    const { isOpen, words } = this.chapter;
    return html`${this.figure("borrow-figure", words.figure)}
      ${
        isOpen && walk.isCyclic
          ? html`<pg-wheel .live=${walk} .playback=${playback} .index=${LEGS} .name=${words.parts.legs} .words=${words}></pg-wheel>`
          : nothing
      }`;
  }
}
customElements.define("pg-borrow", BorrowFigure);

export async function openChapter(app: App): Promise<Chapter> {
  const { library } = await app.view("primitives").get();
  return new BorrowChapter(app.words, app.settings, library);
}
