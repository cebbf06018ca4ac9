// Sets of couplings to choose from: those of the model that the page opens with, of which the effect is
// known, and some that make sense for any model.
import startPresets from "../../first/presets.json";
import type { ModelView, Reading } from "../engine/protocol";
import { type ChangedCouplings, limited } from "../settings/settings";
import { isClose } from "./couplings-store";

export interface Preset {
  id: string;
  name: string;
  /** One plain sentence: for the first model what happens, else what the couplings are. */
  sentence: string;
  reading: Reading;
  /** What is changed: the learned coupling times a factor. */
  couplings: readonly Change[];
}

interface Change {
  /** Names of parts. */
  source: string;
  target: string;
  factor: number;
}

/** A coupling variance that is so many times the learned one leaves the source next to nothing to say. */
const SILENT = 1000;

/**
 * The presets of the model that the page opens with; `tests/node/presets.test.mjs` measures what they say.
 */
export const START_PRESETS: readonly Preset[] = startPresets.map(({ holds: _, reading, ...preset }) => ({
  ...preset,
  reading: reading as Reading,
}));

/** What the head of the page invites to: a preset of the first model, and what its name promises. */
export const INVITATION = { preset: "arms-go", promise: "and they fall out of step" };

/** Presets for any model with these parts; none for a model of one part. */
export function presetsOf(parts: readonly string[]): Preset[] {
  if (parts.length < 2) return [];
  const preset = (id: string, name: string, sentence: string, couplings: Change[]): Preset => ({
    id,
    name,
    sentence,
    reading: "re-inferred",
    couplings,
  });
  const changed = parts.flatMap((target, place) => {
    const others = parts.filter((part) => part !== target);
    const silent = (source: string) => ({ source, target, factor: SILENT });
    return [
      preset(
        `${place}-alone`,
        `${capital(target)} on its own`,
        `What the other parts say about ${target} hardly counts.`,
        others.map(silent),
      ),
      preset(
        `${place}-follows`,
        `${capital(target)} follows the others`,
        `What ${target} says about itself hardly counts.`,
        [silent(target)],
      ),
    ];
  });
  return [preset("as-learned", "As learned", "The parts as training coupled them.", []), ...changed];
}

/**
 * The couplings of a preset as settings know them, within their limits; null where the model lacks a part.
 */
export function couplingsOf(
  { couplings }: Preset,
  { parts, alpha }: ModelView["info"],
): ChangedCouplings | null {
  const changed: Record<string, number> = {};
  for (const { source, target, factor } of couplings) {
    const place = (name: string) => parts.findIndex((part) => part.name === name);
    const [from, to] = [place(source), place(target)];
    const learned = alpha[from]?.[to];
    if (learned === undefined) return null;
    changed[`${from}.${to}`] = learned * factor;
  }
  return limited({ alpha: changed }).alpha ?? null;
}

/**
 * Whether these couplings, read like this, are those of the preset. Without a change there is nothing to
 * read.
 */
export function isPreset(
  preset: Preset,
  info: ModelView["info"],
  { alpha, reading }: { alpha: ChangedCouplings; reading: Reading },
): boolean {
  const wanted = couplingsOf(preset, info);
  if (!wanted) return false;
  const pairs = Object.keys(wanted);
  return (
    pairs.length === Object.keys(alpha).length &&
    (pairs.length === 0 || preset.reading === reading) &&
    pairs.every((pair) => isClose(alpha[pair] ?? Number.POSITIVE_INFINITY, wanted[pair] ?? 0))
  );
}

function capital(name: string): string {
  return name.charAt(0).toUpperCase() + name.slice(1);
}
