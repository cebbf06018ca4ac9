// Answers, error on the training trials and bound over the numbers of inducing points (figure 6 of Velychko et al.
// 2018). A study of an earlier version has only the error on the trials held out.
import { html, nothing } from "lit";
import type { PerceptionResults, Regression } from "../engine/whole-protocol";
import { FigureElement } from "../figures/figure-element";
import { modelStyle } from "../figures/model-style";
import {
  answeredSettings,
  curveOf,
  type Measure,
  MSE_TITLE,
  measureOf,
  RATE_TITLES,
  rateFields,
  rateMeasure,
  regressionOf,
} from "./answered-settings";
import { perceptionWords } from "./view-words";
import { type Grid, gridsOf } from "./grids";
import { type Panel, type PanelPoint, panels } from "./panel";

/** The width of an ellipse grows with the dynamics points, its height with the pose points. */
const sizeOf = (count: number, most: number) => 0.18 + 0.42 * (count / most);

/** The settings of a grid that have answers. */
const settingsOf = ({ model }: Grid, results: PerceptionResults) =>
  answeredSettings(results).flatMap((setting) => {
    const { poseIps: pose, dynamicsIps: dynamics } = setting.size;
    return setting.model === model && pose !== null && dynamics !== null ? [{ pose, dynamics, setting }] : [];
  });

type Placed = ReturnType<typeof settingsOf>;

const heading = (grid: Grid, words: string) =>
  html`<span class="name">${modelStyle(grid.model).name}</span> <small>${words}</small>`;

/** One measure over another, an ellipse for each setting. */
function over(grid: Grid, placed: Placed, y: Measure, x: Measure, lines: Panel["lines"]): Panel {
  const [mostPose, mostDynamics] = [Math.max(...grid.pose), Math.max(...grid.dynamics)];
  const points = placed.flatMap(({ pose, dynamics, setting }) => {
    const [across, up] = [x.of(setting), y.of(setting)];
    if (!across || !up) return [];
    const ellipse = [sizeOf(dynamics, mostDynamics), sizeOf(pose, mostPose)] as const;
    return [{ model: grid.model, x: across.y, y: up.y, low: up.y, high: up.y, ellipse }];
  });
  const words = perceptionWords().figures;
  const named = words.over(y.name, x.name);
  return {
    heading: heading(grid, named),
    words: `${modelStyle(grid.model).name}: ${words.settings(named, points.length)}`,
    ...{ x: x.axis, y: y.axis, points, lines, references: y.references },
  };
}

/** A measure over the dynamics points, a line for each number of pose points. */
function lined(grid: Grid, placed: Placed, measure: Measure): Panel {
  const rows = grid.pose.map((column) =>
    placed
      .filter(({ pose }) => pose === column)
      .flatMap(({ dynamics, setting }): PanelPoint[] => {
        const value = measure.of(setting);
        return value ? [{ model: grid.model, x: dynamics, ...value }] : [];
      })
      .sort((a, b) => a.x - b.x),
  );
  const { inducing: words, dynamics } = perceptionWords().figures;
  return {
    heading: heading(grid, words.lines(measure.name)),
    words: `${modelStyle(grid.model).name}: ${words.linesOf(measure.name, grid.pose.join(", "))}`,
    // The axis begins at 0: a single number would give it fractions of a point.
    x: { title: dynamics, kind: "linear", reach: [0] },
    y: measure.axis,
    points: rows.flat(),
    lines: rows.map((row, i) => ({
      model: grid.model,
      places: row.map(({ x, y }) => [x, y] as const),
      label: String(grid.pose[i] ?? ""),
    })),
    references: measure.references,
  };
}

/** The error that a figure shows: that of the paper, where the study has it. */
const errorOf = ({ settings }: PerceptionResults) =>
  settings.some(({ scores }) => scores?.trainingMse != null) ? "training-mse" : "mse";

function panelsOf(grid: Grid, results: PerceptionResults): Panel[] {
  const placed = settingsOf(grid, results);
  if (placed.length === 0) return [];
  const score = errorOf(results);
  const lineOf = (fit: Pick<Regression, "curve"> | null | undefined) =>
    fit ? [{ model: grid.model, places: curveOf(fit) }] : [];
  const fitted = lineOf(regressionOf(results, grid.model, score));
  const exponential = lineOf(results.errorCurves.find(({ model }) => model === grid.model));
  const withBound = placed.some(({ setting }) => setting.scores.bound !== null);
  const [confusion, error, bound] = [rateMeasure(), measureOf(score), measureOf("bound")];
  const { axis } = perceptionWords().figures.measures[score];
  const linearError: Measure = { ...error, axis: { title: axis, kind: "linear", reach: [] } };
  return [
    over(grid, placed, confusion, linearError, fitted),
    ...(withBound ? [over(grid, placed, error, bound, exponential)] : []),
    lined(grid, placed, confusion),
    lined(grid, placed, error),
  ];
}

export class InducingFigure extends FigureElement<PerceptionResults> {
  protected readonly words = () => perceptionWords().figures.inducing;
  protected readonly file = "confusion-error-and-bound-over-inducing-points";

  protected missing(results: PerceptionResults): string | null {
    return gridsOf(results.settings).every((grid) => settingsOf(grid, results).length === 0)
      ? perceptionWords().figures.needsPoints
      : null;
  }

  protected table(results: PerceptionResults) {
    return {
      header: [
        ...["model", "pose inducing points", "dynamics inducing points"],
        ...[...RATE_TITLES, MSE_TITLE, "training MSE", "bound (nats)"],
      ],
      rows: gridsOf(results.settings).flatMap((grid) =>
        settingsOf(grid, results).map(({ pose, dynamics, setting: { scores, confusion } }) => [
          ...[
            modelStyle(grid.model).name,
            pose,
            dynamics,
            ...rateFields(confusion),
            scores.mse,
            scores.trainingMse,
            scores.bound,
          ],
        ]),
      ),
    };
  }

  protected figure(results: PerceptionResults) {
    const all = gridsOf(results.settings).flatMap((grid) => panelsOf(grid, results));
    const { caption, paper } = perceptionWords().figures.inducing;
    return html`
      ${panels(all, this.width, this.type, 4)}
      <figcaption>${caption} ${errorOf(results) === "mse" ? nothing : paper}</figcaption>`;
  }
}
customElements.define("perception-inducing", InducingFigure);
