// One coupling in a table: its slider, with its variance and its weight.
import { html } from "lit";
import { short } from "../ui/format";
import { partColour } from "../ui/palette";
import { partStyle, styled } from "../ui/styled";
import { isOff, shareWord } from "./shares";
import { alphaOf, placeOf, STRONGEST, strengthOf, WEAKEST } from "./strength";

export interface CouplingCell {
  source: number;
  target: number;
  /** The names of both parts. */
  names: [source: string, target: string];
  alpha: number;
  /** What `reset` goes back to, marked on the slider. */
  before: number;
  /** Whether a training found that; else it is only how the coupling was. */
  learned: boolean;
  weight: number;
  /** Whether it is shown as changed. */
  changed: boolean;
  /** What the test ids begin with, where a page has another table. */
  prefix?: string;
  change(alpha: number): void;
  reset(): void;
}

export function couplingCell(cell: CouplingCell) {
  const { source, target, alpha, before, learned, weight, changed, prefix = "", change, reset } = cell;
  const label = cell.names.join(" to ");
  const classes = `${changed ? "changed" : ""} ${isOff(weight) ? "off" : ""}`;
  const testId = (what: string) => `${prefix}${what}-${source}-${target}`;
  const keys = (event: KeyboardEvent) => {
    if (event.key !== "Backspace" && event.key !== "Delete") return;
    event.preventDefault();
    reset();
  };
  return html`
    <td style=${partStyle(partColour(source))} class=${classes}>
      <div class="slider">
        <span class="fill" style=${styled({ "--at": placeOf(alpha).toFixed(4) })}></span>
        <span class="tick" style=${styled({ "--at": placeOf(before).toFixed(4) })} title="${learned ? "As learned" : "As it was"}: ${short(before)}"></span>
        <input type="range" min=${WEAKEST} max=${STRONGEST} step="0.01" .value=${strengthOf(alpha).toFixed(2)}
          aria-label=${label} aria-valuetext="alpha ${short(alpha)}, weight ${shareWord(weight)}${learned ? `; learned ${short(before)}` : ""}"
          data-source=${source} data-target=${target} data-testid=${testId("coupling")} title="${label}: drag to change, double click to reset"
          @input=${(event: Event) => change(alphaOf((event.target as HTMLInputElement).valueAsNumber))}
          @keydown=${keys}
          @dblclick=${reset} />
      </div>
      <div class="numbers">
        <span title="alpha, the variance of this prediction: small means influential"><i>α</i> <output data-testid=${testId("alpha")}>${short(alpha)}</output></span>
        <span title="weight of this prediction; the weights into a part sum to 1"><i>w</i> <output data-testid=${testId("weight")}>${shareWord(weight)}</output></span>
      </div>
    </td>`;
}
