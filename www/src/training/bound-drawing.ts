// Draws the bounds of the trainings, and the terms of one of them. Loaded when the first training starts.
import { svg } from "lit";
import type { TrainingProgress } from "../engine/protocol";
import { type Axis, axes, labelsWidth } from "../figures/chart";
import { linearScale } from "../figures/scale";
import { theme } from "../ui/palette";
import { type Stroke, termLines } from "./bound-lines";
import { dataOf, type Run } from "./runs";

/** Enough values for the quantiles. */
const ENOUGH = 3000;

/** The range to draw. The first iterations lie far below and would flatten the rest. */
export function boundRange(values: readonly number[]): [number, number] {
  const every = Math.ceil(values.length / ENOUGH);
  const finite = values.filter((value, i) => Number.isFinite(value) && (values.length - 1 - i) % every === 0);
  if (finite.length === 0) return [0, 1];
  const sorted = [...finite].sort((a, b) => a - b);
  const top = sorted.at(-1) ?? 0;
  const low = sorted[Math.floor(sorted.length * (sorted.length > 30 ? 0.12 : 0))] ?? top;
  const pad = Math.max(1, 0.08 * (top - low));
  return [low - pad, top + pad];
}

/** Pixels. */
const BOUND_HEIGHT = 132;
const TERMS_HEIGHT = 92;
const TYPE = 11;

interface Course extends Stroke {
  points: readonly (readonly [iteration: number, value: number])[];
}

const courseOf = (
  steps: readonly TrainingProgress[],
  stroke: Stroke,
  value: (step: TrainingProgress) => number,
): Course => ({ ...stroke, points: steps.map((step) => [step.iteration, value(step)]) });

/** The bounds that can be compared with that of the charted run, which lies above the others. */
export function boundPicture(charted: Run, runs: readonly Run[], width: number) {
  const { ink, faint } = theme();
  const data = dataOf(charted);
  const others = runs.filter((run) => run !== charted && run.steps.length > 0 && dataOf(run) === data);
  const courses = [...others, charted].map((run) =>
    courseOf(
      run.steps,
      run === charted ? { colour: ink } : { colour: faint, width: 1 },
      ({ bound }) => bound,
    ),
  );
  return picture(courses, width, BOUND_HEIGHT);
}

export function termsPicture({ settings, steps }: Run, width: number) {
  const lines = termLines(settings.parts.map(({ name }) => name));
  return picture(
    lines.map(({ value, ...stroke }) => courseOf(steps, stroke, value)),
    width,
    TERMS_HEIGHT,
  );
}

function picture(courses: readonly Course[], width: number, height: number) {
  const space = { top: 8, bottom: height - 2 * TYPE, right: width - 4, type: TYPE };
  const [low, high] = boundRange(courses.flatMap(({ points }) => points.map(([, value]) => value)));
  const y: Axis = { scale: linearScale([low, high], space.bottom, space.top), title: "" };
  const plot = { ...space, left: labelsWidth(y, space) };
  const last = Math.max(2, ...courses.map(({ points }) => points.at(-1)?.[0] ?? 0));
  const x: Axis = { scale: linearScale([1, last], plot.left, plot.right), title: "", least: 1 };
  const place = ([iteration, value]: readonly [number, number]) =>
    `${x.scale.at(iteration).toFixed(1)} ${y.scale.at(value).toFixed(1)}`;
  const path = ({ points }: Course) => {
    // A point for each pixel is enough. The first iterations lie below the range.
    const every = Math.ceil(points.length / width);
    const drawn = points.filter(
      ([, value], i) => value >= low && ((points.length - 1 - i) % every === 0 || i === 0),
    );
    return drawn.length === 0 ? "" : `M${drawn.map(place).join("L")}`;
  };
  return svg`
    <svg width=${width} height=${height} viewBox="0 0 ${width} ${height}" aria-hidden="true">
      ${axes(plot, x, y)}
      ${courses.map(
        (course) =>
          svg`<path d=${path(course)} stroke=${course.colour} stroke-width=${course.width ?? 1.75} stroke-dasharray=${(course.dash ?? []).join(" ") || "none"}></path>`,
      )}
    </svg>`;
}
