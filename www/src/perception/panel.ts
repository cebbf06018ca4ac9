// A chart of points with error bars, lines and a curve. A figure has several of them side by side.
import { html, nothing, svg, type TemplateResult } from "lit";
import type { ModelKind } from "../engine/whole-protocol";
import { axes, path, uprightBar, labelsWidth } from "../figures/chart";
import { MARK_SIZE } from "../figures/marks";
import { inColour, modelMark } from "../figures/model-style";
import { spreadLabels, textWidth } from "../figures/labels";
import { linearScale, logScale, type Scale } from "../figures/scale";
import { styled } from "../ui/styled";

export interface PanelPoint {
  model: ModelKind;
  x: number;
  y: number;
  /** The ends of the error bar; equal to y without one. */
  low: number;
  high: number;
  /** Half width and half height of an ellipse in place of the model's mark, in em. */
  ellipse?: readonly [number, number];
}

export interface PanelAxis {
  title: string;
  kind: "linear" | "log";
  /** Values that the axis must reach besides the points. */
  reach: readonly number[];
}

/** A line in a neutral colour or in the colour of a model. */
export interface PanelLine {
  model: ModelKind | null;
  places: readonly (readonly [x: number, y: number])[];
  /** At the end of the line. */
  label?: string;
}

export interface Panel {
  heading: string | TemplateResult;
  /** For screen readers. */
  words: string;
  x: PanelAxis;
  y: PanelAxis;
  points: readonly PanelPoint[];
  lines: readonly PanelLine[];
  /** The values of dashed horizontal lines. */
  references: readonly number[];
}

/** Half the width of the last label of an axis across, in em. */
const LABEL = 1.8;

const drawable = ({ x, y }: PanelPoint) => Number.isFinite(x) && Number.isFinite(y);

const scaleOf = ({ kind, reach }: PanelAxis, values: readonly number[], from: number, to: number): Scale =>
  (kind === "log" ? logScale : linearScale)([...values, ...reach], from, to);

function mark(model: ModelKind, x: number, y: number, type: number, ellipse: PanelPoint["ellipse"]) {
  if (!ellipse) return modelMark(model, x, y, MARK_SIZE * type);
  return svg`<ellipse class="dot hollow" cx=${x} cy=${y} rx=${ellipse[0] * type} ry=${ellipse[1] * type}></ellipse>`;
}

export function panel(
  { heading, words, x, y, points, lines, references }: Panel,
  width: number,
  type: number,
) {
  const height = Math.round(Math.min(0.72 * width, 240) + 2 * type);
  const labelled = Math.max(0, ...lines.map(({ label = "" }) => textWidth(label, type)));
  const [top, bottom, right] = [
    2.2 * type,
    height - 3.4 * type,
    width - Math.max(10 + labelled, LABEL * type),
  ];
  const drawn = points.filter(drawable);
  const heights = drawn.flatMap((point) => [point.low, point.y, point.high]);
  const yScale = scaleOf(y, heights, bottom, top);
  const up = { scale: yScale, title: y.title };
  const left = labelsWidth(up, { right, top, bottom, type });
  const xScale = scaleOf(
    x,
    drawn.map((point) => point.x),
    left,
    right,
  );
  const place = ([px, py]: readonly [number, number]) => [xScale.at(px), yScale.at(py)] as const;
  const ends = lines.flatMap(({ label, places }) => {
    const last = places.at(-1);
    return label && last ? [{ label, x: xScale.at(last[0]), y: yScale.at(last[1]) }] : [];
  });
  const labels = spreadLabels(
    ends.map((end) => end.y),
    1.1 * type,
    top,
    bottom,
  );
  return html`
    <div class="panel-figure">
      <p>${heading}</p>
      <svg class="chart-drawing" width=${width} height=${height} viewBox="0 0 ${width} ${height}" role="img" aria-label=${words}>
        ${axes({ left, right, top, bottom, type }, { scale: xScale, title: x.title }, up)}
        ${references.map((at) => svg`<line class="reference" x1=${left} x2=${right} y1=${yScale.at(at)} y2=${yScale.at(at)}></line>`)}
        ${lines.map(({ model, places }) => svg`<g class="panel-line" style=${model ? inColour(model) : styled({ "--series": "var(--quiet)" })}>${path(places.map(place))}</g>`)}
        ${drawn.map(
          ({ model, low, high, ...point }) => svg`<g style=${inColour(model)}>
            ${high > low ? uprightBar(xScale.at(point.x), yScale.at(low), yScale.at(high), 3) : nothing}
            ${mark(model, xScale.at(point.x), yScale.at(point.y), type, point.ellipse)}</g>`,
        )}
        ${ends.map(({ label, x }, i) => svg`<text class="label" font-size=${type} x=${x + 0.8 * type} y=${(labels[i] ?? 0) + 0.35 * type}>${label}</text>`)}
      </svg>
    </div>`;
}

const GAP = 28;

/** Panels side by side, as many as the width allows; at most `across`. */
export function panels(all: readonly Panel[], space: number, type: number, across = 3) {
  const least = 21 * type;
  const columns = Math.max(1, Math.min(across, all.length, Math.floor((space + GAP) / (least + GAP))));
  const width = Math.floor(Math.min(440, (space - (columns - 1) * GAP) / columns));
  return html`
    <div class="panels" style=${styled({ "grid-template-columns": `repeat(${columns}, minmax(0, ${width}px))`, gap: `18px ${GAP}px` })}>
      ${all.map((content) => panel(content, width, type))}
    </div>`;
}
