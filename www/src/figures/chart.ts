// Axes, lines and error bars in SVG. One unit is one pixel; colours come from the stylesheet, that of a
// series of data from `--series`.
import { nothing, svg } from "lit";
import type { Scale, Tick } from "./scale";
import { textWidth } from "./text-width";

/** The space inside the axes, and the size of the type. */
export interface Plot {
  left: number;
  right: number;
  bottom: number;
  type: number;
}

/** The width of the widest label. */
const widest = (ticks: Tick[], type: number) =>
  Math.max(0, ...ticks.map(({ label }) => textWidth(label, type)));

/** The ticks of a horizontal axis, without overlap. */
export function ticksAcross(scale: Scale, length: number, type: number): Tick[] {
  for (let most = 8; most > 2; most--) {
    const ticks = scale.ticks(most);
    const places = ticks.map(({ value }) => scale.at(value));
    const least = Math.min(...places.slice(1).map((place, i) => place - (places[i] ?? place)));
    if (ticks.length < 2 || (least >= widest(ticks, type) + type && ticks.length * type < length))
      return ticks;
  }
  return scale.ticks(2);
}

/** The ticks of a vertical axis. */
export function ticksUp(scale: Scale, length: number, type: number): Tick[] {
  return scale.ticks(Math.max(2, Math.floor(length / (3.2 * type))));
}

/** The width of the labels of a vertical axis. */
export function labelsWidth(ticks: Tick[], type: number): number {
  return widest(ticks, type) + 10;
}

/** Both axes with their grid. Titles name quantity, unit and a logarithmic scale. */
export function axes(
  plot: Plot,
  x: { scale: Scale; ticks: Tick[]; title: string },
  y: { scale: Scale; ticks: Tick[]; title: string },
) {
  const { left, right, bottom, type } = plot;
  return svg`
    <g class="axes" font-size=${type}>
      ${y.ticks.map(
        ({ value, label }) => svg`
        <line class="grid" x1=${left} x2=${right} y1=${y.scale.at(value)} y2=${y.scale.at(value)}></line>
        <text x=${left - 7} y=${y.scale.at(value) + 0.35 * type} text-anchor="end">${label}</text>`,
      )}
      ${x.ticks.map(
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
