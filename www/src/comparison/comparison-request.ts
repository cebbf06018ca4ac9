// The request for a comparison, from the settings and the ticked clips.
import type { ClipsStore } from "../clips/clips-store";
import type { TrainingClip } from "../engine/protocol";
import type { ComparisonSettings, Plan } from "../engine/whole-protocol";
import type { Settings } from "../settings/settings";
import { seedsFrom } from "../training/runs";
import type { Body } from "../scene/columns";

export interface ComparisonRequest {
  /** Equal for requests with the same clips, parts and frame rate. */
  key: string;
  clips: TrainingClip[];
  titles: string[];
  body: Body;
  settings: ComparisonSettings;
  plan: Plan;
}

export function planOf(settings: Readonly<Settings>): Plan {
  const { models, latent, order, ips, bases, balanced, heldOut, seed, seeds, growth } = settings;
  return {
    models: [...models],
    latent,
    order,
    maxIterations: settings.comparedIterations,
    ips: [...ips],
    primitives: [null],
    bases: [...bases],
    balanced,
    heldOut: heldOut === "each" ? [] : [heldOut],
    seeds: seedsFrom(seed, seeds),
    trainingTrials: [],
    growth,
  };
}

/** Null without a ticked clip. */
export function comparisonRequest(
  { ticked, toTrainOn: clips, parts }: Pick<ClipsStore, "ticked" | "toTrainOn" | "parts">,
  settings: Readonly<Settings>,
): ComparisonRequest | null {
  const [first] = ticked;
  if (!first) return null;
  const { figure, joints } = first.loaded.info;
  const { framesPerSecond } = settings;
  return {
    key: JSON.stringify([clips.map(({ id, first, end }) => [id, first, end]), parts, framesPerSecond]),
    clips,
    titles: clips.map(({ title }) => title),
    body: { figure, joints: joints.map(({ name }) => name), parts },
    settings: { parts, framesPerSecond },
    plan: planOf(settings),
  };
}
