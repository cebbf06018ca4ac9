// The live view over the stage: the cuts, who moves each part, and a strip chart of phases and distances. Limbs
// can be dragged.
import { html, nothing } from "lit";
import type { PushPart } from "../latents/push-handle";
import "../latents/push-handle";
import type { Playback } from "../stage/playback";
import type { StageView } from "../stage/stage-view";
import { clearCanvas } from "../ui/browser";
import { onThemeChange, partColour, partColourNow } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import { letDragLimbs } from "./drag-limbs";
import "./live.css";
import { type LiveStore, type Mark, SHOWN_SECONDS } from "./live-store";
import { actionText, distanceLines, type Pieces, phaseLines } from "./strip";
import type { Performance } from "./performance";
import type { RecordedParts } from "./recorded-parts";
import "./wheel-view";
import { lab, shownPart } from "../words/lab";

/** The distance at the top of the chart, in radii. */
const FARTHEST = 1.5;

export class LiveView extends View {
  declare live: LiveStore;
  declare playback: Playback;
  declare recorded: RecordedParts;
  /** Records what the visitor does. */
  #performed: Performance | null = null;
  /** The part of the wheel. */
  #wheel = 0;

  protected override stores() {
    return [this.live, this.recorded];
  }

  /** Shows the live motion of the Lab, and offers to record it. */
  set performed(performed: Performance) {
    this.#performed = performed;
    [this.live, this.recorded, this.playback] = [performed.live, performed.recorded, performed.app.playback];
  }

  protected override arrived(): void {
    this.whenLeaving(onThemeChange(() => this.requestUpdate()));
    const canvas = this.querySelector("canvas");
    if (canvas) this.watchSize(canvas, () => this.requestUpdate());
    const stage = this.closest(".stage-area")?.querySelector<StageView>("pg-stage");
    if (stage) this.whenLeaving(letDragLimbs(stage, this.live));
    const page = this.closest("main");
    const push = ({ part, by }: PushPart) => this.live.push(part, by);
    if (page) this.listen(page, "push-part", (event) => push((event as CustomEvent<PushPart>).detail));
  }

