// A small chart: the bound that is lost and the error of the walk for each number of points.
import { svg, html, type TemplateResult } from "lit";
import type { Trial } from "./trial";

const WIDTH = 420;
const HEIGHT = 84;
const EDGE = 6;

/** The labels of the two lines. */
export interface ChartWords {
  bound: string;
  error: string;
  label: string;
}

export function pointsChart(trials: readonly Trial[], now: Trial, words: ChartWords): TemplateResult {
  const most = trials[0]?.count ?? now.count;
  const finite = trials.filter(({ error }) => Number.isFinite(error));
  const worst = Math.max(0.01, ...finite.map(({ error }) => error));
  const bounds = trials.map(({ bound }) => bound);
  const [low, high] = [Math.min(...bounds, now.bound), Math.max(...bounds, now.bound)];
  const x = (count: number) => EDGE + ((most - count) / Math.max(1, most - 2)) * (WIDTH - 2 * EDGE);
  const y = (share: number) => HEIGHT - EDGE - share * (HEIGHT - 2 * EDGE);
  const error = (trial: Trial) =>
    y(Math.min(1, (Number.isFinite(trial.error) ? trial.error : worst) / worst));
  const bound = (trial: Trial) => y((trial.bound - low) / Math.max(1e-9, high - low));
  const line = (height: (trial: Trial) => number) =>
    trials.map((trial) => `${x(trial.count).toFixed(1)},${height(trial).toFixed(1)}`).join(" ");
  const marks = trials
    .filter((trial) => trial.stumbles)
    .map((trial) => svg`<circle class="stumble" cx=${x(trial.count)} cy=${error(trial)} r="3.2" />`);
  return html`
    <figure class="points-chart">
      <svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label=${words.label}>
        <polyline class="bound" points=${line(bound)} />
        <polyline class="error" points=${line(error)} />
        ${marks}
        <line class="now" x1=${x(now.count)} x2=${x(now.count)} y1="0" y2=${HEIGHT} />
      </svg>
      <figcaption><span class="bound">${words.bound}</span> <span class="error">${words.error}</span></figcaption>
    </figure>`;
}
