// The columns over time, in place of a figure. The recorded curves are dashed, the rolled-out curves are
// solid. A curve by hand can be drawn.
import { html, nothing, svg } from "lit";
import { axes, path, labelsWidth } from "../figures/chart";
import "../figures/figures.css";
import { linearScale } from "../figures/scale";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import type { SeriesStore } from "./series-store";
import type { Giver } from "./given-columns";
import { seriesWords } from "./view-words";
import type { SeriesInfo } from "../engine/series-protocol";
import type { TableEntry } from "./tables-store";

interface Curve {
  name: string;
  /** The index of the column's part. */
  part: number;
  /** [frames] */
  rolledOut: number[];
  /** [rows], with the same time step; null if the table is not open. */
  recorded: number[] | null;
}

const column = (values: ArrayLike<number>, width: number, place: number): number[] =>
  Array.from({ length: Math.floor(values.length / width) }, (_, row) => values[row * width + place] ?? 0);

/**
 * The curves, one part after the other; `values` [frames x columns]. The columns of the recording may be in
 * another order.
 */
export function curvesOf(
  { parts, columns }: Pick<SeriesInfo, "parts" | "columns">,
  values: Float64Array,
  recorded: Pick<TableEntry, "info" | "values"> | null,
): Curve[] {
  return parts.flatMap(({ joints: places }, part) =>
    places.map((place) => {
      const name = columns[place] ?? "";
      const found = recorded?.info.columns.indexOf(name) ?? -1;
      return {
        name,
        part,
        rolledOut: column(values, columns.length, place),
        recorded:
          recorded && found >= 0 ? column(recorded.values, recorded.info.columns.length, found) : null,
      };
    }),
  );
}

const HEIGHT = 150;
const TYPE = 12;
/** A press of an arrow key bends a curve by this share of the axis. */
const KEY_BEND = 0.05;
/** The maximum number of labels on a vertical axis, because the charts are low. */
const TICKS = 3;

export class SeriesCurves extends View {
  static override properties = { width: { state: true } };
  declare model: SeriesStore;
  /** The width of a chart, in pixels. */
  width = 400;
  /** The curve that is drawn: its last point, and the value at a height in the chart. */
  #drawing: { column: string; last: [number, number]; valueAt: (y: number) => number } | null = null;
  /** The x position of the first frame, and the distance between two frames, in pixels. */
  #across = { first: 0, step: 0 };

  protected override arrived(): void {
    this.whenLeaving(this.model.clock.on(() => this.#markNow()));
    const measure = () => {
      this.width = this.querySelector(".series-curve")?.clientWidth || this.width;
    };
    this.watchSize(this, measure);
  }

  protected override updated(): void {
    this.#markNow();
    this.width = this.querySelector(".series-curve")?.clientWidth || this.width;
  }

  #markNow(): void {
    const x = String(this.#across.first + this.#across.step * this.model.clock.frame);
    for (const line of this.querySelectorAll(".playhead")) {
      line.setAttribute("x1", x);
      line.setAttribute("x2", x);
    }
  }

  /** The frame and the height of a pointer in a chart. */
  #place(event: PointerEvent): { frame: number; y: number } {
    const { left, top } = (event.currentTarget as Element).getBoundingClientRect();
    const { first, step } = this.#across;
    return { frame: Math.round((event.clientX - left - first) / step), y: event.clientY - top };
  }

  #draw(event: PointerEvent): void {
    if (!this.#drawing) return;
    const { column, last, valueAt } = this.#drawing;
    const { frame, y } = this.#place(event);
    const next: [number, number] = [frame, valueAt(y)];
    this.model.draw(column, last, next);
    this.#drawing.last = next;
  }

  /** The handlers of a curve by hand: a pen for the pointer, and arrow keys at the frame of the clock. */
  #pen(column: string, valueAt: (y: number) => number, bend: number) {
    const begin = (event: PointerEvent) => {
      if (event.button !== 0) return;
      (event.currentTarget as Element).setPointerCapture(event.pointerId);
      const { frame, y } = this.#place(event);
      this.#drawing = { column, last: [frame, valueAt(y)], valueAt };
      this.#draw(event);
    };
    const end = () => {
      this.#drawing = null;
    };
    const key = (event: KeyboardEvent) => {
      const sign = { ArrowUp: 1, ArrowDown: -1 }[event.key];
      if (!sign) return;
      event.preventDefault();
      event.stopPropagation();
      this.model.bend(column, sign * bend);
    };
    return { begin, end, key };
  }

