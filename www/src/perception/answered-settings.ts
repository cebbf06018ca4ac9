// The settings of models that have answers, and the data of their figures. No rendering.
import type { Confusion, Regression, PerceptionResults, SettingResult } from "../engine/whole-protocol";
import { estimateText, plain } from "../figures/numbers";
import type { PanelAxis, PanelPoint } from "./panel";
import { perceptionWords } from "./view-words";

/** A setting with its scores and its rate. */
export type Answered = SettingResult & {
  scores: NonNullable<SettingResult["scores"]>;
  confusion: Confusion;
};

const isAnswered = (setting: SettingResult): setting is Answered =>
  setting.scores !== null && setting.confusion !== null;

/** The settings with answers; one has none when all its movements have failed. */
export const answeredSettings = ({ settings }: PerceptionResults): Answered[] => settings.filter(isAnswered);

export type Score = Exclude<Regression["score"], "dtw-mse">;

/** The scores with their names in files. */
export const SCORES: readonly { score: Score; name: string }[] = [
  { score: "mse", name: "test MSE" },
  { score: "training-mse", name: "training MSE" },
  { score: "bound", name: "bound" },
  { score: "dynamics", name: "dynamics part of the bound" },
  { score: "pose", name: "pose part of the bound" },
  { score: "points", name: "soft minimum of the inducing points" },
];

/** The score of a setting; null: the setting has none. */
export const scoreOf = ({ scores }: Answered, score: Score): number | null =>
  score === "training-mse" ? scores.trainingMse : scores[score];

/** The rate over a score, of one kind of model or of all; null when too few settings have the score. */
export const regressionOf = (
  { regressions }: PerceptionResults,
  model: Regression["model"],
  score: Score,
): Regression | null =>
  regressions.find((regression) => regression.model === model && regression.score === score) ?? null;

/** The points of the fitted curve. */
export const curveOf = ({ curve }: Pick<Regression, "curve">): [x: number, y: number][] =>
  curve.flatMap(([x, y]): [number, number][] => (x === undefined || y === undefined ? [] : [[x, y]]));

/** "ln K = 3.21 ± 0.40, at most 5.1": above 0 the score says more than a constant. */
export function evidenceWords({
  logBayesFactor: mean,
  logBayesFactorError: standardError,
  dataLogBayesFactor: most,
  folds,
}: Regression): string {
  const { figures } = perceptionWords();
  if (mean === null || most === null) return figures.moreAnswers;
  const words = estimateText({ mean, standardError, count: folds });
  return `${`ln K = ${words.mean} ${words.error}`.trim()}, ${figures.atMost(plain(most))}`;
}

/** The columns of a rate in a file. */
export const RATE_TITLES = ["answers", "taken for natural", "confusion rate", "its standard deviation"];
export const rateFields = ({ trials, hits, mean, deviation }: Confusion) => [trials, hits, mean, deviation];

export const MSE_TITLE = "test MSE (squared units of the columns)";

/** The ends of a rate's error bar: one standard deviation. */
export const rateBar = ({ mean, deviation }: Confusion) => ({
  y: mean,
  low: mean - deviation,
  high: mean + deviation,
});

/** A value of a setting that a panel draws. */
export interface Measure {
  name: string;
  axis: PanelAxis;
  references: readonly number[];
  /** Null: the setting has no value. */
  of(setting: Answered): Pick<PanelPoint, "y" | "low" | "high"> | null;
}

/** A score of the settings; an error has a logarithmic axis. */
export function measureOf(score: Score): Measure {
  const { measures, logarithmic } = perceptionWords().figures;
  const { name, axis } = measures[score];
  const isError = score === "mse" || score === "training-mse";
  return {
    name,
    axis: { title: isError ? logarithmic(axis) : axis, kind: isError ? "log" : "linear", reach: [] },
    references: [],
    of: (setting) => {
      const y = scoreOf(setting, score);
      return y === null ? null : { y, low: y, high: y };
    },
  };
}

/** The confusion rate. */
export function rateMeasure(): Measure {
  const { name, axis } = perceptionWords().figures.measures.rate;
  return {
    name,
    axis: { title: axis, kind: "linear", reach: [0, 0.5] },
    references: [0.5],
    of: ({ confusion }) => rateBar(confusion),
  };
}
