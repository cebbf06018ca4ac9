// Draws the bounds of the trainings, and the terms of one of them. Loaded when the first training starts.
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import type { TrainingProgress } from "../engine/protocol";
import { theme } from "../ui/palette";
import { type Stroke, termLines } from "./bound-lines";
import { axisNumbers, boundRange } from "./bound-range";
import { dataOf, type Run } from "./runs";

/** The runs whose bounds can be compared with that of the charted run, which lies above the others. */
function boundRuns(charted: Run, runs: readonly Run[]): Run[] {
  const data = dataOf(charted);
  return [...runs.filter((run) => run !== charted && run.steps.length > 0 && dataOf(run) === data), charted];
}

function boundStroke(run: Run, charted: Run): Stroke {
  const { ink, faint } = theme();
  return {
    label: `seed ${run.settings.seed}`,
    ...(run === charted ? { colour: ink } : { colour: faint, width: 1 }),
  };
}

/** Values by iteration; null for iterations that the run has not reached. */
function byIteration(
  steps: readonly TrainingProgress[],
  length: number,
  value: (step: TrainingProgress) => number,
): (number | null)[] {
  const row = new Array<number | null>(length).fill(null);
  for (const step of steps) row[step.iteration - 1] = value(step);
  return row;
}

/** Pixels. */
const BOUND_HEIGHT = 132;
const TERMS_HEIGHT = 92;

export class BoundDrawing {
  readonly #host: HTMLElement;
  #bound: uPlot | null = null;
  #terms: uPlot | null = null;
  /** The runs and the theme that the charts were made for. */
  #made = "";

  constructor(host: HTMLElement) {
    this.#host = host;
  }

  /** The next drawing makes both charts again. */
  forget(): void {
    this.#made = "";
  }

  destroy(): void {
    this.#bound?.destroy();
    this.#terms?.destroy();
    [this.#bound, this.#terms] = [null, null];
  }

  fit(width: number): void {
    this.#bound?.setSize({ width, height: BOUND_HEIGHT });
    this.#terms?.setSize({ width, height: TERMS_HEIGHT });
  }

  #make(box: HTMLElement, lines: Stroke[], height: number): uPlot {
    const { quiet, line } = theme();
    const grid = { stroke: line, width: 1 };
    const font = "11px system-ui, sans-serif";
    box.replaceChildren();
    return new uPlot(
      {
        width: Math.max(120, this.#host.clientWidth),
        height,
        legend: { show: false },
        cursor: { show: false },
        padding: [8, 16, 0, 0],
        scales: {
          x: { time: false },
          y: { range: (plot) => boundRange(plot.data.slice(1).flat() as (number | null)[]) },
        },
        axes: [
          { stroke: quiet, grid: { show: false }, ticks: { show: false }, font, size: 22, gap: 2 },
          {
            stroke: quiet,
            grid,
            ticks: { show: false },
            font,
            size: 58,
            gap: 4,
            values: (_, ticks) => axisNumbers(ticks),
          },
        ],
        series: [
          {},
          ...lines.map(({ label, colour, width, dash }) => ({
            label,
            stroke: colour,
            width: width ?? 1.75,
            ...(dash ? { dash } : {}),
            points: { show: false },
          })),
        ],
      },
      [[], ...lines.map(() => [])],
      box,
    );
  }

  /** Draws the bounds that can be compared with that of the charted run, and its terms. */
  draw(charted: Run, runs: readonly Run[]): void {
    const lines = termLines(charted.settings.parts.map(({ name }) => name));
    const drawn = boundRuns(charted, runs);
    const key = `${drawn.map(({ id }) => id)}|${theme().dark}`;
    if (this.#made !== key || !this.#bound || !this.#terms) {
      const [bound, terms] = [".bound", ".terms"].map((box) => this.#host.querySelector<HTMLElement>(box));
      if (!bound || !terms) return;
      this.destroy();
      this.#made = key;
      const strokes = drawn.map((run) => boundStroke(run, charted));
      this.#bound = this.#make(bound, strokes, BOUND_HEIGHT);
      this.#terms = this.#make(terms, lines, TERMS_HEIGHT);
    }
    const last = ({ steps }: Run) => steps.at(-1)?.iteration ?? 0;
    const iterations = (count: number) => Array.from({ length: count }, (_, i) => i + 1);
    const longest = Math.max(...drawn.map(last));
    this.#bound.setData([
      iterations(longest),
      ...drawn.map(({ steps }) => byIteration(steps, longest, ({ bound }) => bound)),
    ]);
    const length = last(charted);
    this.#terms.setData([
      iterations(length),
      ...lines.map(({ value }) => byIteration(charted.steps, length, value)),
    ]);
  }
}
