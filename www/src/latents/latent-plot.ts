// The latent space of one part: a canvas, and a button on each inducing point.
import { html, nothing } from "lit";
import type { Coupled, LatentPaths } from "../couplings/coupled";
import type { DynamicsInducing, InducingPoint } from "../engine/protocol";
import type { SettingsStore } from "../settings/settings-store";
import type { Clock } from "../stage/clock";
import type { StageStore } from "../stage/stage-store";
import { onThemeChange, partColour, partColourNow } from "../ui/palette";
import { View } from "../ui/view";
import { drawLatents, type LatentPicture, placeNow } from "./latent-drawing";
import "./latents.css";
import type { LayersStore } from "./layers-store";
import { Plane } from "./plane";
import { StepBand } from "./prediction-drawing";
import type { PredictionsStore } from "./predictions-store";
import { type PointingStore, samePoint } from "./pointing-store";
import type { PushHandle } from "./push-handle";
import { type Projection, principalAxes, type Turn } from "./projection";
import { partStyle } from "../ui/styled";
import { lab, shownPart } from "../words/lab";

const FLAT: Turn = { about: 0, tilt: 0 };
const TILTED: Turn = { about: -0.6, tilt: 0.5 };

/** What the plots of one model have in common. Only a model of a body has the optional stores. */
export interface Space {
  readonly layers: LayersStore;
  readonly settings: SettingsStore;
  readonly playback: Clock;
  readonly stage?: StageStore;
  readonly pointing?: PointingStore;
  readonly predictions?: PredictionsStore;
}

interface Mark {
  key: string;
  point: InducingPoint;
  label: string;
  /** The place of its button: a row of points [n x Q]. */
  points: Float64Array;
  row: number;
}

export class LatentPlot extends View {
  static override properties = { bodyPart: { type: Number } };
  bodyPart = 0;
  declare model: Coupled;
  declare space: Space;
  #turn: Turn = FLAT;
  #projection: Projection | null = null;
  /** The rollout as learned that the axes were computed from. */
  #projected: LatentPaths | null = null;
  #drag: { x: number; y: number; turn: Turn; moved: boolean } | null = null;
  #list: Mark[] = [];
  /** The requested animation frame; 0 without one. */
  #frame = 0;
  /** Whether the buttons need new places. */
  #moved = false;
  readonly #band = new StepBand();

  protected override stores() {
    const { pointing, settings, stage, layers } = this.space;
    return [this.model, settings, layers, ...(pointing ? [pointing] : []), ...(stage ? [stage] : [])];
  }

