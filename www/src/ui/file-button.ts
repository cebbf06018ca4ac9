// A button that asks the visitor for files.
import { html, type TemplateResult } from "lit";
import { icon } from "./icons";

export interface FileButton {
  label: string;
  /** The description for screen readers. */
  meaning: string;
  testId: string;
  /** Extensions and types of the files, for the browser's dialog. */
  accept: string;
  multiple: boolean;
  disabled: boolean;
  chosen(files: File[]): void;
}

export function fileButton({
  label,
  meaning,
  testId,
  accept,
  multiple,
  disabled,
  chosen,
}: FileButton): TemplateResult {
  return html`
    <label class="small file-button">${icon("open")} ${label}
      <input type="file" class="visually-hidden" data-testid=${testId} ?multiple=${multiple} accept=${accept} ?disabled=${disabled}
        aria-label=${meaning} @change=${(event: Event) => {
          const input = event.target as HTMLInputElement;
          const files = [...(input.files ?? [])];
          // So that the same file can be chosen again.
          input.value = "";
          chosen(files);
        }} />
    </label>`;
}
