// Figure 4 of Velychko et al. 2018 as a table: error, bound, time and size of each model, with a dot and its error bar for each number.
import { html, nothing, svg } from "lit";
import { errorBar, inColour, mark } from "./chart";
import { ComparisonFigure } from "./comparison-figure";
import { textWidth } from "./labels";
import { modelStyle } from "./model-style";
import { spreadWords } from "./numbers";
import { linearScale, logScale, type Scale } from "./scale";
import type { Comparison, ModelSummary, Spread } from "./types";

/** The drawing in a cell, pixels; as wide as the page lets it. */
const NARROWEST = 112;
const WIDEST = 230;
const HEIGHT = 18;
/** So that marks at the ends of a scale are whole. */
const EDGE = 6;
/** Of the first column and the room between columns, in the type's size. */
const NAMES = 15;
const BETWEEN = 1.8;

interface Measure {
  title: string;
  unit: string;
  of(summary: ModelSummary): Spread | null;
  scale: "linear" | "log";
  best: "least" | "greatest";
  /** What the best is called. */
  word: string;
}

const MEASURES: Measure[] = [
  { title: "Error", unit: "DTW MSE", of: ({ mse }) => mse, scale: "log", best: "least", word: "best" },
  { title: "Bound", unit: "nats", of: ({ bound }) => bound, scale: "linear", best: "greatest", word: "highest" },
  { title: "Training", unit: "seconds", of: ({ seconds }) => seconds, scale: "log", best: "least", word: "quickest" },
  { title: "Size", unit: "numbers stored", of: ({ storedNumbers }) => storedNumbers, scale: "log", best: "least", word: "fewest" },
];

/** The ends of an error bar. */
function ends({ mean, standardError }: Spread): [number, number] {
  const error = standardError ?? 0;
  return [mean - error, mean + error];
}

function scaleOf(measure: Measure, models: readonly ModelSummary[], width: number): Scale {
  const values = models.flatMap((summary) => {
    const spread = measure.of(summary);
    const reference = measure.unit === "DTW MSE" ? [summary.variance] : [];
    return spread ? [spread.mean, ...ends(spread), ...reference] : [];
  });
  return (measure.scale === "log" ? logScale : linearScale)(values, EDGE, width - EDGE);
}

/** The best mean; null where fewer than two can be compared. */
function bestOf(measure: Measure, models: readonly ModelSummary[]): number | null {
  const means = models.map((summary) => measure.of(summary)?.mean).filter((mean) => mean !== undefined && Number.isFinite(mean)) as number[];
  if (means.length < 2) return null;
  return measure.best === "least" ? Math.min(...means) : Math.max(...means);
}

/** The most ticks whose labels stand beside each other; at the ends of the drawing they are moved inwards. */
function ticksOf(scale: Scale, width: number, type: number) {
  for (let most = 5; most > 1; most--) {
    const ticks = scale.ticks(most).map(({ value, label }) => {
      const half = textWidth(label, type) / 2;
      const x = scale.at(value);
      return { x, label, half, text: Math.min(Math.max(x, half), width - half) };
    });
    if (ticks.every(({ text, half }, i) => i === 0 || text - half >= ticks[i - 1]!.text + ticks[i - 1]!.half + 5)) return ticks;
  }
  return [];
}

interface Drawn extends Measure {
  drawing: Scale;
  width: number;
  ticks: ReturnType<typeof ticksOf>;
  winner: number | null;
}

/** Over what the means are taken. */
export function foldWords(models: readonly ModelSummary[]): string {
  const folds = models.map((summary) => summary.folds);
  const [least, most] = [Math.min(...folds), Math.max(...folds)];
  if (most === 1) return "One trial was held out and predicted; how it would be with others is not known yet.";
  return `Mean ± standard error over ${least === most ? most : `${least} to ${most}`} trials, each held out in turn and predicted; the bars are the standard errors.`;
}

export class ModelsTable extends ComparisonFigure {
  protected readonly heading = "Error, bound, time and size of each model";
  protected readonly file = "models-compared";

  protected missing({ models }: Comparison): string | null {
    return models.length === 0 ? "No model has been trained and scored yet." : null;
  }

