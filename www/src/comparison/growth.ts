// How the time of an iteration grows with the frames (figure 2 of the supplement of Velychko et al. 2017).
import { html, svg } from "lit";
import { axes, path, labelsWidth } from "../figures/chart";
import { MARK_SIZE } from "../figures/marks";
import { FigureElement } from "../figures/figure-element";
import { exponentWords, growthFinding } from "./findings";
import { type Point, spreadLabels, textWidth } from "../figures/labels";
import { inColour, modelMark, modelStyle } from "../figures/model-style";
import { logScale } from "../figures/scale";
import type { Comparison, Growth } from "../engine/whole-protocol";
import { compareWords } from "./view-words";

const MOST = 860;
/** In a narrower figure names and exponents have two lines. */
const NARROW = 520;
/** From the end of the axis to the marks next to the names. */
const LEAD = 18;

const drawable = ({ points }: Growth) =>
  points
    .filter(({ frames, seconds }) => frames > 0 && seconds > 0 && Number.isFinite(frames + seconds))
    .sort((a, b) => a.frames - b.frames);

export class GrowthFigure extends FigureElement<Comparison> {
  protected readonly words = () => compareWords().growth;
  protected readonly file = "learning-time-against-frames";

  protected missing({ growth }: Comparison): string | null {
    return growth.every((line) => drawable(line).length === 0) ? compareWords().growth.none : null;
  }

  protected table({ growth }: Comparison) {
    return {
      header: ["model", "frames", "time of an iteration (s)", "exponent of the model"],
      rows: growth.flatMap(({ model, points, exponent }) =>
        points.map(({ frames, seconds }) => [modelStyle(model).name, frames, seconds, exponent]),
      ),
    };
  }

  /** A model's points, and its mark again with name and exponent at `end`, where lines do not overlap. */
  #line(
    { model }: Growth,
    places: readonly (readonly [number, number])[],
    words: { name: string; exponent: string },
    end: Point,
    narrow: boolean,
  ) {
    const { type } = this;
    const [lastX, lastY] = places.at(-1) ?? [end.x, end.y];
    const text = end.x + 0.85 * type;
    return svg`<g style=${inColour(model)} font-size=${type}>
      <path class="leader" d="M${lastX} ${lastY}L${end.x} ${end.y}"></path>
      ${path(places)}
      ${places.map(([x, y]) => modelMark(model, x, y, MARK_SIZE * type))}
      ${modelMark(model, end.x, end.y, MARK_SIZE * type)}
      ${
        narrow
          ? svg`<text class="label strong" x=${text} y=${end.y - 0.21 * type}>${words.name}</text><text class="label" x=${text} y=${end.y + 0.91 * type}>${words.exponent}</text>`
          : svg`<text class="label" x=${text} y=${end.y + 0.35 * type}><tspan class="strong">${words.name}</tspan>, ${words.exponent}</text>`
      }
    </g>`;
  }

  protected figure({ growth }: Comparison) {
    const { type } = this;
    const words = compareWords().growth;
    const width = Math.min(MOST, this.width);
    const narrow = width < NARROW;
    const lines = growth
      .map((line) => ({
        line,
        points: drawable(line),
        words: { name: modelStyle(line.model).name, exponent: exponentWords(line) },
      }))
      .filter(({ points }) => points.length > 0);
    const wide = lines.map(({ words: { name, exponent } }) => {
      const strong = textWidth(name, type, 600);
      return narrow ? Math.max(strong, textWidth(exponent, type)) : strong + textWidth(`, ${exponent}`, type);
    });
    const beyond = LEAD + type + Math.max(...wide);
    const step = (narrow ? 2.5 : 1.45) * type;
    const height = Math.round(Math.max(Math.min(0.5 * width, 360), lines.length * step + 6.5 * type, 250));
    const [top, bottom, right] = [2.2 * type, height - 3.4 * type, width - beyond];
    const y = logScale(
      lines.flatMap(({ points }) => points.map(({ seconds }) => seconds)),
      bottom,
      top,
    );
    const up = { scale: y, title: words.seconds };
    const left = labelsWidth(up, { right, top, bottom, type });
    const x = logScale(
      lines.flatMap(({ points }) => points.map(({ frames }) => frames)),
      left,
      right,
    );
    const drawn = lines.map(({ line, words: label, points }) => ({
      line,
      label,
      places: points.map(({ frames, seconds }) => [x.at(frames), y.at(seconds)] as const),
    }));
    const ends = spreadLabels(
      drawn.map(({ places }) => places.at(-1)?.[1] ?? bottom),
      step,
      top + type,
      bottom - type,
    );
    return html`
      <svg class="chart-drawing" width=${width} height=${height} viewBox="0 0 ${width} ${height}" role="img" aria-label=${growthFinding(lines.map(({ line }) => line))}>
        ${axes({ left, right, top, bottom, type }, { scale: x, title: words.frames }, up)}
        ${drawn.map(({ line, places, label }, i) => this.#line(line, places, label, { x: right + LEAD, y: ends[i] ?? bottom }, narrow)).reverse()}
      </svg>
      <figcaption>${words.caption}</figcaption>`;
  }
}
customElements.define("comparison-growth", GrowthFigure);
