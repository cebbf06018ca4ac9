// How far each prediction is from the real trial, frame by frame: where a model goes wrong, and whether it
// stays so.
import { html, svg } from "lit";
import type { ModelKind } from "../engine/whole-protocol";
import { axes, path, labelsWidth } from "../figures/chart";
import { MARK_SIZE } from "../figures/marks";
import { FigureElement } from "../figures/figure-element";
import { spreadLabels, textWidth } from "../figures/labels";
import { inColour, modelMark, modelStyle } from "../figures/model-style";
import { plain } from "../figures/numbers";
import { linearScale } from "../figures/scale";
import { compareWords } from "./view-words";

export interface Distances {
  /** Seconds between frames. */
  frameTime: number;
  /** The title of the trial held out. */
  trial: string;
  lines: { model: ModelKind; label: string /** [frames] */; metres: Float64Array }[];
}

const LEAD = 14;
/** In a narrower figure the lines have only the names of their models; the picture above has the settings. */
const NARROW = 640;

const mean = (values: Float64Array) => values.reduce((sum, value) => sum + value, 0) / values.length;

export class DistanceFigure extends FigureElement<Distances> {
  protected readonly words = () => compareWords().distance;
  protected readonly file = "distance-from-the-trial";
  #place: (frame: number) => number = () => 0;

  protected missing({ lines }: Distances): string | null {
    return lines.length === 0 ? compareWords().distance.none : null;
  }

  protected table({ lines, frameTime, trial }: Distances) {
    const frames = Math.max(...lines.map(({ metres }) => metres.length));
    return {
      header: [
        "trial",
        "time (s)",
        ...lines.map(
          ({ model, label }) => `${[modelStyle(model).name, label].filter(Boolean).join(", ")} (cm)`,
        ),
      ],
      rows: Array.from({ length: frames }, (_, frame) => [
        trial,
        frame * frameTime,
        ...lines.map(({ metres }) => 100 * (metres[frame] ?? NaN)),
      ]),
    };
  }

  /** Moves the line at the time of the clock. */
  at(frame: number): void {
    const x = String(this.#place(frame));
    const line = this.querySelector(".playhead");
    line?.setAttribute("x1", x);
    line?.setAttribute("x2", x);
  }

  protected figure({ lines, frameTime }: Distances) {
    const { type, width } = this;
    const texts = compareWords().distance;
    const narrow = width < NARROW;
    const words = lines.map(({ model, label }) =>
      narrow || !label ? modelStyle(model).name : `${modelStyle(model).name}, ${label}`,
    );
    const beyond = LEAD + 1.2 * type + Math.max(...words.map((word) => textWidth(word, type)));
    const height = Math.round(Math.max(13 * type, lines.length * 1.45 * type + 6 * type));
    const [top, bottom, right] = [2.2 * type, height - 3.4 * type, width - beyond];
    const y = linearScale(
      [0, ...lines.flatMap(({ metres }) => [...metres].map((distance) => 100 * distance))],
      bottom,
      top,
    );
    const up = { scale: y, least: 0, title: texts.axis };
    const left = labelsWidth(up, { right, top, bottom, type });
    const last = Math.max(...lines.map(({ metres }) => metres.length)) - 1;
    const x = linearScale([0, last * frameTime], left, right);
    this.#place = (frame) => x.at(frame * frameTime);
    const drawn = lines.map(({ model, metres }, i) => ({
      model,
      name: words[i] ?? "",
      places: [...metres].map((distance, frame) => [x.at(frame * frameTime), y.at(100 * distance)] as const),
    }));
    const ends = spreadLabels(
      drawn.map(({ places }) => places.at(-1)?.[1] ?? bottom),
      1.45 * type,
      top,
      bottom,
    );
    const found = lines
      .map(({ model, metres }) => texts.centimetres(modelStyle(model).name, plain(100 * mean(metres))))
      .join(", ");
    return html`
      <svg class="chart-drawing" width=${width} height=${height} viewBox="0 0 ${width} ${height}" role="img" aria-label=${texts.label(found)}>
        ${axes({ left, right, top, bottom, type }, { scale: x, least: 0, title: texts.time }, up)}
        <line class="playhead" data-not-in-picture x1=${left} x2=${left} y1=${top} y2=${bottom}></line>
        ${drawn.map(({ model, name, places }, i) => {
          const [endX, endY] = places.at(-1) ?? [right, bottom];
          const labelY = ends[i] ?? bottom;
          return svg`<g style=${inColour(model)} font-size=${type}>
            ${path(places)}
            <path class="leader" d="M${endX} ${endY}L${right + LEAD} ${labelY}"></path>
            ${modelMark(model, right + LEAD, labelY, MARK_SIZE * type)}
            <text class="label" x=${right + LEAD + 0.85 * type} y=${labelY + 0.35 * type}>${name}</text>
          </g>`;
        })}
      </svg>
      <figcaption>${texts.caption}</figcaption>`;
  }
}
customElements.define("comparison-distance", DistanceFigure);