  protected table({ models }: Comparison) {
    const spread = (name: string, unit: string) => [`${name} mean (${unit})`, `${name} standard error (${unit})`, `${name} count`];
    const fields = (of: Spread | null) => (of ? [of.mean, of.standardError, of.count] : [null, null, null]);
    return {
      header: [
        "model", "settings", ...spread("DTW MSE", "squared units of the columns"), "MSE of a prediction that does not move (squared units of the columns)",
        ...spread("bound", "nats"), ...spread("training", "s"), ...spread("numbers stored", "numbers"), "folds", "runs",
      ],
      rows: models.map((m) => [
        modelStyle(m.model).name, m.label, ...fields(m.mse), m.variance, ...fields(m.bound), ...fields(m.seconds), ...fields(m.storedNumbers), m.folds, m.runs,
      ]),
    };
  }

  /** The size of the axes' type. */
  private get small(): number {
    return 0.86 * this.type;
  }

  private axis({ title, unit, ticks, width }: Drawn) {
    return html`
      <th scope="col"><div class="measure">
        <span class="number">${title}<small>${unit}</small></span>
        <svg class="dot-plot" width=${width} height=${HEIGHT} aria-hidden="true">
          <g class="axes" font-size=${this.small}>${ticks.map(({ x, text, label }) => svg`
            <line class="axis" x1=${x} x2=${x} y1=${HEIGHT - 4} y2=${HEIGHT}></line>
            <text x=${text} y=${HEIGHT - 6} text-anchor="middle">${label}</text>`)}</g>
        </svg></div></th>`;
  }

  private cell(summary: ModelSummary, { of, unit, word, drawing, width, ticks, winner }: Drawn) {
    const spread = of(summary);
    if (!spread) return html`<td><div class="measure"><span class="number none">none</span></div></td>`;
    const { mean, error } = spreadWords(spread);
    const best = winner !== null && spread.mean === winner;
    const [low, high] = ends(spread);
    const y = HEIGHT / 2;
    const still = drawing.at(summary.variance);
    return html`
      <td class=${best ? "best" : ""}><div class="measure">
        <span class="number"><span>${mean} <small>${error}</small></span>${best ? html`<em>${word}</em>` : nothing}</span>
        <svg class="dot-plot" width=${width} height=${HEIGHT} aria-hidden="true">
          ${ticks.map(({ x }) => svg`<line class="grid" x1=${x} x2=${x} y1="0" y2=${HEIGHT}></line>`)}
          ${unit === "DTW MSE" ? svg`<line class="reference" x1=${still} x2=${still} y1="0" y2=${HEIGHT}></line>` : nothing}
          ${Number.isFinite(spread.mean) ? svg`${errorBar(drawing.at(low), drawing.at(high), y, 3)}${mark(summary.model, drawing.at(spread.mean), y, 4)}` : nothing}
        </svg></div></td>`;
  }

  protected figure({ models }: Comparison) {
    const room = (this.width - NAMES * this.type) / MEASURES.length - BETWEEN * this.type;
    const width = Math.round(Math.min(WIDEST, Math.max(NARROWEST, room)));
    const measures: Drawn[] = MEASURES.map((measure) => {
      const drawing = scaleOf(measure, models, width);
      return { ...measure, drawing, width, ticks: ticksOf(drawing, width, this.small), winner: bestOf(measure, models) };
    });
    return html`
      <div class="figure-scroll" tabindex="0" role="region" aria-label=${this.heading}>
        <table class="models-table">
          <thead><tr><th scope="col" class="who">Model and settings</th>${measures.map((measure) => this.axis(measure))}</tr></thead>
          <tbody>${models.map((summary, i) => {
            const { model, label } = summary;
            return html`
              <tr style=${inColour(model)} class=${i > 0 && models[i - 1]!.model !== model ? "next-model" : ""}>
                <th scope="row" class="who"><div>
                  <svg class="model-mark" viewBox="0 0 14 14" aria-hidden="true">${mark(model, 7, 7, 4.6)}</svg>
                  <span class="name">${modelStyle(model).name}</span><small>${label}</small></div></th>
                ${measures.map((measure) => this.cell(summary, measure))}
              </tr>`;
          })}</tbody>
        </table>
      </div>
      <figcaption>
        ${foldWords(models)} Error, time and size are drawn on log scales. The dashed line is the error of a prediction that does not move.
      </figcaption>`;
  }
}
customElements.define("comparison-models", ModelsTable);
