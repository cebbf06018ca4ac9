// Confusion rate over numbers of inducing points, as a map (figures 3 and 4 of Knopp et al. 2019).
import { html, nothing, svg } from "lit";
import type { PerceptionResults, SettingResult } from "../engine/whole-protocol";
import { FigureElement } from "../figures/figure-element";
import { modelStyle } from "../figures/model-style";
import { textWidth } from "../figures/labels";
import { fixed } from "../ui/format";
import { styled } from "../ui/styled";
import { perceptionWords } from "./view-words";
import { MSE_TITLE, RATE_TITLES, rateFields } from "./answered-settings";
import { type Grid, gridsOf } from "./grids";

/** The side of a tile, in em. */
const TILE = 3.4;
/** The rate with the strongest colour. */
const HIGHEST = 0.6;

function tile(setting: SettingResult, x: number, y: number, side: number, type: number) {
  const { scores, confusion } = setting;
  const failed = scores === null;
  const strength = Math.min(1, (confusion?.mean ?? 0) / HIGHEST);
  const words = failed ? perceptionWords().figures.maps.failed : confusion ? fixed(confusion.mean, 2) : "";
  return svg`
    <g class=${failed ? "failed" : ""}>
      <rect x=${x + 1} y=${y + 1} width=${side - 2} height=${side - 2} rx="3" style=${styled({ "--strength": `${Math.round(100 * strength)}%` })}></rect>
      <text x=${x + side / 2} y=${y + side / 2 + 0.35 * type} text-anchor="middle" font-size=${failed ? 0.8 * type : type}>${words}</text>
    </g>`;
}

function map({ model, pose, dynamics, at }: Grid, type: number) {
  const side = TILE * type;
  const left = 2.6 * type;
  const words = perceptionWords().figures;
  const width = Math.max(left + pose.length * side + 8, textWidth(words.dynamics, type) + 4);
  const height = dynamics.length * side + 5.2 * type;
  const top = 1.8 * type;
  const { name } = modelStyle(model);
  return html`
    <div class="panel-figure">
      <p><span class="name">${name}</span></p>
      <svg class="chart-drawing heat-map" width=${width} height=${height} viewBox="0 0 ${width} ${height}" role="img" aria-label=${words.maps.label(name)}>
        <g class="axes" font-size=${type}>
          <text x="0" y=${type}>${words.dynamics}</text>
          ${dynamics.map((count, row) => svg`<text x=${left - 6} y=${top + (dynamics.length - row - 0.5) * side + 0.35 * type} text-anchor="end">${count}</text>`)}
          ${pose.map((count, column) => svg`<text x=${left + (column + 0.5) * side} y=${top + dynamics.length * side + 1.2 * type} text-anchor="middle">${count}</text>`)}
          <text x=${left + pose.length * side} y=${top + dynamics.length * side + 2.7 * type} text-anchor="end">${words.poses}</text>
        </g>
        ${dynamics.flatMap((row, j) =>
          pose.map((column, i) => {
            const setting = at(column, row);
            return setting
              ? tile(setting, left + i * side, top + (dynamics.length - 1 - j) * side, side, type)
              : nothing;
          }),
        )}
      </svg>
    </div>`;
}

export class HeatMapsFigure extends FigureElement<PerceptionResults> {
  protected readonly words = () => perceptionWords().figures.maps;
  protected readonly file = "confusion-over-inducing-points";

  protected missing({ settings }: PerceptionResults): string | null {
    return gridsOf(settings).length === 0 ? perceptionWords().figures.needsPoints : null;
  }

  protected table({ settings }: PerceptionResults) {
    return {
      header: [
        "model",
        "pose inducing points",
        "dynamics inducing points",
        "failed",
        ...RATE_TITLES,
        MSE_TITLE,
      ],
      rows: gridsOf(settings).flatMap(({ model, pose, dynamics, at }) =>
        dynamics.flatMap((row) =>
          pose.flatMap((column) => {
            const setting = at(column, row);
            if (!setting) return [];
            const { scores, confusion } = setting;
            const rate = confusion ? rateFields(confusion) : RATE_TITLES.map(() => null);
            return [
              [modelStyle(model).name, column, row, scores ? "no" : "yes", ...rate, scores?.mse ?? null],
            ];
          }),
        ),
      ),
    };
  }

  protected figure({ settings }: PerceptionResults) {
    return html`
      <div class="figure-scroll maps" tabindex="0" role="region" aria-label=${this.heading}>${gridsOf(settings).map((grid) => map(grid, this.type))}</div>
      <figcaption>${perceptionWords().figures.maps.caption}</figcaption>`;
  }
}
customElements.define("perception-maps", HeatMapsFigure);
