// Settings of a model on a grid: pose inducing points across, dynamics inducing points upwards. No rendering.
import type { ModelKind, SettingResult } from "../engine/whole-protocol";

export interface Grid {
  model: ModelKind;
  /** The numbers of inducing points, in rising order. */
  pose: number[];
  dynamics: number[];
  /** The setting at each pair. */
  at(pose: number, dynamics: number): SettingResult | null;
}

const rising = (values: readonly number[]) => [...new Set(values)].sort((a, b) => a - b);

/** A grid for each model that has inducing points. */
export function gridsOf(settings: readonly SettingResult[]): Grid[] {
  const models = [...new Set(settings.map(({ model }) => model))];
  return models.flatMap((model) => {
    const placed = settings.flatMap((setting) => {
      const { poseIps: pose, dynamicsIps: dynamics } = setting.size;
      return setting.model === model && pose !== null && dynamics !== null
        ? [{ pose, dynamics, setting }]
        : [];
    });
    if (placed.length === 0) return [];
    return [
      {
        model,
        pose: rising(placed.map(({ pose }) => pose)),
        dynamics: rising(placed.map(({ dynamics }) => dynamics)),
        at: (pose: number, dynamics: number) =>
          placed.find((other) => other.pose === pose && other.dynamics === dynamics)?.setting ?? null,
      },
    ];
  });
}
