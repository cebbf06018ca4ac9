// A labelled field for a number.
import { html, type TemplateResult } from "lit";

export interface NumberField {
  label: string;
  /** Shown when the mouse rests on it. */
  hint: string;
  testId: string;
  limits: { min: number; max: number; step: number };
  value: number;
  disabled: boolean;
  /** Takes the number over, and answers what it has become within the limits. */
  change(value: number): number;
}

export function numberField({ label, hint, testId, limits, value, disabled, change }: NumberField): TemplateResult {
  return html`
    <label class="field" title=${hint}>
      <span>${label}</span>
      ${numberInput({ testId, limits, value, disabled, change })}
    </label>`;
}

/** The same without a label. */
export function numberInput(field: Omit<NumberField, "label" | "hint"> & { id?: string }): TemplateResult {
  const { id = "", testId, limits, value, disabled, change } = field;
  return html`<input type="number" id=${id} data-testid=${testId} min=${limits.min} max=${limits.max} step=${limits.step}
    .value=${String(value)} ?disabled=${disabled}
    @change=${(event: Event) => {
      const input = event.target as HTMLInputElement;
      input.value = String(change(input.valueAsNumber));
    }} />`;
}