  /** Who moves a column. */
  #giver(name: string, recorded: boolean, order: number) {
    const words = seriesWords().givers;
    const now = this.model.giverOf(name);
    const option = (value: Giver | "model", text: string) =>
      html`<option value=${value} .selected=${value === (now ?? "model")}>${text}</option>`;
    const choose = (event: Event) => {
      const { value } = event.target as HTMLSelectElement;
      this.model.give(name, value === "model" ? null : (value as Giver));
    };
    return html`
      <select class="series-giver note" data-testid="giver-${order}" aria-label=${words.who(name)} @change=${choose}>
        ${option("model", words.model)}
        ${recorded || now === "recording" ? option("recording", words.recording) : nothing}
        ${option("hand", words.hand)}
      </select>`;
  }

  #chart({ name, part, rolledOut, recorded }: Curve, frameTime: number, order: number, coupled: boolean) {
    const [bottom, top] = [HEIGHT - 2.2 * TYPE - 12, (coupled ? 2.8 : 2) * TYPE];
    const up = linearScale([...rolledOut, ...(recorded ?? [])], bottom, top);
    const upward = { scale: up, title: name, most: TICKS };
    const space = { right: this.width - 8, top, bottom, type: TYPE };
    const plot = { ...space, left: Math.max(44, labelsWidth(upward, space)) };
    const end = Math.max(rolledOut.length, recorded?.length ?? 0) - 1;
    const right = linearScale([0, end * frameTime], plot.left, plot.right);
    const placed = (values: readonly number[]) =>
      values.map((value, frame): [number, number] => [right.at(frame * frameTime), up.at(value)]);
    const first = right.at(0);
    this.#across = { first, step: right.at(frameTime) - first };
    const valueAt = (y: number) => up.low + ((bottom - y) / (bottom - top)) * (up.high - up.low);
    const isByHand = this.model.giverOf(name) === "hand";
    const pen = isByHand ? this.#pen(name, valueAt, KEY_BEND * (up.high - up.low)) : null;
    const words = seriesWords();
    const now = rolledOut[Math.min(rolledOut.length - 1, Math.round(this.model.clock.frame))] ?? 0;
    const slider = pen ? { role: "slider", focus: "0", now: now.toPrecision(3) } : { role: "img" };
    return html`
      <figure class="figure-card series-curve" data-testid="curve-${order}" style=${partStyle(partColour(part), { "--series": partColour(part) })}>
        ${coupled ? this.#giver(name, recorded !== null, order) : nothing}
        <svg width=${this.width} height=${HEIGHT} viewBox="0 0 ${this.width} ${HEIGHT}" class=${pen ? "by-hand" : ""} role=${slider.role}
          tabindex=${slider.focus ?? nothing} aria-valuenow=${slider.now ?? nothing}
          aria-label=${pen ? words.givers.draw(name) : words.curve(name, Boolean(recorded))}
          @pointerdown=${pen?.begin} @pointermove=${pen ? this.#draw : undefined} @pointerup=${pen?.end} @pointercancel=${pen?.end} @keydown=${pen?.key}>
          ${axes(plot, { scale: right, title: seriesWords().time }, upward)}
          <g class="rolled-out">${path(placed(rolledOut))}</g>
          ${recorded ? svg`<g class="recorded">${path(placed(recorded))}</g>` : nothing}
          <line class="playhead" y1=${top} y2=${bottom}></line>
        </svg>
      </figure>`;
  }

  protected override render() {
    const { opened, rollout, recorded } = this.model;
    if (!opened || !rollout) return nothing;
    const { info } = opened;
    return html`<div class="series-curves scroll" tabindex="0" role="group" aria-label=${seriesWords().overTime}>${curvesOf(
      info,
      rollout.values,
      recorded,
    ).map((curve, i) => this.#chart(curve, info.frameTime, i, info.alpha !== null))}</div>`;
  }
}
customElements.define("pg-series-curves", SeriesCurves);