  protected override arrived(): void {
    const { playback, predictions } = this.space;
    for (const store of [playback, predictions])
      if (store) this.whenLeaving(store.on(() => this.#paintSoon()));
    this.whenLeaving(() => {
      cancelAnimationFrame(this.#frame);
      this.#frame = 0;
    });
    this.whenLeaving(onThemeChange(() => this.requestUpdate()));
    const box = this.querySelector(".plot");
    if (box) this.watchSize(box, () => this.requestUpdate());
  }

  override willUpdate(): void {
    const { model, learned } = this.model;
    if (model && learned && this.#projected !== learned) {
      const q = model.info.parts[this.bodyPart]?.latent ?? 0;
      this.#projection = principalAxes(this.#cloud(q), q, this.#projection);
      this.#projected = learned;
    }
    if (this.space.settings.values.plot === "2d") this.#turn = FLAT;
    else if (this.#turn.about === 0 && this.#turn.tilt === 0) this.#turn = TILTED;
    this.#list = this.#listMarks();
  }

  /**
   * The points that define axes and scale: the rollout as learned, and the training latents. Inducing points
   * do not count: some lie far away, and are drawn at the edge.
   */
  #cloud(q: number): Float64Array {
    const { model, learned } = this.model;
    const path = learned?.latents[this.bodyPart] ?? new Float64Array(0);
    const training = model?.trainingLatents?.[this.bodyPart] ?? new Float64Array(0);
    const cloud = new Float64Array(path.length + training.length);
    cloud.set(path);
    cloud.set(training, path.length);
    return q > 0 ? cloud : new Float64Array(0);
  }

  #listMarks(): Mark[] {
    const { model } = this.model;
    if (!model) return [];
    const part = this.bodyPart;
    const { parts, order } = model.info;
    const name = (index: number) => shownPart(parts[index]?.name ?? "");
    const marks: Mark[] = [];
    const words = lab().loops;
    parts.forEach((_, target) => {
      const own = target === part;
      const inducing = model.dynamicsInducing[part]?.[target];
      if (!inducing || !(own ? this.space.layers.shown.dynamics : this.space.layers.shown.between)) return;
      for (let i = 0; i < inducing.count; i++) {
        marks.push({
          key: `d${target}-${i}`,
          point: { kind: "dynamics", source: part, target, index: i },
          label: words.dynamicsPoint(i + 1, name(part), own ? null : name(target)),
          points: own ? inducing.outputs : inducing.inputs,
          row: own ? i : i * order + order - 1,
        });
      }
    });
    // Last, so that their buttons lie on top.
    const poses = model.poseInducing[part];
    for (let i = 0; this.space.layers.shown.pose && poses && i < (parts[part]?.poseIps ?? 0); i++) {
      const label = words.posePoint(i + 1, name(part));
      marks.push({ key: `p${i}`, point: { kind: "pose", part, index: i }, label, points: poses, row: i });
    }
    return marks;
  }

  override updated(): void {
    this.#moved = true;
    this.#paintSoon();
  }

  /**
   * Paints once before the next picture of the page. A pending request stays: the clock ticks before each
   * picture, and would postpone a new request for ever.
   */
  #paintSoon(): void {
    if (this.#frame !== 0) return;
    this.#frame = requestAnimationFrame(() => {
      this.#frame = 0;
      this.#paint();
      if (this.#moved) this.#placeButtons();
      this.#moved = false;
    });
  }

  #picture(box: HTMLElement): LatentPicture | null {
    const { bodyPart: part } = this;
    const { playback, layers, stage } = this.space;
    const { shown, behind } = layers;
    const projection = this.#projection;
    const turn = this.#turn;
    const { model, rollout, learned, couplings } = this.model;
    const live = stage?.live;
    const latents = live?.latents(part) ?? rollout?.latents[part];
    if (!model || !latents || !projection || projection.dimensions !== model.info.parts[part]?.latent)
      return null;
    const report = this.space.pointing?.report ?? null;
    const predictions = this.space.predictions?.report;
    const inducing = (source: number, target: number) => model.dynamicsInducing[source]?.[target];
    const ofOthers = (pointsOf: (other: number) => DynamicsInducing | undefined) =>
      model.info.parts.flatMap((_, other) => {
        const points = other === part || !shown.between ? undefined : pointsOf(other);
        return points ? [{ inducing: points, other, colour: partColourNow(other) }] : [];
      });
    return {
      width: box.clientWidth,
      height: box.clientHeight,
      ratio: Math.min(2, devicePixelRatio),
      projection,
      turn,
      part,
      colour: partColourNow(part),
      rollout: latents,
      learned: couplings.altered || live ? (learned?.latents[part] ?? null) : null,
      training: model.trainingLatents?.[part] ?? null,
      poses: shown.pose ? (model.poseInducing[part] ?? null) : null,
      dynamics: shown.dynamics ? (inducing(part, part) ?? null) : null,
      outgoing: ofOthers((other) => inducing(part, other)),
      incoming: ofOthers((other) => inducing(other, part)),
      order: model.info.order,
      frame: playback.frame - (live?.first ?? 0),
      live: !stage || stage.content?.kind === "model",
      report,
      lit:
        report !== null && part === (report.point.kind === "pose" ? report.point.part : report.point.source),
      predicted:
        !predictions || live || !rollout?.weights
          ? null
          : { report: predictions, weights: rollout.weights.map((row) => row[part] ?? 0) },
      band: this.#band,
      behind: live ? null : behind,
    };
  }

