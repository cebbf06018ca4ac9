// The pad of one hand: what was drawn, and the pen of the model with its trail.
import { html } from "lit";
import { clearCanvas, eachFrame, prefersReducedMotion } from "../ui/browser";
import { onThemeChange, partColour, partColourNow } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import { drawingWords } from "./view-words";
import type { DrawingStore, Pad } from "./drawing-store";
import { eight } from "./example";
import { HEIGHT, ROWS_A_SECOND, WIDTH } from "./hand";

/** The trail of the pen, in rows. */
const TRAIL = 1.5 * ROWS_A_SECOND;
/** An empty pad shows how to draw, faintly: the opacity, and the trail in seconds. */
const HINT = 0.3;
const HINT_TRAIL = 1;
/** A key moves the pen by this part of a pad, and takes as many milliseconds. */
const STEP = 5;
const KEY_TIME = 70;

const KEYS: Record<string, [number, number]> = {
  ArrowLeft: [-STEP, 0],
  ArrowRight: [STEP, 0],
  ArrowUp: [0, STEP],
  ArrowDown: [0, -STEP],
};

export class PadView extends View {
  static override properties = { pad: { type: Number } };
  declare store: DrawingStore;
  declare pad: Pad;
  /** The pen of the keyboard, with its own time; null: no key has drawn. */
  #keyPen: { x: number; y: number; now: number } | null = null;
  /** Seconds since an empty pad began to show how to draw. */
  #hint = 0;

  protected override stores() {
    return [this.store];
  }

