// The time and memory of a training, computed before it begins.
import type { ClipsStore } from "../clips/clips-store";
import type { EngineStore } from "../engine/engine-store";
import { Latest } from "../engine/latest";
import type { CostQuestion, PlannedTraining, TrainingCost } from "../engine/protocol";
import type { SettingsStore } from "../settings/settings-store";
import { duration } from "../ui/format";
import { lab } from "../words/lab";

/** Limits of a warning, in seconds and bytes: a lecture is over, or the memory of a tab is full. */
const LONG = 45 * 60;
const LARGE = 1.5e9;
/** The page says nothing about trainings that are shorter, in seconds. */
const SHORT = 20;
/** Columns of a joint: its rotation. */
const COLUMNS = 3;

/** The time and memory of a training as text, empty for a short training. `absurd`: the page warns. */
export interface CostWords {
  words: string;
  absurd: boolean;
}

export class Cost {
  readonly #latest: Latest<CostQuestion, PlannedTraining | undefined>;
  #asked = "";
  #cost: PlannedTraining | null = null;

  constructor(
    engine: EngineStore,
    private readonly settings: SettingsStore,
    private readonly clips: ClipsStore,
    changed: () => void,
  ) {
    const done = (cost: PlannedTraining | undefined) => {
      this.#cost = cost ?? null;
      changed();
    };
    const failed = () => done(undefined);
    this.#latest = new Latest(async (question) => engine.engine?.trainingCost(question), done, failed);
    for (const store of [engine, settings, clips]) store.on(() => this.#ask());
  }

  /** Null before the first answer. */
  get now(): PlannedTraining | null {
    return this.#cost;
  }

  #ask(): void {
    const { latent, order, dynamicsIps, poseIps, maxIterations, framesPerSecond } = this.settings.values;
    const { ticked, parts } = this.clips;
    const seconds = ticked.map(({ first, end, loaded }) => (end - first) * loaded.info.frameTime);
    const frames = Math.round(seconds.reduce((sum, some) => sum + some, 0) * framesPerSecond);
    if (frames === 0) return;
    const columns = parts.map(({ joints }) => COLUMNS * joints.length);
    const settings = { latent, order, dynamicsIps, poseIps, maxIterations };
    const question = { settings, frames, columns, longest: Math.max(...seconds) };
    const words = JSON.stringify(question);
    if (words === this.#asked) return;
    this.#asked = words;
    this.#latest.request(question);
  }
}

/** The cost of `count` trainings, of which `workers` run at the same time. */
export function costWords(cost: TrainingCost | null, count: number, workers: number): CostWords {
  if (!cost) return { words: "", absurd: false };
  const { seconds, bytes } = cost;
  return waitWords(
    { seconds: seconds * Math.ceil(count / Math.max(1, workers)), bytes: bytes * Math.min(count, workers) },
    lab().learn.training.shorter,
  );
}

/** The text of a cost, with advice on how to make the training shorter. */
export function waitWords({ seconds, bytes }: TrainingCost, shorter: string): CostWords {
  const absurd = seconds > LONG || bytes > LARGE;
  if (!absurd && seconds < SHORT) return { words: "", absurd };
  const words = lab().learn.training.cost(rounded(seconds), bytes > LARGE ? bytes / 1e9 : null);
  return { words: absurd ? `${words} ${shorter}` : words, absurd };
}

function rounded(seconds: number): string {
  if (seconds >= 48 * 3600) return lab().learn.training.days(Math.round(seconds / 86400));
  if (seconds >= 3600) return lab().learn.training.hours(Math.round(seconds / 360) / 10);
  const step = seconds > 600 ? 60 : seconds > 60 ? 10 : 5;
  return duration(Math.ceil(seconds / step) * step);
}