  #paint(): void {
    const canvas = this.querySelector("canvas");
    const draw = canvas?.getContext("2d");
    const box = canvas?.parentElement;
    if (!canvas || !draw || !box || box.clientWidth === 0 || box.clientHeight === 0) return;
    const picture = this.#picture(box);
    if (!picture) {
      draw.clearRect(0, 0, canvas.width, canvas.height);
      return;
    }
    const [width, height] = [
      Math.round(picture.width * picture.ratio),
      Math.round(picture.height * picture.ratio),
    ];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    drawLatents(draw, picture);
    const handle = this.querySelector<PushHandle>("pg-push-handle");
    const plane = new Plane(picture);
    const now = handle && placeNow(picture, plane);
    if (now) handle.place(plane, now);
  }

  #placeButtons(): void {
    const projection = this.#projection;
    const box = this.querySelector<HTMLElement>(".plot");
    if (!projection || !box) return;
    const view = { width: box.clientWidth, height: box.clientHeight, projection, turn: this.#turn };
    const plane = new Plane(view);
    this.querySelectorAll<HTMLElement>("button.mark").forEach((button, i) => {
      const mark = this.#list[i];
      if (!mark) return;
      const [x, y] = plane.inFrame(...plane.place(mark.points, mark.row));
      button.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    });
  }

  #grab(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.#drag = { x: event.clientX, y: event.clientY, turn: this.#turn, moved: false };
  }

  #move(event: PointerEvent): void {
    const drag = this.#drag;
    if (!drag) return;
    const [dx, dy] = [event.clientX - drag.x, event.clientY - drag.y];
    if (!drag.moved && Math.hypot(dx, dy) < 5) return;
    if (!drag.moved) {
      drag.moved = true;
      (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    }
    this.#turnTo({ about: drag.turn.about + 0.01 * dx, tilt: drag.turn.tilt + 0.01 * dy });
  }

  #turnTo(turn: Turn): void {
    this.#turn = { about: turn.about, tilt: Math.max(-1.5, Math.min(1.5, turn.tilt)) };
    if (this.space.settings.values.plot === "2d") this.space.settings.change({ plot: "3d" });
    this.#moved = true;
    this.#paintSoon();
  }

  #drop(): void {
    this.#drag = null;
  }

  /** Arrow keys turn the plot, or move the focus from one inducing point to the next. */
  #keys(event: KeyboardEvent): void {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!step) {
      if (event.key === "Escape") this.space.pointing?.pointAt(null);
      return;
    }
    event.preventDefault();
    event.stopPropagation();
    const buttons = [...this.querySelectorAll<HTMLElement>("button.mark")];
    const at = buttons.indexOf(event.target as HTMLElement);
    if (at >= 0) {
      const next = buttons.at((at + step) % buttons.length);
      for (const button of buttons) button.tabIndex = button === next ? 0 : -1;
      next?.focus();
    } else {
      const sideways = event.key === "ArrowLeft" || event.key === "ArrowRight";
      const { about, tilt } = this.#turn;
      this.#turnTo(sideways ? { about: about + 0.12 * step, tilt } : { about, tilt: tilt + 0.12 * step });
    }
  }

  protected override render() {
    const { pointing, stage } = this.space;
    const name = shownPart(this.model.model?.info.parts[this.bodyPart]?.name ?? "");
    const point = (to: InducingPoint | null) => () => pointing?.pointAt(to);
    return html`
      <figure class="latent" style=${partStyle(partColour(this.bodyPart))}>
        <div class="plot" tabindex="0" role="group" aria-label=${lab().loops.plotOf(name)} title=${lab().loops.turn}
          data-testid="latent-${this.bodyPart}"
          @pointerdown=${this.#grab} @pointermove=${this.#move} @pointerup=${this.#drop} @pointercancel=${this.#drop}
          @keydown=${this.#keys}>
          <canvas class="cover passive" aria-hidden="true"></canvas>
          ${this.#list.map(
            ({ key, point: to, label }, i) => html`
            <button class="mark" type="button" data-mark=${key} tabindex=${i === 0 ? 0 : -1} aria-label=${label} title=${label}
              aria-pressed=${pointing && samePoint(to, pointing.point) ? "true" : "false"}
              @pointerenter=${point(to)} @pointerleave=${point(null)}
              @focus=${point(to)} @blur=${point(null)} @click=${point(to)}></button>`,
          )}
          ${stage?.live ? html`<pg-push-handle .bodyPart=${this.bodyPart} .name=${name}></pg-push-handle>` : nothing}
        </div>
      </figure>
    `;
  }
}
customElements.define("pg-latent-plot", LatentPlot);