  get #names(): string[] {
    return this.live.body?.parts.map(({ name }) => shownPart(name)) ?? [];
  }

  override updated(): void {
    const canvas = this.querySelector("canvas");
    if (canvas) drawStrip(canvas, this.live, this.live.body?.frameTime ?? 1 / 30);
  }

  /** The choice of who moves a part: "model", "you", or the key of a recording after a dot. */
  #choose(part: number, value: string): void {
    const { live, recorded } = this;
    recorded.choose(part, value.startsWith(".") ? value.slice(1) : null);
    if (value === "model") live.release(part);
    // The part stands still until the wheel is turned.
    if (value === "you") live.drive(part, 0);
  }

  /** Who moves a part. */
  #mover(part: number, name: string, isCyclic: boolean) {
    const { live, recorded } = this;
    const words = lab().live;
    const key = recorded.keyOf(part);
    const isYou = key === null && live.moverOf(part) !== null;
    const option = (value: string, text: string, chosen: boolean) =>
      html`<option value=${value} .selected=${chosen}>${text}</option>`;
    const recordings = recorded.all.map(({ key: own, title }) => option(`.${own}`, title, own === key));
    return html`
      <label style=${partStyle(partColour(part))}><i class="swatch"></i>${name}
        <select data-testid="mover-${part}" aria-label=${words.mover(name)}
          @change=${(event: Event) => this.#choose(part, (event.target as HTMLSelectElement).value)}>
          ${option("model", words.model, key === null && !isYou)}
          ${isCyclic || isYou ? option("you", words.you, isYou) : nothing}
          ${recordings.length > 0 ? html`<optgroup label=${words.recording}>${recordings}</optgroup>` : nothing}
        </select></label>`;
  }

  protected override render() {
    const { live } = this;
    const names = this.#names;
    const words = lab().live;
    if (!live.running) return nothing;
    if (live.driven !== null) this.#wheel = live.driven;
    if (this.#wheel >= names.length) this.#wheel = 0;
    const { isCyclic } = live;
    const text = actionText(live.marks, names) ?? words.hint;
    return html`
      <div class="live-strip" data-testid="live">
        <p role="status">${text}</p>
        <div class="movers" role="group" aria-label=${words.movers}>${names.map((name, part) => this.#mover(part, name, isCyclic))}</div>
        ${
          isCyclic
            ? html`
          <pg-wheel .live=${live} .playback=${this.playback} .index=${this.#wheel} .name=${names[this.#wheel] ?? ""} .words=${words}></pg-wheel>
          <p class="strip-legend"><span>${words.ahead(names[0] ?? "")}</span><span>${words.distance}</span></p>
          <canvas role="img" aria-label=${words.chart(names[0] ?? "", names.slice(1))}></canvas>`
            : html`<p>${words.noPhase}</p>`
        }
      </div>
      ${this.#performed ? html`<pg-perform .performed=${this.#performed}></pg-perform>` : nothing}`;
  }
}
customElements.define("pg-live", LiveView);

/** Draws phase differences above, distances below, and actions as bands and lines behind them. */
function drawStrip(canvas: HTMLCanvasElement, live: LiveStore, frameTime: number): void {
  const surface = clearCanvas(canvas);
  if (!surface) return;
  const { draw, width, height } = surface;
  const frames = SHOWN_SECONDS / frameTime;
  const last = live.trace.at(-1)?.frame ?? 0;
  const x = (frame: number) => width - ((last - frame) / frames) * width;
  const half = height / 2;
  const ink = getComputedStyle(canvas).color;
  for (const mark of live.marks) drawMark(draw, mark, x, last, height);
  draw.strokeStyle = ink;
  draw.globalAlpha = 0.35;
  for (const y of [half / 2, height - 1])
    line(
      draw,
      [
        { x: 0, y },
        { x: width, y },
      ],
      1,
    );
  draw.globalAlpha = 1;
  const lines = (all: Pieces[], first: number, y: (value: number) => number) =>
    all.forEach((pieces, k) => {
      draw.strokeStyle = partColourNow(k + first);
      for (const piece of pieces)
        line(
          draw,
          piece.map(({ frame, value }) => ({ x: x(frame), y: y(value) })),
          1.8,
        );
    });
  lines(phaseLines(live.trace), 1, (value) => half / 2 - value * (half - 6));
  lines(
    distanceLines(live.trace),
    0,
    (value) => height - 2 - (Math.min(value, FARTHEST) / FARTHEST) * (half - 8),
  );
}

function drawMark(
  draw: CanvasRenderingContext2D,
  mark: Mark,
  x: (frame: number) => number,
  last: number,
  height: number,
) {
  const from = x(mark.from);
  if (mark.kind === "push") {
    const colour = mark.part < 0 ? "gray" : partColourNow(mark.part);
    draw.strokeStyle = colour;
    band(draw, colour, x(mark.began), from, height);
    draw.setLineDash([3, 3]);
    line(
      draw,
      [
        { x: from, y: 0 },
        { x: from, y: height },
      ],
      1.5,
    );
    draw.setLineDash([]);
    return;
  }
  const colour = partColourNow(mark.kind === "cut" ? mark.source : mark.part);
  band(draw, colour, from, x(mark.to ?? last), height);
}

function band(
  draw: CanvasRenderingContext2D,
  colour: string,
  from: number,
  to: number,
  height: number,
): void {
  draw.fillStyle = colour;
  draw.globalAlpha = 0.18;
  draw.fillRect(from, 0, to - from, height);
  draw.globalAlpha = 1;
}

function line(draw: CanvasRenderingContext2D, points: { x: number; y: number }[], width: number): void {
  draw.lineWidth = width;
  draw.beginPath();
  for (const { x, y } of points) draw.lineTo(x, y);
  draw.stroke();
}
