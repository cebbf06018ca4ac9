// A labelled field for a number. A value beyond the limits is not changed silently: the field says which
// limit it met.
import { html, nothing, type TemplateResult } from "lit";
import { grouped } from "../ui/format";
import { lab } from "../words/lab";

interface NumberInput {
  /** For a label elsewhere. */
  id?: string;
  testId: string;
  limits: { min: number; max: number; step: number };
  value: number;
  disabled: boolean;
  /** Takes the number and returns it within the limits. */
  change(value: number): number;
}

export interface NumberField extends Omit<NumberInput, "id"> {
  label: string;
  /** A term to explain, after the label. */
  afterLabel?: TemplateResult;
  /** Shown when the mouse rests on it. */
  hint: string;
}

/** The limit that changed a value; empty when the value is within the limits. */
export function limitWords(asked: number, { min, max }: { min: number; max: number }): string {
  const { atMost, atLeast } = lab().learn.field;
  if (asked > max) return atMost(grouped(max));
  return asked < min ? atLeast(grouped(min)) : "";
}

export function numberInput({ id, testId, limits, value, disabled, change }: NumberInput): TemplateResult {
  return html`<input type="number" id=${id ?? nothing} data-testid=${testId} min=${limits.min} max=${limits.max} step=${limits.step}
    .value=${String(value)} ?disabled=${disabled}
    @change=${(event: Event) => {
      const input = event.target as HTMLInputElement;
      const asked = input.valueAsNumber;
      input.value = String(change(asked));
      const words = input.nextElementSibling;
      if (words) words.textContent = limitWords(asked, limits);
    }} /><small class="limit" role="status"></small>`;
}

/** The label does not contain the field, because it would then label a button next to its text. */
export function numberField({ label, afterLabel, hint, ...input }: NumberField): TemplateResult {
  const id = `field-${input.testId}`;
  return html`<div class="field stack" title=${hint}><span><label for=${id}>${label}</label> ${afterLabel ?? nothing}</span>${numberInput({ ...input, id })}</div>`;
}
