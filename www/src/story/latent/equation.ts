// An equation of the method page with a sentence below it.
import { html, type TemplateResult } from "lit";
import { unsafeHTML } from "lit/directives/unsafe-html.js";
import { EQUATIONS } from "../../method/equations";

export function equation(name: keyof typeof EQUATIONS, sentence: string): TemplateResult {
  return html`${unsafeHTML(EQUATIONS[name])}<p>${sentence}</p>`;
}
