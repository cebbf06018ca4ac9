// The best setting of each model, and the probability that one is better than another (figure 8 of Knopp et
// al. 2019).
import { html, svg } from "lit";
import type { PerceptionResults } from "../engine/whole-protocol";
import { FigureElement } from "../figures/figure-element";
import { inColour, modelMark, modelStyle } from "../figures/model-style";
import "../terms/term";
import { fixed, localNumber } from "../ui/format";
import { styled } from "../ui/styled";
import { perceptionWords } from "./view-words";
import { RATE_TITLES, rateFields } from "./answered-settings";

const two = (value: number) => fixed(value, 2);

/** Only an exact 0 or 1 is written as 0 or 1. */
function probability(value: number): string {
  if (value > 0 && value < 0.005) return localNumber("< 0.01");
  return value < 1 && value >= 0.995 ? localNumber("> 0.99") : two(value);
}

export class PairwiseFigure extends FigureElement<PerceptionResults> {
  protected readonly words = () => perceptionWords().figures.pairwise;
  protected readonly file = "best-of-each-model";

  protected missing({ best }: PerceptionResults): string | null {
    return best.length === 0 ? perceptionWords().figures.needsModel : null;
  }

  protected table({ best, pairs }: PerceptionResults) {
    const names = best.map(({ model }) => modelStyle(model).name);
    return {
      header: [
        "model",
        "settings",
        ...RATE_TITLES,
        "P(rate > 0.5)",
        ...names.map((name) => `P(rate > that of ${name})`),
      ],
      rows: best.map(({ label, confusion }, i) => [
        ...[names[i] ?? "", label, ...rateFields(confusion), confusion.aboveHalf],
        ...best.map((_, j) => (i === j ? null : (pairs[i]?.[j] ?? null))),
      ]),
    };
  }

  #row({ best, pairs }: PerceptionResults, i: number) {
    const setting = best[i];
    if (!setting) return html``;
    const { model, label, confusion } = setting;
    const { hits, trials, mean, deviation, aboveHalf } = confusion;
    return html`
      <tr style=${inColour(model)}>
        <th scope="row" class="who"><div><svg class="model-mark" viewBox="0 0 14 14" aria-hidden="true">${modelMark(model, 7, 7, 4.6)}</svg>
          <span class="name">${modelStyle(model).name}</span><small>${label}</small></div></th>
        <td>${two(mean)} <small>± ${two(deviation)}</small><small class="own-line">${perceptionWords().analysis.of(hits, trials)}</small></td>
        <td>${probability(aboveHalf)}</td>
        ${best.map((_, j) => {
          const value = pairs[i]?.[j];
          if (i === j || value === undefined) return html`<td class="pair self">–</td>`;
          return html`<td class="pair" style=${styled({ "--strength": `${Math.round(100 * value)}%` })}>${probability(value)}</td>`;
        })}
      </tr>`;
  }

  protected figure(results: PerceptionResults) {
    const { best, orders } = results;
    const [likeliest] = orders;
    const words = perceptionWords().figures.pairwise;
    const order = likeliest?.models.map((model) => modelStyle(model).name).join(" > ") ?? "";
    return html`
      <div class="figure-scroll" tabindex="0" role="region" aria-label=${this.heading}>
        <table class="pairwise tabular">
          <thead class="hint"><tr>
            <th scope="col">${words.model}</th><th scope="col"><pg-term of="confusion-rate" text=${words.rate}></pg-term></th><th scope="col">${words.aboveHalf}</th>
            ${best.map(
              ({ model }) => html`
            <th scope="col" class="pair" style=${inColour(model)}><small class="own-line">${words.betterThan}</small> <span class="name">${svgMark(model)} ${modelStyle(model).name}</span></th>`,
            )}
          </tr></thead>
          <tbody>${best.map((_, i) => this.#row(results, i))}</tbody>
        </table>
      </div>
      <figcaption>${words.caption} ${likeliest ? words.order(probability(likeliest.probability), order) : ""}</figcaption>`;
  }
}

const svgMark = (model: Parameters<typeof modelMark>[0]) =>
  html`<svg class="model-mark" viewBox="0 0 14 14" aria-hidden="true">${svg`${modelMark(model, 7, 7, 4.6)}`}</svg>`;

customElements.define("perception-pairwise", PairwiseFigure);
