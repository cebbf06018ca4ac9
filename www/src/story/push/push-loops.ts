// The loop of each part in its latent space, with the last moments of the walk: a push leaves the loop, and
// the walk leads back.
import { html } from "lit";
import { Plane } from "../../latents/plane";
import { principalAxes, type Projection } from "../../latents/projection";
import { fillDot } from "../../latents/shapes";
import { clearCanvas } from "../../ui/canvas";
import { eachFrame } from "../../ui/each-frame";
import { partColourNow } from "../../ui/palette";
import { View } from "../../ui/view";
import type { PushChapter } from "./push-chapter";

/** Seconds of the learned motion that make the loop, and of the walk behind the dot. */
const LOOP_SECONDS = 3;
const TRAIL_SECONDS = 1.2;
const FLAT = { about: 0, tilt: 0 };

export class PushLoops extends View {
  declare chapter: PushChapter;
  /** The name of the picture, and the names of the parts. */
  declare label: string;
  declare names: readonly string[];
  /** The learned paths, and the projection of each. */
  #paths: readonly Float64Array[] = [];
  #projections: Projection[] = [];

  protected override stores() {
    return [this.chapter];
  }

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
