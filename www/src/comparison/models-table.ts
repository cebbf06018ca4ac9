// Error, bound, time and size of each model: figure 4 of Velychko et al. 2018 as a table, with a dot and its
// error bar for each number.
import { html, nothing, svg } from "lit";
import { withTerms } from "../terms/term";
import { errorBar } from "../figures/chart";
import { MARK_SIZE } from "../figures/marks";
import { FigureElement } from "../figures/figure-element";
import { errorFinding, foldWords } from "./findings";
import { bestOf, ends, isSkewed, type Measure, MEASURES, scaleOf } from "./measures";
import { inColour, modelMark, modelStyle } from "../figures/model-style";
import { plain, estimateText } from "../figures/numbers";
import type { Scale } from "../figures/scale";
import { textWidth } from "../figures/labels";
import type { Comparison, ModelSummary, Spread } from "../engine/whole-protocol";
import { compareWords } from "./view-words";

/** The size of the drawing in a cell, in pixels; the page may widen it. */
const NARROWEST = 112;
const WIDEST = 230;
/** The height, the width of the first column and the gap between columns, in em. */
const HEIGHT = 1.5;
const NAMES = 15;
const BETWEEN = 1.8;

/** The most ticks whose labels do not overlap; labels at the ends of the drawing move inwards. */
function ticksOf(scale: Scale, width: number, type: number) {
  for (let most = 5; most > 1; most--) {
    const ticks = scale.ticks(most).map(({ value, label }) => {
      const half = textWidth(label, type) / 2;
      const x = scale.at(value);
      return { x, label, half, text: Math.min(Math.max(x, half), width - half) };
    });
    const apart = ticks.every(({ text, half }, i) => {
      const before = ticks[i - 1];
      return !before || text - half >= before.text + before.half + 5;
    });
    if (apart) return ticks;
  }
  return [];
}

/** For models of which some trainings used all their iterations. */
const convergedWords = ({ converged }: ModelSummary) =>
  converged !== null && converged < 1 ? compareWords().table.converged(Math.round(100 * converged)) : "";

/** For a size that represents other sizes. */
const ofWords = ({ standsFor }: ModelSummary) =>
  standsFor > 1 ? compareWords().table.standsFor(standsFor) : "";

/** The error of each part, for several parts. */
const ofParts = ({ partErrors }: ModelSummary, parts: readonly string[]) =>
  parts.length > 1 && partErrors.length === parts.length
    ? html`<small class="of-parts">${parts.map((part, k) => `${part}\u00a0${plain(partErrors[k] ?? 0)}`).join(", ")}</small>`
    : nothing;

interface Drawn extends Measure {
  drawing: Scale;
  width: number;
  ticks: ReturnType<typeof ticksOf>;
  winner: number | null;
}

/** Above this number one size of each model represents the others, until the visitor asks for all. */
const MOST = 12;

export class ModelsTable extends FigureElement<Comparison> {
  static override properties = { ...FigureElement.properties, all: { state: true } };
  /** Whether all sizes of a model are shown. */
  all = false;

  protected readonly words = () => compareWords().table;
  protected readonly file = "models-compared";

  protected missing({ models }: Comparison): string | null {
    return models.length === 0 ? compareWords().table.none : null;
  }

  protected table({ models, parts: names }: Comparison) {
    const spread = (name: string, unit: string) => [
      `${name} mean (${unit})`,
      `${name} standard error (${unit})`,
      `${name} count`,
    ];
    const parts = Array.from({ length: Math.max(0, ...models.map((m) => m.partErrors.length)) }, (_, k) => k);
    const fields = (value: Spread | null) =>
      value ? [value.mean, value.standardError, value.count] : [null, null, null];
    return {
      header: [
        "model",
        "settings",
        ...spread("DTW MSE", "squared units of the columns"),
        "DTW MSE median (squared units of the columns)",
        "MSE of a prediction that does not move (squared units of the columns)",
        ...spread("bound", "nats"),
        ...spread("training", "s"),
        ...spread("numbers stored", "numbers"),
        "trainings that converged (share)",
        "pose terms of the bound (nats)",
        "other terms of the bound (nats)",
        ...parts.map(
          (part) => `DTW MSE of ${names[part] ?? `part ${part + 1}`} (squared units of the columns)`,
        ),
        "folds",
        "runs",
      ],
      rows: models.map((m) => [
        modelStyle(m.model).name,
        m.label,
        ...fields(m.mse),
        m.mseMedian,
        m.variance,
        ...fields(m.bound),
        ...fields(m.seconds),
        ...fields(m.storedNumbers),
        m.converged,
        m.terms?.pose ?? null,
        m.terms?.dynamics ?? null,
        ...parts.map((part) => m.partErrors[part] ?? null),
        m.folds,
        m.runs,
      ]),
    };
  }

