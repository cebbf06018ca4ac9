// The columns over time, in place of a figure. The recorded curves are dashed, the rolled-out curves are
// solid.
import { html, nothing, svg } from "lit";
import { axes, path, labelsWidth } from "../figures/chart";
import "../figures/figures.css";
import { linearScale } from "../figures/scale";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import { type Curve, curvesOf } from "./curves";
import type { SeriesStore } from "./series-store";
import { seriesWords } from "../words/series";

const HEIGHT = 150;
const TYPE = 12;
/** The maximum number of labels on a vertical axis, because the charts are low. */
const TICKS = 3;

export class SeriesCurves extends View {
  static override properties = { width: { state: true } };
  declare model: SeriesStore;
  /** The width of a chart, in pixels. */
  declare width: number;
  /** The x position of the first frame, and the distance between two frames, in pixels. */
  #across = { first: 0, step: 0 };

  constructor() {
    super();
    this.width = 400;
  }

  protected override stores() {
    return [this.model];
  }

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

  #chart({ name, part, rolledOut, recorded }: Curve, frameTime: number, order: number) {
    const [bottom, top] = [HEIGHT - 2.2 * TYPE - 12, 2 * TYPE];
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
    return html`
      <figure class="figure-card series-curve" data-testid="curve-${order}" style=${partStyle(partColour(part), { "--series": partColour(part) })}>
        <svg width=${this.width} height=${HEIGHT} viewBox="0 0 ${this.width} ${HEIGHT}" role="img" aria-label=${seriesWords().curve(name, Boolean(recorded))}>
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
    return html`<div class="series-curves" tabindex="0" role="group" aria-label=${seriesWords().overTime}>${curvesOf(
      info,
      rollout.values,
      recorded,
    ).map((curve, i) => this.#chart(curve, info.frameTime, i))}</div>`;
  }
}
customElements.define("pg-series-curves", SeriesCurves);
