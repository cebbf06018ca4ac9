// A word of the field that can be asked what it means: with the mouse, by touch and by keyboard. The answers
// come when the first is asked for.
import { html, LitElement, nothing } from "lit";
import "./term.css";
import type { TermName } from "./terms";

export class Term extends LitElement {
  static override properties = { of: {}, text: {}, about: {} };
  /** Which term. */
  declare of: TermName;
  /** How it is written here. */
  declare text: string;
  /** Read out in place of a text that says nothing alone, such as a question mark. */
  declare about: string | undefined;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  async #ask({ currentTarget }: Event): Promise<void> {
    const { showTerm } = await import("./card");
    showTerm(this.of, currentTarget as HTMLElement);
  }

  protected override render() {
    return html`<button type="button" class="term" data-term=${this.of} aria-haspopup="dialog" aria-label=${this.about ?? nothing}
      @click=${(event: Event) => void this.#ask(event)}>${this.text}</button>`;
  }
}
customElements.define("pg-term", Term);
