// The settings of models that have answers, and the data of their figures. No rendering.
import type { Confusion, Regression, PerceptionResults, SettingResult } from "../engine/whole-protocol";
import { estimateText } from "../figures/numbers";
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

export type Score = "mse" | "bound" | "dynamics" | "pose";

/** The scores with their names in files. */
export const SCORES: readonly { score: Score; name: string }[] = [
  { score: "mse", name: "test MSE" },
  { score: "bound", name: "bound" },
  { score: "dynamics", name: "dynamics part of the bound" },
  { score: "pose", name: "pose part of the bound" },
];

/** The rate over a score, of one kind of model or of all; null when too few settings have the score. */
export const regressionOf = (
  { regressions }: PerceptionResults,
  model: Regression["model"],
  score: Score,
): Regression | null =>
  regressions.find((regression) => regression.model === model && regression.score === score) ?? null;

/** The points of the fitted curve. */
export const curveOf = ({ curve }: Regression): [x: number, y: number][] =>
  curve.flatMap(([x, y]): [number, number][] => (x === undefined || y === undefined ? [] : [[x, y]]));

/** "ln K = 3.21 ± 0.40": above 0 the score says more than a constant. */
export function evidenceWords({
  logBayesFactor: mean,
  logBayesFactorError: standardError,
  folds,
}: Regression): string {
  if (mean === null) return perceptionWords().figures.moreAnswers;
  const words = estimateText({ mean, standardError, count: folds });
  return `ln K = ${words.mean} ${words.error}`.trim();
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

const certain = (y: number | null) => (y === null ? null : { y, low: y, high: y });

/** The confusion rate, the error on trials held out and the bound. */
export function measures(): readonly [confusion: Measure, error: Measure, bound: Measure] {
  const { measures: words, logMse } = perceptionWords().figures;
  return [
    {
      name: words.rate.name,
      axis: { title: words.rate.axis, kind: "linear", reach: [0, 0.5] },
      references: [0.5],
      of: ({ confusion }) => rateBar(confusion),
    },
    {
      name: words.mse.name,
      axis: { title: logMse, kind: "log", reach: [] },
      references: [],
      of: ({ scores }) => certain(scores.mse),
    },
    {
      name: words.bound.name,
      axis: { title: words.bound.axis, kind: "linear", reach: [] },
      references: [],
      of: ({ scores }) => certain(scores.bound),
    },
  ];
}
