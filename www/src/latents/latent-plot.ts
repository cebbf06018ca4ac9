// The latent space of one part: a canvas, and a button on each inducing point, for mouse, finger and keyboard.
import { html } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { pointAt } from "./pointing";
import { onThemeChange, partColour } from "../ui/palette";
import type { InducingPoint } from "../engine/protocol";
import { principalAxes, project, type Projection, type Turn } from "./projection";
import { changeSettings } from "../settings/change";
import { drawLatents, type LatentPicture, Plane } from "./latent-drawing";
import { swatchStyle, View } from "../ui/view";

/** What the plots show besides paths. */
export interface Marks {
  pose: boolean;
  dynamics: boolean;
  between: boolean;
}

const FLAT: Turn = { about: 0, tilt: 0 };
const TILTED: Turn = { about: -0.6, tilt: 0.5 };

interface Mark {
  key: string;
  point: InducingPoint;
  label: string;
  /** Where its button goes: a row of points [n x Q]. */
  points: Float64Array;
  row: number;
}

export class LatentPlot extends View {
  static override topics = ["model", "rollout", "pointed", "settings", "shown"] as const;
  static override properties = { bodyPart: { type: Number }, marks: { attribute: false } };
  declare bodyPart: number;
  declare marks: Marks;
  private turn: Turn = { ...FLAT };
  private projection: Projection | null = null;
  private projectionOf: unknown = null;
  private drag: { x: number; y: number; turn: Turn; moved: boolean } | null = null;
  private list: Mark[] = [];
  private stopTick: (() => void) | undefined;

  constructor() {
    super();
    this.bodyPart = 0;
    this.marks = { pose: true, dynamics: true, between: false };
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.stopTick = this.app.on(["tick"], () => this.paint());
    onThemeChange(() => this.requestUpdate());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stopTick?.();
  }

  override firstUpdated(): void {
    new ResizeObserver(() => this.requestUpdate()).observe(this.querySelector(".plot")!);
    if (this.app.settings.plot === "3d") this.turn = { ...TILTED };
  }

  override willUpdate(): void {
    const { model, learned, settings } = this.app;
    if (model && learned && this.projectionOf !== learned) {
      const q = model.info.parts[this.bodyPart]?.latent ?? 0;
      this.projection = principalAxes(this.cloud(q), q, this.projection);
      this.projection.reach = Math.max(this.projection.reach, this.reachOfMarks(this.projection));
      this.projectionOf = learned;
    }
    if (settings.plot === "2d") this.turn = { ...FLAT };
    else if (this.turn.about === 0 && this.turn.tilt === 0) this.turn = { ...TILTED };
    this.list = this.listMarks();
  }

  /** The points that decide the axes and the scale: the rollout as learned, and the training latents. */
  private cloud(q: number): Float64Array {
    const { model, learned } = this.app;
    const path = learned?.latents[this.bodyPart] ?? new Float64Array(0);
    const training = model?.trainingLatents?.[this.bodyPart] ?? new Float64Array(0);
    const cloud = new Float64Array(path.length + training.length);
    cloud.set(path);
    cloud.set(training, path.length);
    return q > 0 ? cloud : new Float64Array(0);
  }

  /** How far out this part's inducing points lie, but no further than half again the path: one stray point must not shrink the rest. */
  private reachOfMarks(projection: Projection): number {
    const { model } = this.app;
    const own = model?.dynamicsInducing[this.bodyPart]?.[this.bodyPart];
    const at = new Float64Array(3);
    let reach = 0;
    for (const points of [model?.poseInducing[this.bodyPart], own?.inputs, own?.outputs]) {
      const count = (points?.length ?? 0) / projection.dimensions;
      for (let i = 0; i < count; i++) {
        project(projection, points!, i, at);
        reach = Math.max(reach, Math.hypot(at[0]!, at[1]!));
      }
    }
    return Math.min(reach, 1.5 * projection.reach);
  }

  private listMarks(): Mark[] {
    const { model } = this.app;
    if (!model) return [];
    const part = this.bodyPart;
    const { parts, order } = model.info;
    const name = (index: number) => parts[index]?.name ?? "";
    const marks: Mark[] = [];
    parts.forEach((_, target) => {
      const own = target === part;
      const inducing = model.dynamicsInducing[part]?.[target];
      if (!inducing || !(own ? this.marks.dynamics : this.marks.between)) return;
      for (let i = 0; i < inducing.count; i++) {
        marks.push({
          key: `d${target}-${i}`,
          point: { kind: "dynamics", source: part, target, index: i },
          label: `Dynamics inducing point ${i + 1} of ${name(part)}${own ? "" : ` about ${name(target)}`}`,
          points: own ? inducing.outputs : inducing.inputs,
          row: own ? i : i * order + order - 1,
        });
      }
    });
    // Last, so that they lie on top, as they are drawn.
    const poses = model.poseInducing[part];
    for (let i = 0; this.marks.pose && poses && i < (parts[part]?.poseIps ?? 0); i++) {
      const label = `Pose inducing point ${i + 1} of ${name(part)}`;
      marks.push({ key: `p${i}`, point: { kind: "pose", part, index: i }, label, points: poses, row: i });
    }
    return marks;
  }

  override updated(): void {
    this.paint();
    this.placeButtons();
  }