  /** The font size of the axes. */
  get #small(): number {
    return 0.86 * this.type;
  }

  #axis({ name, ticks, width }: Drawn) {
    const { title, unit } = compareWords().table.measures[name];
    const height = HEIGHT * this.type;
    return html`
      <th scope="col"><div class="measure">
        <span class="number">${title}<small>${unit}</small></span>
        <svg class="dot-plot" width=${width} height=${height} viewBox="0 0 ${width} ${height}" aria-hidden="true">
          <g class="axes" font-size=${this.#small}>${ticks.map(
            ({ x, text, label }) => svg`
            <line class="axis" x1=${x} x2=${x} y1=${height - 4} y2=${height}></line>
            <text x=${text} y=${height - 6} text-anchor="middle">${label}</text>`,
          )}</g>
        </svg></div></th>`;
  }

  #cell(
    summary: ModelSummary,
    parts: readonly string[],
    { name, drawing, width, ticks, winner, ...measure }: Drawn,
  ) {
    const spread = measure.spread(summary);
    const words = compareWords().table;
    const isError = name === "error";
    if (!spread)
      return html`<td><div class="measure"><span class="number quiet">${words.noValue}</span></div></td>`;
    const { mean, error } = estimateText(spread);
    const best = winner !== null && spread.mean === winner;
    const [low, high] = ends(spread);
    const height = HEIGHT * this.type;
    const y = height / 2;
    const still = drawing.at(summary.variance);
    return html`
      <td class=${best ? "best" : ""}><div class="measure">
        <span class="number"><span>${mean} <small>${error}</small></span>${best ? html`<em>${words.measures[name].best}</em>` : nothing}
          ${isError ? ofParts(summary, parts) : nothing}
          ${isError && isSkewed(summary) ? html`<small>${words.median(plain(summary.mseMedian))}</small>` : nothing}</span>
        <svg class="dot-plot" width=${width} height=${height} viewBox="0 0 ${width} ${height}" aria-hidden="true">
          ${ticks.map(({ x }) => svg`<line class="grid" x1=${x} x2=${x} y1="0" y2=${height}></line>`)}
          ${isError ? svg`<line class="reference" x1=${still} x2=${still} y1="0" y2=${height}></line>` : nothing}
          ${Number.isFinite(spread.mean) ? svg`${errorBar(drawing.at(low), drawing.at(high), y, 3)}${modelMark(summary.model, drawing.at(spread.mean), y, 0.88 * MARK_SIZE * this.type)}` : nothing}
        </svg></div></td>`;
  }

  protected figure({ models: every, parts }: Comparison) {
    const shown = every.filter((summary) => summary.standsFor > 0);
    const shorter = every.length > MOST && shown.length < every.length;
    const models = shorter && !this.all ? shown : every;
    const words = compareWords().table;
    const space = (this.width - NAMES * this.type) / MEASURES.length - BETWEEN * this.type;
    const width = Math.round(Math.min(WIDEST, Math.max(NARROWEST, space)));
    const measures: Drawn[] = MEASURES.map((measure) => {
      const drawing = scaleOf(measure, models, width);
      return {
        ...measure,
        drawing,
        width,
        ticks: ticksOf(drawing, width, this.#small),
        winner: bestOf(measure, models),
      };
    });
    return html`
      <p data-testid="error-finding">${errorFinding(models)}</p>
      <div class="figure-scroll" tabindex="0" role="region" aria-label=${this.heading}>
        <table class="models-table tabular">
          <thead><tr><th scope="col" class="who">${words.model}</th>${measures.map((measure) => this.#axis(measure))}</tr></thead>
          <tbody>${models.map((summary, i) => {
            const { model, label } = summary;
            return html`
              <tr style=${inColour(model)} class=${i > 0 && models[i - 1]?.model !== model ? "next-model" : ""}>
                <th scope="row" class="who"><div>
                  <svg class="model-mark" viewBox="0 0 14 14" aria-hidden="true">${modelMark(model, 7, 7, 4.6)}</svg>
                  <span class="name">${modelStyle(model).name}</span><small>${label}${models === shown ? ofWords(summary) : ""}${convergedWords(summary)}</small></div></th>
                ${measures.map((measure) => this.#cell(summary, parts, measure))}
              </tr>`;
          })}</tbody>
        </table>
      </div>
      ${
        shorter
          ? html`<p class="more" data-not-in-picture><button class="small" @click=${() => (this.all = !this.all)}>
            ${this.all ? words.oneSize : words.all(every.length)}</button></p>`
          : nothing
      }
      <figcaption>
        ${models === shown ? words.representatives : nothing}
        ${foldWords(models)} ${withTerms(words.caption)}
      </figcaption>`;
  }
}
customElements.define("comparison-models", ModelsTable);
