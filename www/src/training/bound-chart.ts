// The bounds of the trainings while they rise, and the terms of the one that is looked at beneath.
import { html, nothing } from "lit";
import type uPlot from "uplot";
import type { TrainingProgress } from "../engine/protocol";
import { grouped } from "../ui/format";
import "../terms/term";
import { onThemeChange, partColour, theme } from "../ui/palette";
import { swatchStyle, View } from "../ui/view";
import { boundRange } from "./bound-range";
import { dataOf, type Run } from "./runs";
import type { TrainingStore } from "./training-store";
import { phaseWords } from "./words";

interface Stroke {
  label: string;
  colour: string;
  width?: number;
  dash?: number[];
}

interface Line extends Stroke {
  value(step: TrainingProgress): number;
}

/** A line for each run whose bound can be compared with this one's; this one's lies above the others. */
function boundRuns(charted: Run, runs: readonly Run[]): Run[] {
  const data = dataOf(charted);
  return [...runs.filter((run) => run !== charted && run.steps.length > 0 && dataOf(run) === data), charted];
}

function boundStroke(run: Run, charted: Run): Stroke {
  const { ink, faint } = theme();
  return { label: `seed ${run.settings.seed}`, ...(run === charted ? { colour: ink } : { colour: faint, width: 1 }) };
}

/** Values by iteration; nothing where a run has not been. */
function byIteration(
  steps: readonly TrainingProgress[],
  length: number,
  value: (step: TrainingProgress) => number,
): (number | null)[] {
  const row = new Array<number | null>(length).fill(null);
  for (const step of steps) row[step.iteration - 1] = value(step);
  return row;
}

function termLines(parts: readonly string[]): Line[] {
  const { quiet, faint } = theme();
  return [
    ...parts.map(
      (name, i): Line => ({
        label: `poses, ${name}`,
        colour: partColour(i),
        value: ({ terms }) => terms.kinematics[i] ?? 0,
      }),
    ),
    ...parts.map(
      (name, i): Line => ({
        label: `dynamics, ${name}`,
        colour: partColour(i),
        dash: [5, 4],
        value: ({ terms }) => terms.dynamics[i] ?? 0,
      }),
    ),
    { label: "entropy", colour: quiet, value: ({ terms }) => terms.entropy },
    { label: "first frames", colour: faint, dash: [2, 3], value: ({ terms }) => terms.initial },
  ];
}

/** Pixels. */
const BOUND_HEIGHT = 132;
const TERMS_HEIGHT = 92;

type Charts = typeof uPlot;

/** The chart library and the table of trainings come when the first training starts: the first visit does without. */
async function loadCharts(): Promise<Charts> {
  const [{ default: charts }] = await Promise.all([
    import("uplot"),
    import("uplot/dist/uPlot.min.css"),
    import("./runs-table"),
  ]);
  return charts;
}

export class BoundChart extends View {
  declare training: TrainingStore;
  private charts: Charts | "loading" | null = null;
  private bound: uPlot | null = null;
  private terms: uPlot | null = null;
  /** What the charts were made for. */
  private made = "";

  protected override stores() {
    return [this.training];
  }

  protected override arrived(): void {
    const redraw = () => {
      this.made = "";
      this.fill();
    };
    this.whenLeaving(onThemeChange(redraw));
    this.whenLeaving(() => {
      this.bound?.destroy();
      this.terms?.destroy();
      [this.bound, this.terms] = [null, null];
    });
    this.watchSize(this, () => this.fit());
  }

  override updated(): void {
    this.fill();
  }

  private fit(): void {
    const width = this.clientWidth;
    if (width === 0) return;
    this.bound?.setSize({ width, height: BOUND_HEIGHT });
    this.terms?.setSize({ width, height: TERMS_HEIGHT });
  }

