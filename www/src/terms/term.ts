// A term of the field with an explanation, by mouse, touch and keyboard. The explanations are loaded at their
// first use.
import { html, LitElement, nothing } from "lit";
import "./term.css";
import type { TermName } from "./terms";

/** A sentence in which each [text|term] in brackets is a term. */
export function withTerms(sentence: string) {
  const [first = "", ...pieces] = sentence.split("[");
  return html`${first}${pieces.map((piece) => {
    const [marked = "", after = ""] = piece.split("]");
    const [text = "", term = ""] = marked.split("|");
    return html`<pg-term of=${term} text=${text}></pg-term>${after}`;
  })}`;
}

export class Term extends LitElement {
  static override properties = { of: {}, text: {}, about: {} };
  /** The key of the term. */
  declare of: TermName;
  /** The text on the page. */
  declare text: string;
  /** For screen readers, in place of a text such as a question mark. */
  declare about: string | undefined;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  async #ask({ currentTarget }: Event): Promise<void> {
    const { showTerm } = await import("./card");
    await showTerm(this.of, currentTarget as HTMLElement);
  }

  protected override render() {
    return html`<button type="button" class="term" data-term=${this.of} aria-haspopup="dialog" aria-label=${this.about ?? nothing}
      @click=${(event: Event) => void this.#ask(event)}>${this.text}</button>`;
  }
}
customElements.define("pg-term", Term);
