// Equations of the method page with a sentence below them.
import { html, nothing, type TemplateResult } from "lit";
import { unsafeHTML } from "lit/directives/unsafe-html.js";
import { EQUATIONS } from "../method/equations";

/** `sentence`: null, if it needs a model that has not arrived. */
export function equation(
  names: readonly (keyof typeof EQUATIONS)[],
  sentence: string | null,
): TemplateResult {
  return html`${names.map((name) => unsafeHTML(EQUATIONS[name]))}${sentence === null ? nothing : html`<p>${sentence}</p>`}`;
}
