// Presets of couplings: some for the model that the page opens with, others for any model. A preset promises
// nothing: the page measures its effect on the model at hand (`measuresText`).
import startPresets from "../../first/presets.json";
import type { ModelView, Reading } from "../engine/protocol";
import { type ChangedCouplings, limited } from "../settings/settings";
import { isClose } from "./couplings-store";
import { lab, shownPart } from "../words/lab";

export interface Preset {
  id: string;
  /** The part that a preset of any model is about; null: all parts. The first model's presets have none. */
  part?: string | null;
  reading: Reading;
  /** The factors by which couplings change. */
  couplings: readonly Change[];
}

interface Change {
  /** Names of parts. */
  source: string;
  target: string;
  factor: number;
}

/** A coupling variance this many times the learned one gives its source almost no weight. */
const SILENT = 1000;

/** The presets of the model that the page opens with. */
export const START_PRESETS = startPresets as readonly Preset[];

/** The name of a preset and the meaning of its couplings, not their effect. */
export function presetWords({ id, part }: Preset): { name: string; meaning: string } {
  const { start, learned, alone, follows } = lab().presets;
  if (part) return id.endsWith("-alone") ? alone(shownPart(part)) : follows(shownPart(part));
  return (part === undefined && start[id]) || learned;
}

/** Presets for any model with these parts; none for a model of one part. */
export function presetsOf(parts: readonly string[]): Preset[] {
  if (parts.length < 2) return [];
  const reading = "re-inferred";
  const changed = parts.flatMap((target, place) => {
    const others = parts.filter((part) => part !== target);
    const silent = (source: string) => ({ source, target, factor: SILENT });
    return [
      { id: `${place}-alone`, part: target, reading, couplings: others.map(silent) } as const,
      { id: `${place}-follows`, part: target, reading, couplings: [silent(target)] } as const,
    ];
  });
  return [{ id: "as-learned", part: null, reading, couplings: [] }, ...changed];
}

/** The couplings of a preset within the limits of the settings; null if the model lacks one of its parts. */
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

/** Whether these couplings match a preset. The reading counts only where a coupling differs. */
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
