// The handle on the marker of a plot while the motion is live. A drag or an arrow key pushes the part. Loaded
// with the live motion.
import { html } from "lit";
import { View } from "../ui/view";
import type { Plane } from "./plane";
import "./push-handle.css";
import { lab } from "../words/lab";

/** Pixels of one press of an arrow key. */
const STEP = 8;
const ARROWS: Record<string, readonly [number, number]> = {
  ArrowLeft: [-STEP, 0],
  ArrowRight: [STEP, 0],
  ArrowUp: [0, -STEP],
  ArrowDown: [0, STEP],
};

/** The detail of the event "push-part": the shift of a part in each latent dimension. */
export interface PushPart {
  part: number;
  by: number[];
}

export class PushHandle extends View {
  static override properties = { bodyPart: { type: Number }, name: {} };
  declare bodyPart: number;
  declare name: string;
  #plane: Plane | null = null;
  #held: { x: number; y: number } | null = null;

  /** Moves the handle onto the marker. */
  place(plane: Plane, [x, y]: readonly [number, number]): void {
    this.#plane = plane;
    this.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
  }

  #push(dx: number, dy: number): void {
    if (!this.#plane) return;
    const detail: PushPart = { part: this.bodyPart, by: this.#plane.latentStep(dx, dy) };
    this.dispatchEvent(new CustomEvent("push-part", { detail, bubbles: true }));
  }

  /** The event stops here: the plot would turn. */
  #grab(event: PointerEvent): void {
    event.stopPropagation();
    if (event.button !== 0) return;
    this.#held = { x: event.clientX, y: event.clientY };
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
  }

  /** Only the movement of the pointer counts, because the marker moves on under it. */
  #drag(event: PointerEvent): void {
    if (!this.#held) return;
    const { clientX: x, clientY: y } = event;
    this.#push(x - this.#held.x, y - this.#held.y);
    this.#held = { x, y };
  }

  #drop(): void {
    this.#held = null;
  }

  #keys(event: KeyboardEvent): void {
    const step = ARROWS[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    this.#push(...step);
  }

  protected override render() {
    const { state, drag } = lab().loops.push;
    return html`<button type="button" aria-label=${state(this.name)} title=${drag(this.name)} data-testid="push-${this.bodyPart}"
      @pointerdown=${this.#grab} @pointermove=${this.#drag} @pointerup=${this.#drop} @pointercancel=${this.#drop}
      @keydown=${this.#keys}></button>`;
  }
}
customElements.define("pg-push-handle", PushHandle);
