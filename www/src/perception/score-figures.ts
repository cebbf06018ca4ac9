// Confusion rate over each score with the fitted curve (figures 5 and 6 of Knopp et al. 2019), and of all
// models together (figure 7).
import { html } from "lit";
import type { ModelKind, Regression, PerceptionResults } from "../engine/whole-protocol";
import { withTerms } from "../terms/term";
import { FigureElement } from "../figures/figure-element";
import { modelMark, modelStyle, inColour } from "../figures/model-style";
import {
  type Answered,
  answeredSettings,
  curveOf,
  evidenceWords,
  MSE_TITLE,
  measureOf,
  RATE_TITLES,
  rateBar,
  rateFields,
  rateMeasure,
  regressionOf,
  type Score,
  SCORES,
  scoreOf,
} from "./answered-settings";
import { perceptionWords } from "./view-words";
import { type Panel, type PanelPoint, panels } from "./panel";

const pointsOf = (settings: readonly Answered[], score: Score): PanelPoint[] =>
  settings.flatMap((setting) => {
    const x = scoreOf(setting, score);
    return x === null ? [] : [{ model: setting.model, x, ...rateBar(setting.confusion) }];
  });

const linesOf = (regression: Regression | null, model: ModelKind | null) =>
  regression ? [{ model, places: curveOf(regression) }] : [];

function panelOf(results: PerceptionResults, model: ModelKind, score: Score): Panel | null {
  const points = pointsOf(
    answeredSettings(results).filter((setting) => setting.model === model),
    score,
  );
  if (points.length === 0) return null;
  const regression = regressionOf(results, model, score);
  const words = perceptionWords().figures;
  const { [score]: measure, rate } = words.measures;
  const { name } = modelStyle(model);
  const evidence = regression ? evidenceWords(regression) : words.tooFew;
  return {
    heading: html`<span class="name">${name}</span> <small>${measure.name}, <b data-testid="ln-k">${evidence}</b></small>`,
    words: `${name}: ${words.settings(words.over(rate.name, measure.name), points.length)}, ${evidence}`,
    x: { title: measure.axis, kind: "linear", reach: [] },
    y: rateMeasure().axis,
    points,
    lines: linesOf(regression, model),
    references: [0.5],
  };
}

const modelsOf = (settings: readonly Answered[]): ModelKind[] => [
  ...new Set(settings.map(({ model }) => model)),
];

const missingIn = (results: PerceptionResults) =>
  answeredSettings(results).length === 0 ? perceptionWords().figures.needsModel : null;

export class ScoresFigure extends FigureElement<PerceptionResults> {
  protected readonly words = () => perceptionWords().figures.scores;
  protected readonly file = "confusion-over-scores";

  protected missing(results: PerceptionResults): string | null {
    return missingIn(results);
  }

  protected table(results: PerceptionResults) {
    return {
      header: [
        ...["model", "settings", "score", "value", ...RATE_TITLES, "w0", "w1"],
        ...["ln K", "standard error of ln K", "ln K of the data"],
      ],
      rows: answeredSettings(results).flatMap((setting) =>
        SCORES.flatMap(({ score, name }) => {
          const { model, label, confusion } = setting;
          const fit = regressionOf(results, model, score);
          const value = scoreOf(setting, score);
          if (value === null) return [];
          const factors = [fit?.logBayesFactor, fit?.logBayesFactorError, fit?.dataLogBayesFactor];
          const fitted = [fit?.weights[0], fit?.weights[1], ...factors].map((value) => value ?? null);
          return [[modelStyle(model).name, label, name, value, ...rateFields(confusion), ...fitted]];
        }),
      ),
    };
  }

  protected figure(results: PerceptionResults) {
    const all = modelsOf(answeredSettings(results)).flatMap((model) =>
      SCORES.flatMap(({ score }) => panelOf(results, model, score) ?? []),
    );
    return html`
      ${panels(all, this.width, this.type, 4)}
      <figcaption>${withTerms(perceptionWords().figures.scores.caption)}</figcaption>`;
  }
}
customElements.define("perception-scores", ScoresFigure);

export class AllModelsFigure extends FigureElement<PerceptionResults> {
  protected readonly words = () => perceptionWords().figures.all;
  protected readonly file = "confusion-of-all-models";

  protected missing(results: PerceptionResults): string | null {
    return missingIn(results);
  }

  protected table(results: PerceptionResults) {
    return {
      header: ["model", "settings", MSE_TITLE, ...RATE_TITLES],
      rows: answeredSettings(results).map(({ model, label, scores, confusion }) => [
        ...[modelStyle(model).name, label, scores.mse, ...rateFields(confusion)],
      ]),
    };
  }

  protected figure(results: PerceptionResults) {
    const settings = answeredSettings(results);
    const points = settings.map(({ model, scores, confusion }) => ({
      model,
      x: scores.mse,
      ...rateBar(confusion),
    }));
    const regression = regressionOf(results, null, "mse");
    const names = modelsOf(settings);
    const words = perceptionWords().figures;
    const panel: Panel = {
      heading: html`<small>${words.all.title}${regression ? html`, <b>${evidenceWords(regression)}</b>` : ""}</small>`,
      words: words.all.label(points.length, names.length),
      x: measureOf("mse").axis,
      y: rateMeasure().axis,
      points,
      lines: linesOf(regression, null),
      references: [0.5],
    };
    return html`
      <div class="with-key row wrap">
        ${panels([panel], Math.min(this.width, 640), this.type, 1)}
        <ul class="model-key stack">${names.map(
          (model) =>
            html`<li class="row" style=${inColour(model)}><svg class="model-mark" viewBox="0 0 14 14" aria-hidden="true">${modelMark(model, 7, 7, 4.6)}</svg> ${modelStyle(model).name}</li>`,
        )}</ul>
      </div>
      <figcaption>${words.bars} ${words.all.caption}</figcaption>`;
  }
}
customElements.define("perception-all-models", AllModelsFigure);
