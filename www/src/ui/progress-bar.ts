// A progress bar.
import { html } from "lit";

/** `share`: from 0 to 1; null: the bar is invisible and keeps its place. */
export const progressBar = (label: string, share: number | null) =>
  html`<progress max="1" .value=${share ?? 0} aria-label=${label} class=${share === null ? "resting" : ""}
    aria-hidden=${share === null ? "true" : "false"}></progress>`;
