// The wheel: the visitor moves one part round its learned cycle, and the others follow through the couplings.
import { html } from "lit";
import type { Playback } from "../stage/playback";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import type { LiveStore } from "./live-store";
import { phaseDifference } from "./strip";
import "./wheel.css";

/** Turns of one press of an arrow key. */
const STEP = 1 / 24;
const KEYS: Record<string, number> = {
  ArrowRight: STEP,
  ArrowUp: STEP,
  ArrowLeft: -STEP,
  ArrowDown: -STEP,
};

/** The texts of the wheel. */
export interface WheelWords {
  /** The name of the wheel of a part, for the keyboard. */
  wheel(part: string): string;
  wheelMeaning: string;
}

/** `<pg-wheel .live=${live} .playback=${playback} .index=${place} .name=${part} .words=${...}>` */
export class WheelView extends View {
  static override properties = { index: {}, name: {}, words: {} };
  declare live: LiveStore;
  declare playback: Playback;
  /** The place of the part in the list of the parts. */
  declare index: number;
  /** The name of the part. */
  declare name: string;
  declare words: WheelWords;
  /** The turns of the pointer round the middle; null while the wheel is not held. */
  #held: number | null = null;

  protected override stores() {
    return [this.live];
  }

  protected override arrived(): void {
    this.whenLeaving(this.playback.on(() => this.#follow()));
  }

  override updated(): void {
    this.#follow();
  }

  /** The phase of the part in the picture, in turns; null without a learned cycle. */
  get #phase(): number | null {
    const { trace } = this.live;
    const first = trace[0]?.frame ?? 0;
    const now = trace[Math.min(trace.length - 1, Math.max(0, Math.round(this.playback.frame) - first))];
    return now?.phases[this.index] ?? null;
  }

  /** Turns the mark of the wheel to the phase of the part. */
  #follow(): void {
    const wheel = this.querySelector<SVGElement>("svg");
    const phase = this.#phase;
    if (!wheel || phase === null) return;
    wheel.style.setProperty("--turn", `${phase.toFixed(4)}turn`);
    this.querySelector("[role=slider]")?.setAttribute("aria-valuenow", String(Math.round(100 * phase)));
  }

  #turnsOf(event: PointerEvent): number {
    const { left, top, width, height } = (event.currentTarget as Element).getBoundingClientRect();
    return Math.atan2(event.clientX - left - width / 2, top + height / 2 - event.clientY) / (2 * Math.PI);
  }

  #hold(event: PointerEvent): void {
    if (event.button !== 0) return;
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    this.#held = this.#turnsOf(event);
    this.live.drive(this.index, 0);
  }

  #turn(event: PointerEvent): void {
    if (this.#held === null) return;
    const now = this.#turnsOf(event);
    this.live.drive(this.index, phaseDifference(now, this.#held));
    this.#held = now;
  }

  #letGo(): void {
    this.#held = null;
    const { driven } = this.live;
    if (driven !== null) this.live.release(driven);
  }

  #key(event: KeyboardEvent): void {
    const turns = KEYS[event.key];
    if (turns !== undefined) this.live.drive(this.index, turns);
    else if (event.key === "Escape" && this.live.driven !== null) this.#letGo();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  protected override render() {
    const { name, words } = this;
    return html`
      <div class="wheel" style=${partStyle(partColour(this.index))}>
        <div class="wheel-rim" role="slider" tabindex="0" data-testid="wheel" title=${words.wheelMeaning}
          aria-label=${words.wheel(name)} aria-valuemin="0" aria-valuemax="100"
          @pointerdown=${this.#hold} @pointermove=${this.#turn} @pointerup=${this.#letGo}
          @pointercancel=${this.#letGo} @keydown=${this.#key} @blur=${this.#letGo}>
          <svg viewBox="-50 -50 100 100" aria-hidden="true">
            <circle r="38" /><line y1="0" y2="-38" /><circle class="wheel-grip" cy="-38" r="9" />
          </svg>
        </div>
      </div>`;
  }
}
customElements.define("pg-wheel", WheelView);
