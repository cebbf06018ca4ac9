// Confusion rate over each score with the fitted curve (figures 5 and 6 of Knopp et al. 2019), and of all
// models together (figure 7).
import { html } from "lit";
import type { ModelKind, Regression, PerceptionResults } from "../engine/whole-protocol";
import "../terms/term";
import { FigureElement } from "../figures/figure-element";
import { modelMark, modelStyle, inColour } from "../figures/model-style";
import {
  type Answered,
  answeredSettings,
  curveOf,
  evidenceWords,
  MSE_TITLE,
  RATE_TITLES,
  rateBar,
  rateFields,
  regressionOf,
  SCORES,
} from "./answered-settings";
import { type Panel, type PanelPoint, panels } from "./panel";

type Drawn = (typeof SCORES)[number];

const pointsOf = (settings: readonly Answered[], { score }: Drawn): PanelPoint[] =>
  settings.flatMap(({ model, scores, confusion }) => {
    const x = scores[score];
    return x === null ? [] : [{ model, x, ...rateBar(confusion) }];
  });

const linesOf = (regression: Regression | null, model: ModelKind | null) =>
  regression ? [{ model, places: curveOf(regression) }] : [];

const AXIS = { title: "Confusion rate", kind: "linear", reach: [0, 0.5] } as const;

function panelOf(results: PerceptionResults, model: ModelKind, score: Drawn): Panel | null {
  const points = pointsOf(
    answeredSettings(results).filter((setting) => setting.model === model),
    score,
  );
  if (points.length === 0) return null;
  const regression = regressionOf(results, model, score.score);
  const { name } = modelStyle(model);
  const evidence = regression ? evidenceWords(regression) : "too few settings";
  return {
    heading: html`<span class="name">${name}</span> <small>${score.name}, <b data-testid="ln-k">${evidence}</b></small>`,
    words: `${name}: confusion rate over ${score.name}, ${points.length} settings, ${evidence}`,
    x: { title: score.axis, kind: "linear", reach: [] },
    y: AXIS,
    points,
    lines: linesOf(regression, model),
    references: [0.5],
  };
}

const modelsOf = (settings: readonly Answered[]): ModelKind[] => [
  ...new Set(settings.map(({ model }) => model)),
];

const missingIn = (results: PerceptionResults) =>
  answeredSettings(results).length === 0 ? "Needs answers about a model’s movements." : null;

export class ScoresFigure extends FigureElement<PerceptionResults> {
  protected readonly heading = "Confusion rate over each score";
  protected readonly file = "confusion-over-scores";

  protected missing(results: PerceptionResults): string | null {
    return missingIn(results);
  }

  protected table(results: PerceptionResults) {
    return {
      header: [
        "model",
        "settings",
        "score",
        "value",
        ...RATE_TITLES,
        "w0",
        "w1",
        "ln K",
        "standard error of ln K",
      ],
      rows: answeredSettings(results).flatMap(({ model, label, scores, confusion }) =>
        SCORES.flatMap(({ score, name }) => {
          const { weights, logBayesFactor, logBayesFactorError } = regressionOf(results, model, score) ?? {};
          const [w0, w1] = weights ?? [];
          const value = scores[score];
          if (value === null) return [];
          const fit = [w0, w1, logBayesFactor, logBayesFactorError].map((value) => value ?? null);
          return [[modelStyle(model).name, label, name, value, ...rateFields(confusion), ...fit]];
        }),
      ),
    };
  }

  protected figure(results: PerceptionResults) {
    const all = modelsOf(answeredSettings(results)).flatMap((model) =>
      SCORES.flatMap((score) => panelOf(results, model, score) ?? []),
    );
    return html`
      ${panels(all, this.width, this.type, 4)}
      <figcaption>Curves: logistic regression with a ceiling of one half. <pg-term of="ln-k" text="ln K"></pg-term> compares it with the best constant, each tried on answers that it was not fitted to: above 0 the score says something about
        what people see.</figcaption>`;
  }
}
customElements.define("perception-scores", ScoresFigure);

export class AllModelsFigure extends FigureElement<PerceptionResults> {
  protected readonly heading = "All models over the test error";
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
    const panel: Panel = {
      heading: html`<small>All models${regression ? html`, <b>${evidenceWords(regression)}</b>` : ""}</small>`,
      words: `Confusion rate over test MSE of ${points.length} settings of ${names.length} models`,
      x: { title: "Test MSE, log scale", kind: "log", reach: [] },
      y: AXIS,
      points,
      lines: linesOf(regression, null),
      references: [0.5],
    };
    return html`
      <div class="with-key">
        ${panels([panel], Math.min(this.width, 640), this.type, 1)}
        <ul class="model-key">${names.map(
          (model) =>
            html`<li style=${inColour(model)}><svg class="model-mark" viewBox="0 0 14 14" aria-hidden="true">${modelMark(model, 7, 7, 4.6)}</svg> ${modelStyle(model).name}</li>`,
        )}</ul>
      </div>
      <figcaption>Bars: one standard deviation of the rate’s posterior. The curve is fitted to all settings at once.</figcaption>`;
  }
}
customElements.define("perception-all-models", AllModelsFigure);