  private picture(canvas: HTMLCanvasElement): LatentPicture | null {
    const { model, rollout, learned, pointed, player, shown, altered } = this.app;
    const { bodyPart: part, projection, turn, marks } = this;
    const latents = rollout?.latents[part];
    if (!model || !latents || !projection || projection.dimensions !== model.info.parts[part]?.latent) return null;
    const box = canvas.parentElement!;
    const lit =
      pointed !== null && part === (pointed.point.kind === "pose" ? pointed.point.part : pointed.point.source);
    const others = model.info.parts.flatMap((_, other) => (other === part || !marks.between ? [] : [other]));
    return {
      width: box.clientWidth,
      height: box.clientHeight,
      ratio: Math.min(2, devicePixelRatio),
      projection,
      turn,
      colour: partColour(part),
      rollout: latents,
      learned: altered ? (learned?.latents[part] ?? null) : null,
      training: model.trainingLatents?.[part] ?? null,
      poses: marks.pose ? (model.poseInducing[part] ?? null) : null,
      dynamics: marks.dynamics ? (model.dynamicsInducing[part]?.[part] ?? null) : null,
      outgoing: others.map((other) => ({
        inducing: model.dynamicsInducing[part]![other]!,
        other,
        colour: partColour(other),
      })),
      incoming: others.map((other) => ({
        inducing: model.dynamicsInducing[other]![part]!,
        other,
        colour: partColour(other),
      })),
      order: model.info.order,
      frame: player.frame,
      live: shown?.kind === "model",
      report: pointed,
      lit,
    };
  }

  private paint(): void {
    const canvas = this.querySelector("canvas");
    const draw = canvas?.getContext("2d");
    if (!canvas || !draw || canvas.parentElement!.clientWidth === 0) return;
    const picture = this.picture(canvas);
    if (!picture) {
      draw.clearRect(0, 0, canvas.width, canvas.height);
      return;
    }
    const [width, height] = [Math.round(picture.width * picture.ratio), Math.round(picture.height * picture.ratio)];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    drawLatents(draw, picture);
  }

  private placeButtons(): void {
    const { projection } = this;
    const box = this.querySelector<HTMLElement>(".plot");
    if (!projection || !box) return;
    const view = { width: box.clientWidth, height: box.clientHeight, projection, turn: this.turn };
    const plane = new Plane(view);
    this.querySelectorAll<HTMLElement>("button.mark").forEach((button, i) => {
      const mark = this.list[i];
      if (!mark) return;
      const [x, y] = plane.place(mark.points, mark.row);
      button.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    });
  }

  private grab(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.drag = { x: event.clientX, y: event.clientY, turn: { ...this.turn }, moved: false };
  }

  private move(event: PointerEvent): void {
    const { drag } = this;
    if (!drag) return;
    const [dx, dy] = [event.clientX - drag.x, event.clientY - drag.y];
    if (!drag.moved && Math.hypot(dx, dy) < 5) return;
    if (!drag.moved) {
      drag.moved = true;
      (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    }
    this.turnTo({ about: drag.turn.about + 0.01 * dx, tilt: drag.turn.tilt + 0.01 * dy });
  }

  private turnTo(turn: Turn): void {
    this.turn = { about: turn.about, tilt: Math.max(-1.5, Math.min(1.5, turn.tilt)) };
    if (this.app.settings.plot === "2d") changeSettings(this.app, { plot: "3d" });
    this.paint();
    this.placeButtons();
  }

  private drop(): void {
    this.drag = null;
  }

  /** Arrow keys turn the plot, or go from one inducing point to the next. */
  private keys(event: KeyboardEvent): void {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!step) {
      if (event.key === "Escape") pointAt(this.app, null);
      return;
    }
    event.preventDefault();
    event.stopPropagation();
    const buttons = [...this.querySelectorAll<HTMLElement>("button.mark")];
    const at = buttons.indexOf(event.target as HTMLElement);
    if (at >= 0) {
      const next = buttons[(at + step + buttons.length) % buttons.length]!;
      buttons.forEach((button) => (button.tabIndex = button === next ? 0 : -1));
      next.focus();
    } else {
      const sideways = event.key === "ArrowLeft" || event.key === "ArrowRight";
      const { about, tilt } = this.turn;
      this.turnTo(sideways ? { about: about + 0.12 * step, tilt } : { about, tilt: tilt + 0.12 * step });
    }
  }

  protected override render() {
    const { model, pointing } = this.app;
    const name = model?.info.parts[this.bodyPart]?.name ?? "";
    const chosen = JSON.stringify(pointing);
    const point = (to: InducingPoint | null) => () => pointAt(this.app, to);
    return html`
      <figure class="latent" style=${swatchStyle(partColour(this.bodyPart))}>
        <figcaption><i class="swatch"></i>${name}</figcaption>
        <div class="plot" tabindex="0" role="group" aria-label="Latent space of ${name}. Drag, or use the arrow keys, to turn it."
          data-testid="latent-${this.bodyPart}"
          @pointerdown=${this.grab} @pointermove=${this.move} @pointerup=${this.drop} @pointercancel=${this.drop}
          @keydown=${this.keys}>
          <canvas aria-hidden="true"></canvas>
          ${repeat(
            this.list,
            ({ key }) => key,
            ({ key, point: to, label }, i) => html`
            <button class="mark" type="button" data-mark=${key} tabindex=${i === 0 ? 0 : -1} aria-label=${label} title=${label}
              aria-pressed=${JSON.stringify(to) === chosen ? "true" : "false"}
              @pointerenter=${point(to)} @pointerleave=${point(null)}
              @focus=${point(to)} @blur=${point(null)} @click=${point(to)}></button>`,
          )}
        </div>
      </figure>
    `;
  }
}
customElements.define("pg-latent-plot", LatentPlot);
