// One coupling in a table: its slider, with its variance and its weight.
import { html } from "lit";
import { short } from "../ui/format";
import { partColour } from "../ui/palette";
import { partStyle, styled } from "../ui/styled";
import type { CouplingsStore } from "./couplings-store";
import { alphaOf, placeOf, STRONGEST, strengthOf, WEAKEST } from "./strength";
import { isOff, weightText } from "./weights";
import { lab } from "../words/lab";

export interface CouplingCell {
  couplings: CouplingsStore;
  source: number;
  target: number;
  /** The names of both parts. */
  names: [source: string, target: string];
  /** Whether training found the couplings that a reset brings back. */
  trained: boolean;
  /** Begins the test ids, where the page has another table. */
  prefix: string;
}

export function couplingCell({ couplings, source, target, names, trained, prefix }: CouplingCell) {
  const alpha = couplings.alphaOf(source, target);
  const learned = couplings.learnedAlpha(source, target);
  const weight = couplings.weight(source, target);
  const words = lab().couplings;
  const label = words.pair(...names);
  const isChanged = trained && couplings.isChanged(source, target);
  const classes = `${isChanged ? "changed" : ""} ${isOff(weight) ? "off" : ""}`;
  const testId = (what: string) => `${prefix}${what}-${source}-${target}`;
  const reset = () => couplings.reset(source, target);
  const keys = (event: KeyboardEvent) => {
    if (event.key !== "Backspace" && event.key !== "Delete") return;
    event.preventDefault();
    reset();
  };
  return html`
    <td style=${partStyle(partColour(source))} class=${classes}>
      <div class="slider">
        <span class="fill" style=${styled({ "--at": placeOf(alpha).toFixed(4) })}></span>
        <span class="tick" style=${styled({ "--at": placeOf(learned).toFixed(4) })} title=${words.tick(short(learned), trained)}></span>
        <input type="range" min=${WEAKEST} max=${STRONGEST} step="0.01" .value=${strengthOf(alpha).toFixed(2)}
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
    </td>`;
}