  private make(Chart: Charts, box: HTMLElement, lines: Stroke[], height: number): uPlot {
    const { quiet, line } = theme();
    const grid = { stroke: line, width: 1 };
    const font = "11px system-ui, sans-serif";
    box.replaceChildren();
    return new Chart(
      {
        width: Math.max(120, this.clientWidth),
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
            values: (_, ticks) => ticks.map(grouped),
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

  private fill(): void {
    const { charted, runs, busy } = this.training;
    if (busy && this.charts === null) {
      this.charts = "loading";
      loadCharts().then(
        (charts) => {
          this.charts = charts;
          this.fill();
        },
        // Without a chart the numbers beneath still tell the course; the next step asks again.
        () => {
          this.charts = null;
        },
      );
    }
    const Chart = this.charts;
    if (!charted || charted.steps.length === 0 || this.clientWidth === 0 || Chart === null || Chart === "loading")
      return;
    const lines = termLines(charted.settings.parts.map(({ name }) => name));
    const drawn = boundRuns(charted, runs);
    const key = `${drawn.map(({ id }) => id)}|${theme().dark}`;
    if (this.made !== key || !this.bound || !this.terms) {
      const boxes = [this.querySelector<HTMLElement>(".bound"), this.querySelector<HTMLElement>(".terms")] as const;
      if (!boxes[0] || !boxes[1]) return;
      this.made = key;
      this.bound?.destroy();
      this.terms?.destroy();
      const strokes = drawn.map((run) => boundStroke(run, charted));
      this.bound = this.make(Chart, boxes[0], strokes, BOUND_HEIGHT);
      this.terms = this.make(Chart, boxes[1], lines, TERMS_HEIGHT);
    }
    const last = ({ steps }: Run) => steps.at(-1)?.iteration ?? 0;
    const iterations = (count: number) => Array.from({ length: count }, (_, i) => i + 1);
    const longest = Math.max(...drawn.map(last));
    this.bound.setData([
      iterations(longest),
      ...drawn.map(({ steps }) => byIteration(steps, longest, ({ bound }) => bound)),
    ]);
    const length = last(charted);
    this.terms.setData([iterations(length), ...lines.map(({ value }) => byIteration(charted.steps, length, value))]);
  }

  protected override render() {
    const { charted, learning, runs } = this.training;
    const last = charted?.steps.at(-1);
    const parts = charted?.settings.parts.map(({ name }) => name) ?? [];
    // One line has room for one of the two.
    const phase = learning && last ? `, ${phaseWords(last.phase)}` : "";
    const which = runs.length > 1 ? `, seed ${charted?.settings.seed}` : phase;
    // While a next training sets up, the room of the last one stays.
    const isEmpty = runs.every(({ steps }) => steps.length === 0);
    return html`
      <figure class="chart" data-testid="bound-chart">
        <figcaption><span><pg-term of="bound" text="Evidence lower bound"></pg-term><small>, in <pg-term of="nats" text="nats"></pg-term>${which}</small></span> <output data-testid="bound">${last ? grouped(last.best) : ""}</output></figcaption>
        <div class="bound-box">
          <div class="bound" role="img" aria-label="The bound over the iterations"></div>
          ${isEmpty ? html`<p class="empty">It rises here while a model trains.</p>` : nothing}
        </div>
        <pg-runs .training=${this.training}></pg-runs>
        <figcaption ?hidden=${isEmpty}><pg-term of="bound-terms" text="Its terms"></pg-term></figcaption>
        <div class="terms" ?hidden=${isEmpty} role="img" aria-label="The terms of the bound over the iterations"></div>
        <ul ?hidden=${isEmpty} class="term-list">
          ${termLines(parts).map(
            ({ label, colour, dash, value }) => html`
            <li style=${swatchStyle(colour)}><i class="stroke ${dash ? "dashed" : ""}"></i><span>${label}</span>
              <output>${last ? grouped(value(last)) : ""}</output></li>`,
          )}
        </ul>
      </figure>`;
  }
}
customElements.define("pg-bound-chart", BoundChart);
