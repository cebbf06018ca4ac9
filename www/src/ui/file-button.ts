// A button that asks the visitor for files.
import { html, type TemplateResult } from "lit";
import { icon } from "./icons";

export interface FileButton {
  label: string;
  /** For screen readers: what can be opened. */
  meaning: string;
  testId: string;
  /** Endings and types of the files, as the browser's dialog takes them. */
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
          // The same file may be chosen again.
          input.value = "";
          chosen(files);
        }} />
    </label>`;
}
