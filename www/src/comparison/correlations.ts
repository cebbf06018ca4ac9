// Error over bound, a panel for each model that has a bound (figure 1 of the supplement of Velychko et al. 2017).
import { html, nothing, svg } from "lit";
import { axes, labelsWidth } from "../figures/chart";
import { MARK_SIZE } from "../figures/marks";
import { FigureElement } from "../figures/figure-element";
import { correlationFinding, rankWords } from "./findings";
import { placeLabels, shortenLabels, textWidth } from "../figures/labels";
import { inColour, modelMark, modelStyle } from "../figures/model-style";
import { linearScale, logScale } from "../figures/scale";
import type { Comparison, Correlation } from "../engine/whole-protocol";
import { styled } from "../ui/styled";
import { compareWords } from "./view-words";

const GAP = 28;
const LEAST = 250;

const drawable = ({ points }: Correlation) =>
  points.filter(({ bound, mse }) => Number.isFinite(bound) && mse > 0 && Number.isFinite(mse));

export class CorrelationsFigure extends FigureElement<Comparison> {
  protected readonly words = () => compareWords().correlation;
  protected readonly file = "error-against-bound";

  protected missing({ correlations }: Comparison): string | null {
    return correlations.every((correlation) => drawable(correlation).length === 0)
      ? compareWords().correlation.none
      : null;
  }

  protected table({ correlations }: Comparison) {
    return {
      header: [
        "model",
        "settings",
        "bound (nats)",
        "DTW MSE (squared units of the columns)",
        "rank correlation of the model",
      ],
      rows: correlations.flatMap(({ model, rank, points }) =>
        points.map(({ label, bound, mse }) => [modelStyle(model).name, label, bound, mse, rank]),
      ),
    };
  }

  #panel(correlation: Correlation, width: number) {
    const { model } = correlation;
    const words = compareWords().correlation;
    const points = drawable(correlation);
    const { type } = this;
    const height = Math.round(Math.min(0.72 * width, 250) + 2 * type);
    const [top, bottom, right] = [2.2 * type, height - 3.4 * type, width - 10];
    const y = logScale(
      points.map(({ mse }) => mse),
      bottom,
      top,
    );
    const up = { scale: y, title: words.error };
    const left = labelsWidth(up, { right, top, bottom, type });
    const { short, units, all } = shortenLabels(points.map(({ label }) => label));
    const note = [units && words.labels(units), all && words.allWith(all)].filter(Boolean).join(" ");
    const widths = short.map((label) => textWidth(label, type));
    // The outermost points have short labels at their sides too.
    const x = linearScale(
      points.map(({ bound }) => bound),
      left,
      right - Math.min(Math.max(...widths), 0.25 * width),
    );
    const places = points.map(({ bound, mse }) => ({ x: x.at(bound), y: y.at(mse) }));
    const boxes = placeLabels(places, widths, 1.15 * type, 1.2 * MARK_SIZE * type, {
      x: left,
      y: top,
      width: right - left,
      height: bottom - top,
    });
    return html`
      <div class="panel-figure" style=${inColour(model)}>
        <p><svg class="model-mark" viewBox="0 0 14 14" aria-hidden="true">${modelMark(model, 7, 7, 4.6)}</svg>
          <span class="name">${modelStyle(model).name}</span> <small>${[correlation.label, rankWords(correlation)].filter(Boolean).join(", ")}</small></p>
        <svg class="chart-drawing" width=${width} height=${height} viewBox="0 0 ${width} ${height}" role="img" aria-label=${correlationFinding(correlation)}>
          ${axes({ left, right, top, bottom, type }, { scale: x, title: words.bound }, up)}
          ${places.map((place) => modelMark(model, place.x, place.y, MARK_SIZE * type))}
          ${boxes.map((box, i) => (box ? svg`<text class="label" font-size=${type} x=${box.x + box.width / 2} y=${box.y + 0.93 * type} text-anchor="middle">${short[i]}</text>` : nothing))}
        </svg>
        ${note ? html`<small class="panel-note hint">${note}</small>` : nothing}
      </div>`;
  }

  protected figure({ correlations }: Comparison) {
    const drawn = correlations.filter((correlation) => drawable(correlation).length > 0);
    const columns = Math.max(1, Math.min(3, drawn.length, Math.floor((this.width + GAP) / (LEAST + GAP))));
    const width = Math.floor(Math.min(440, (this.width - (columns - 1) * GAP) / columns));
    return html`
      <div class="panels" style=${styled({ "grid-template-columns": `repeat(${columns}, minmax(0, ${width}px))`, gap: `18px ${GAP}px` })}>
        ${drawn.map((correlation) => this.#panel(correlation, width))}
      </div>
      <figcaption>${compareWords().correlation.caption}</figcaption>`;
  }
}
customElements.define("comparison-correlations", CorrelationsFigure);
