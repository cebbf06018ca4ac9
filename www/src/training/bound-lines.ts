// The terms of a bound, each a line of the chart.
import type { TrainingProgress } from "../engine/protocol";
import { partColourNow, theme } from "../ui/palette";
import { lab } from "../words/lab";

export interface Stroke {
  colour: string;
  width?: number;
  dash?: number[];
}

export interface Line extends Stroke {
  label: string;
  value(step: TrainingProgress): number;
}

export function termLines(parts: readonly string[]): Line[] {
  const { quiet, faint } = theme();
  const words = lab().learn.bound;
  return [
    ...parts.map(
      (name, i): Line => ({
        label: words.poses(name),
        colour: partColourNow(i),
        value: ({ terms }) => terms.kinematics[i] ?? 0,
      }),
    ),
    ...parts.map(
      (name, i): Line => ({
        label: words.dynamics(name),
        colour: partColourNow(i),
        dash: [5, 4],
        value: ({ terms }) => terms.dynamics[i] ?? 0,
      }),
    ),
    { label: words.entropy, colour: quiet, value: ({ terms }) => terms.entropy },
    { label: words.firstFrames, colour: faint, dash: [2, 3], value: ({ terms }) => terms.initial },
  ];
}
