// A large drawing of a latent space with handles: a canvas, and a button for each handle. Pointer, touch and
// arrow keys move the handles.
import { html, nothing } from "lit";
import { Plane } from "../../latents/plane";
import type { Projection } from "../../latents/projection";
import { clearCanvas, eachFrame } from "../../ui/browser";
import { onThemeChange } from "../../ui/palette";
import type { Observed } from "../../ui/store";
import { View } from "../../ui/view";
import "./latent.css";

/** Something in the drawing that the visitor moves or presses. */
export interface Handle {
  id: string;
  label: string;
  /** Its place in pixels. */
  place(plane: Plane): readonly [x: number, y: number];
  /** Moves to a place in pixels. */
  drag?(plane: Plane, x: number, y: number): void;
  /** Moves by arrow keys: -1, 0 or 1 to the right and down. */
  nudge?(right: number, down: number): void;
  press?(): void;
  /** Whether it is on: a handle that can be pressed only. */
  pressed?: boolean;
  /** A pointer anywhere in the drawing moves this handle. */
  anywhere?: boolean;
}

/** What the drawing shows. */
export interface LatentScene extends Observed {
  /** Null before the model has arrived. */
  readonly projection: Projection | null;
  /** Whether the drawing changes by itself. */
  readonly moves: boolean;
  readonly handles: readonly Handle[];
  paint(draw: CanvasRenderingContext2D, plane: Plane, size: { width: number; height: number }): void;
  /** Once for each frame of the display. */
  tick?(seconds: number): void;
}

const KEYS: Record<string, [right: number, down: number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

const FLAT = { about: 0, tilt: 0 };

export class LatentView extends View {
  static override properties = { scene: { attribute: false }, label: {} };
  declare scene: LatentScene;
  declare label: string;
  #isOld = true;
  #plane: Plane | null = null;
  #dragged: string | null = null;

  protected override stores() {
    return [this.scene];
  }

  protected override arrived(): void {
    const again = () => {
      this.#isOld = true;
    };
    this.whenLeaving(onThemeChange(again));
    this.watchSize(this, again);
    this.whenLeaving(
      eachFrame((seconds) => {
        this.scene.tick?.(seconds);
        if (this.#isOld || this.scene.moves) this.#paint();
      }),
    );
  }

  protected override updated(): void {
    this.#isOld = true;
  }

  #paint(): void {
    const canvas = this.querySelector("canvas");
    const { projection } = this.scene;
    const [width, height] = [this.clientWidth, this.clientHeight];
    if (!canvas || !projection || width === 0 || height === 0) return;
    const draw = clearCanvas(canvas)?.draw;
    if (!draw) return;
    this.#isOld = false;
    this.#plane = new Plane({ width, height, projection, turn: FLAT });
    draw.lineJoin = draw.lineCap = "round";
    this.scene.paint(draw, this.#plane, { width, height });
    draw.globalAlpha = 1;
    for (const handle of this.scene.handles) {
      const button = this.querySelector<HTMLElement>(`[data-handle="${handle.id}"]`);
      const [x, y] = this.#plane.inFrame(...handle.place(this.#plane));
      if (button) button.style.transform = `translate(${x}px, ${y}px)`;
    }
  }

  #handle(id: string | null): Handle | undefined {
    return this.scene.handles.find((handle) => handle.id === id);
  }

  #grab(event: PointerEvent): void {
    const over = (event.target as HTMLElement).closest("[data-handle]")?.getAttribute("data-handle") ?? null;
    const handle = over === null ? this.scene.handles.find(({ anywhere }) => anywhere) : this.#handle(over);
    if (!handle?.drag || event.button !== 0) return;
    this.#dragged = handle.id;
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    this.querySelector<HTMLElement>(`[data-handle="${handle.id}"]`)?.focus({ preventScroll: true });
    event.preventDefault();
    if (over === null) this.#drag(event);
  }

  #drag(event: PointerEvent): void {
    const { left, top } = this.getBoundingClientRect();
    if (this.#plane)
      this.#handle(this.#dragged)?.drag?.(this.#plane, event.clientX - left, event.clientY - top);
  }

  #move(event: PointerEvent): void {
    if (this.#dragged !== null) this.#drag(event);
  }

  #drop(): void {
    this.#dragged = null;
  }

  #key(handle: Handle, event: KeyboardEvent): void {
    const step = KEYS[event.key];
    if (!step || !handle.nudge) return;
    event.preventDefault();
    handle.nudge(...step);
  }

  protected override render() {
    const { handles, projection } = this.scene;
    return html`
      <div class="latent-space" role="group" aria-label=${this.label} @pointerdown=${this.#grab} @pointermove=${this.#move}
        @pointerup=${this.#drop} @pointercancel=${this.#drop}>
        <canvas aria-hidden="true"></canvas>
        ${
          projection
            ? handles.map(
                (handle) => html`
          <button class="latent-handle" data-handle=${handle.id} data-testid="handle-${handle.id}" aria-label=${handle.label}
            aria-pressed=${handle.pressed === undefined ? nothing : handle.pressed ? "true" : "false"}
            @click=${() => handle.press?.()} @keydown=${(event: KeyboardEvent) => this.#key(handle, event)}></button>`,
              )
            : nothing
        }
      </div>`;
  }
}
customElements.define("pg-latent-space", LatentView);