  protected override arrived(): void {
    const { store } = this;
    this.whenLeaving(store.model.clock.on(() => this.#paint()));
    // While one hand draws, the pen of the other goes on by itself.
    this.whenLeaving(
      eachFrame((seconds) => {
        if (this.#hints) this.#hint += seconds;
        if (store.isDrawing || this.#hints) this.#paint();
      }),
    );
    this.whenLeaving(onThemeChange(() => this.#paint()));
  }

  protected override updated(): void {
    this.#paint();
  }

  /** Whether a pen shows how to draw. */
  get #hints(): boolean {
    const { store, pad } = this;
    return pad === 0 && !store.drawn && !store.isDrawing && !store.busy && !prefersReducedMotion();
  }

  /** The place of a pointer, in hundredths of the pad's width. */
  #place(event: PointerEvent, pad: Element): [number, number] {
    const { left, bottom, width } = pad.getBoundingClientRect();
    return [(100 * (event.clientX - left)) / width, (100 * (bottom - event.clientY)) / width];
  }

  #begin(event: PointerEvent): void {
    if (event.button !== 0) return;
    event.preventDefault();
    const pad = event.currentTarget as Element;
    pad.setPointerCapture(event.pointerId);
    this.store.begin(this.pad, ...this.#place(event, pad), event.timeStamp);
  }

  #move(event: PointerEvent): void {
    const pad = event.currentTarget as Element;
    if (!pad.hasPointerCapture(event.pointerId)) return;
    const all = event.getCoalescedEvents?.() ?? [];
    for (const each of all.length > 0 ? all : [event])
      this.store.move(this.pad, ...this.#place(each, pad), each.timeStamp);
  }

  #end(event: PointerEvent): void {
    if ((event.currentTarget as Element).hasPointerCapture(event.pointerId)) this.store.end(this.pad);
  }

  #key(event: KeyboardEvent): void {
    const by = KEYS[event.key];
    if (by) {
      this.#keyPen ??= { x: WIDTH / 2, y: HEIGHT / 2, now: performance.now() };
      const pen = this.#keyPen;
      if (!this.store.strokes(this.pad)) this.store.begin(this.pad, pen.x, pen.y, pen.now);
      pen.x = Math.min(WIDTH, Math.max(0, pen.x + by[0]));
      pen.y = Math.min(HEIGHT, Math.max(0, pen.y + by[1]));
      pen.now += KEY_TIME;
      this.store.move(this.pad, pen.x, pen.y, pen.now);
    } else if (event.key === "Enter" && this.#keyPen) {
      this.#keyPen = null;
      void this.store.finish();
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  #paint(): void {
    const canvas = this.querySelector("canvas");
    const surface = canvas && canvas.clientWidth > 0 ? clearCanvas(canvas) : null;
    if (!surface) return;
    const { draw, width, height } = surface;
    const { store, pad } = this;
    const colour = partColourNow(pad);
    draw.lineCap = draw.lineJoin = "round";
    draw.strokeStyle = draw.fillStyle = colour;
    const at = ([x = 0, y = 0]: readonly number[]): [number, number] => [
      (x / WIDTH) * width,
      height - (y / WIDTH) * width,
    ];
    const middle = ([x = 0, y = 0]: readonly number[], [a = 0, b = 0]: readonly number[]) => [
      (x + a) / 2,
      (y + b) / 2,
    ];
    /** A smooth line: it bends at each point and passes the middles between two points. */
    const line = (points: readonly (readonly number[])[], thick: number, opacity: number) => {
      draw.globalAlpha = opacity;
      draw.lineWidth = thick;
      draw.beginPath();
      points.forEach((point, i) => {
        const before = points[i - 1];
        if (before) draw.quadraticCurveTo(...at(before), ...at(middle(before, point)));
        else draw.moveTo(...at(point));
      });
      draw.lineTo(...at(points.at(-1) ?? []));
      draw.stroke();
    };
    const strokes = store.strokes(pad);
    if (strokes) {
      for (const stroke of strokes)
        line(
          stroke.map(({ x, y }) => [x, y]),
          4,
          1,
        );
      draw.globalAlpha = 1;
      return;
    }
    if (this.#hints) {
      const places = Array.from({ length: 40 }, (_, i) => eight(this.#hint - HINT_TRAIL * (1 - i / 39)));
      line(places, 4, HINT);
      draw.beginPath();
      draw.arc(...at(places.at(-1) ?? []), 7, 0, 2 * Math.PI);
      draw.fill();
      draw.globalAlpha = 1;
      return;
    }
    line(store.rows(pad), 2, 0.25);
    const trail = store.trail(pad, TRAIL);
    // Round ends would show twice where two pieces meet.
    draw.lineCap = "butt";
    for (let i = 2; i < trail.length; i++) {
      const [a, b, c] = [trail[i - 2] ?? [], trail[i - 1] ?? [], trail[i] ?? []];
      line([middle(a, b), b, middle(b, c)], 4, i / trail.length);
    }
    const pen = store.pen(pad, performance.now());
    if (pen) {
      const [before, last] = trail.slice(-2);
      if (before && last) line([middle(before, last), last, pen], 4, 1);
      draw.globalAlpha = 1;
      draw.beginPath();
      draw.arc(...at(pen), 7, 0, 2 * Math.PI);
      draw.fill();
    }
    draw.globalAlpha = 1;
  }

  protected override render() {
    const words = drawingWords();
    const { store, pad } = this;
    const isEmpty = !store.strokes(pad) && !store.drawn?.pads.includes(pad);
    const waits = pad === 1 && !store.drawn && !store.isDrawing;
    return html`
      <div class="pad" style=${partStyle(partColour(pad))} tabindex="0" role="group" aria-label=${words.pad(words.hands[pad] ?? "")} data-testid="pad-${pad}"
        @pointerdown=${this.#begin} @pointermove=${this.#move} @pointerup=${this.#end} @pointercancel=${this.#end} @keydown=${this.#key}>
        <canvas aria-hidden="true"></canvas>
        ${isEmpty ? html`<p class=${waits ? "quiet" : ""}>${words.invite[pad]}</p>` : ""}
      </div>`;
  }
}
customElements.define("pg-pad", PadView);
