// Axes, lines and error bars in SVG. One unit is one pixel; colours come from the stylesheet, that of a
// series of data from `--series`.
import { nothing, svg } from "lit";
import type { Scale, Tick } from "./scale";
import { textWidth } from "./labels";

/** The space inside the axes, and the size of the type. */
export interface Plot {
  left: number;
  right: number;
  top: number;
  bottom: number;
  type: number;
}

/** An axis. Its title names quantity, unit and a logarithmic scale. */
export interface Axis {
  scale: Scale;
  title: string;
  /** The least value with a label. */
  least?: number;
  /** The largest number of labels. */
  most?: number;
}

/** The width of the widest label. */
const widest = (ticks: Tick[], type: number) =>
  Math.max(0, ...ticks.map(({ label }) => textWidth(label, type)));

const ticksOf = ({ scale, least = Number.NEGATIVE_INFINITY }: Axis, most: number): Tick[] =>
  scale.ticks(most).filter(({ value }) => value >= least);

/** The ticks of a horizontal axis, without overlap. */
function ticksAcross(axis: Axis, length: number, type: number): Tick[] {
  for (let most = axis.most ?? 8; most > 2; most--) {
    const ticks = ticksOf(axis, most);
    const places = ticks.map(({ value }) => axis.scale.at(value));
    const gap = Math.min(...places.slice(1).map((place, i) => place - (places[i] ?? place)));
    if (ticks.length < 2 || (gap >= widest(ticks, type) + type && ticks.length * type < length)) return ticks;
  }
  return ticksOf(axis, 2);
}

/** The ticks of a vertical axis. */
const ticksUp = (axis: Axis, length: number, type: number): Tick[] =>
  ticksOf(axis, axis.most ?? Math.max(2, Math.floor(length / (3.2 * type))));

/** The width of the labels of a vertical axis, which is the left end of the space inside the axes. */
export function labelsWidth(axis: Axis, { top, bottom, type }: Omit<Plot, "left">): number {
  return widest(ticksUp(axis, bottom - top, type), type) + 10;
}

/** Both axes with their grid. */
export function axes({ left, right, top, bottom, type }: Plot, x: Axis, y: Axis) {
  return svg`
    <g class="axes" font-size=${type}>
      ${ticksUp(y, bottom - top, type).map(
        ({ value, label }) => svg`
        <line class="grid" x1=${left} x2=${right} y1=${y.scale.at(value)} y2=${y.scale.at(value)}></line>
        <text x=${left - 7} y=${y.scale.at(value) + 0.35 * type} text-anchor="end">${label}</text>`,
      )}
      ${ticksAcross(x, right - left, type).map(
        ({ value, label }) => svg`
        <line class="axis" x1=${x.scale.at(value)} x2=${x.scale.at(value)} y1=${bottom} y2=${bottom + 4}></line>
        <text x=${x.scale.at(value)} y=${bottom + 5 + type} text-anchor="middle">${label}</text>`,
      )}
      <line class="axis" x1=${left} x2=${right} y1=${bottom} y2=${bottom}></line>
      <text class="axis-title" x=${0} y=${type} text-anchor="start">${y.title}</text>
      <text class="axis-title" x=${right} y=${bottom + 8 + 2.2 * type} text-anchor="end">${x.title}</text>
    </g>`;
}

/** A horizontal error bar with caps; nothing if it is shorter than a pixel. */
export function errorBar(from: number, to: number, y: number, cap: number) {
  if (Math.abs(to - from) < 1) return nothing;
  return svg`<path class="error-bar" d=${`M${from} ${y}H${to}M${from} ${y - cap}v${2 * cap}M${to} ${y - cap}v${2 * cap}`}></path>`;
}

/** A line through points [x, y]. */
export function path(points: readonly (readonly [number, number])[]) {
  return svg`<path class="course" d=${points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${x.toFixed(2)} ${y.toFixed(2)}`).join("")}></path>`;
}

/** A vertical error bar with caps; nothing if it is shorter than a pixel. */
export function uprightBar(x: number, from: number, to: number, cap: number) {
  if (Math.abs(to - from) < 1) return nothing;
  return svg`<path class="error-bar" d=${`M${x} ${from}V${to}M${x - cap} ${from}h${2 * cap}M${x - cap} ${to}h${2 * cap}`}></path>`;
}
