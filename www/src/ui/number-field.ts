// A labelled field for a number.
import { html, nothing, type TemplateResult } from "lit";

interface NumberInput {
  /** For a label elsewhere. */
  id?: string;
  testId: string;
  limits: { min: number; max: number; step: number };
  value: number;
  disabled: boolean;
  /** Takes the number over, and answers what it has become within the limits. */
  change(value: number): number;
}

export interface NumberField extends Omit<NumberInput, "id"> {
  label: string;
  /** Shown when the mouse rests on it. */
  hint: string;
}

export function numberInput({ id, testId, limits, value, disabled, change }: NumberInput): TemplateResult {
  return html`<input type="number" id=${id ?? nothing} data-testid=${testId} min=${limits.min} max=${limits.max} step=${limits.step}
    .value=${String(value)} ?disabled=${disabled}
    @change=${(event: Event) => {
      const input = event.target as HTMLInputElement;
      input.value = String(change(input.valueAsNumber));
    }} />`;
}

export function numberField({ label, hint, ...input }: NumberField): TemplateResult {
  return html`<label class="field" title=${hint}><span>${label}</span>${numberInput(input)}</label>`;
}
