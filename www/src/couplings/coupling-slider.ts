// The slider of one coupling, with its variance and its weight.
import { html } from "lit";
import { ALPHA_MAX, ALPHA_MIN } from "../settings/settings";
import { short } from "../ui/format";
import { partColour } from "../ui/palette";
import { partStyle, styled } from "../ui/styled";
import "./couplings.css";
import type { CouplingsStore } from "./couplings-store";
import { isOff, weightText } from "./weights";
import { lab } from "../words/lab";

export const WEAKEST = -Math.log10(ALPHA_MAX);
export const STRONGEST = -Math.log10(ALPHA_MIN);

/** The slider's value for a coupling variance. */
export function strengthOf(alpha: number): number {
  return Math.min(STRONGEST, Math.max(WEAKEST, -Math.log10(alpha)));
}

/** The coupling variance for a slider's value. */
export function alphaOf(strength: number): number {
  return 10 ** -strength;
}

/** The place of a coupling on its slider: 0 at the left, weak end, 1 at the right, strong end. */
export function placeOf(alpha: number): number {
  return (strengthOf(alpha) - WEAKEST) / (STRONGEST - WEAKEST);
}

/** One coupling: which part drives which. */
export interface Coupling {
  source: number;
  target: number;
}

export interface CouplingSlider extends Coupling {
  couplings: CouplingsStore;
  /** The names of both parts. */
  names: readonly [source: string, target: string];
  /** Whether training found the couplings that a reset brings back. */
  trained?: boolean;
  /** Begins the test ids, where the page has another table. */
  prefix?: string;
}

/** How far a key moves a coupling, as a power of ten of alpha: equal keys are equal factors. */
const STEPS: Record<string, number> = {
  ArrowUp: 0.1,
  ArrowRight: 0.1,
  ArrowDown: -0.1,
  ArrowLeft: -0.1,
  PageUp: 0.5,
  PageDown: -0.5,
  Home: Number.NEGATIVE_INFINITY,
  End: Number.POSITIVE_INFINITY,
};

/** Sets a coupling within its limits. */
export function setWithin(couplings: CouplingsStore, { source, target }: Coupling, alpha: number): void {
  couplings.set(source, target, Math.min(ALPHA_MAX, Math.max(ALPHA_MIN, alpha)));
}

export function couplingSlider({
  couplings,
  source,
  target,
  names,
  trained = true,
  prefix = "",
}: CouplingSlider) {
  const alpha = couplings.alphaOf(source, target);
  const learned = couplings.learnedAlpha(source, target);
  const weight = couplings.weight(source, target);
  const words = lab().couplings;
  const label = words.pair(...names);
  const isChanged = trained && couplings.isChanged(source, target);
  const classes = `coupling ${isChanged ? "changed" : ""} ${isOff(weight) ? "off" : ""}`;
  const testId = (what: string) => `${prefix}${what}-${source}-${target}`;
  const reset = () => couplings.reset(source, target);
  const keys = (event: KeyboardEvent) => {
    const step = STEPS[event.key];
    if (step !== undefined) setWithin(couplings, { source, target }, alphaOf(strengthOf(alpha) + step));
    else if (event.key === "Backspace" || event.key === "Delete") reset();
    else return;
    event.preventDefault();
  };
  return html`
    <div class=${classes} style=${partStyle(partColour(source))}>
      <div class="slider">
        <span class="fill" style=${styled({ "--at": placeOf(alpha).toFixed(4) })}></span>
        <span class="tick" style=${styled({ "--at": placeOf(learned).toFixed(4) })} title=${words.tick(short(learned), trained)}></span>
        <input type="range" min=${WEAKEST} max=${STRONGEST} step="any" .value=${String(strengthOf(alpha))}
          aria-label=${label} aria-valuetext=${words.value(short(alpha), weightText(weight), trained ? short(learned) : null)}
          data-source=${source} data-target=${target} data-testid=${testId("coupling")} title=${words.slider(label)}
          @input=${(event: Event) => couplings.set(source, target, alphaOf((event.target as HTMLInputElement).valueAsNumber))}
          @keydown=${keys}
          @dblclick=${reset} />
      </div>
      <div class="numbers">
        <span title=${words.alphaMeaning}><i>α</i> <output data-testid=${testId("alpha")}>${short(alpha)}</output></span>
        <span title=${words.weightMeaning}><i>w</i> <output data-testid=${testId("weight")}>${weightText(weight)}</output></span>
      </div>
    </div>`;
}
