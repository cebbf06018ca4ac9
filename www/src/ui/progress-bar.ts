// How far work is, as a bar.
import { html } from "lit";

/** `share` goes from 0 to 1; null: nothing is under way, and only the bar's place is kept. */
export const progressBar = (label: string, share: number | null) =>
  html`<progress max="1" .value=${share ?? 0} aria-label=${label} class=${share === null ? "resting" : ""}
    aria-hidden=${share === null ? "true" : "false"}></progress>`;
