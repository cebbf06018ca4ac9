// Style properties of an element in a template. Lit's own styleMap writes a style attribute, which the
// content security policy forbids.
import { noChange } from "lit";
import { type AttributePart, Directive, directive } from "lit/directive.js";

type Properties = Record<string, string | number>;

class Styled extends Directive {
  #names: string[] = [];

  render(_properties: Properties) {
    return noChange;
  }

  override update({ element }: AttributePart, [properties]: [Properties]) {
    const { style } = element as HTMLElement | SVGElement;
    for (const name of this.#names) if (!(name in properties)) style.removeProperty(name);
    this.#names = Object.keys(properties);
    for (const [name, value] of Object.entries(properties)) style.setProperty(name, String(value));
    return noChange;
  }
}

/**
 * `style=${styled({ "--at": 0.5, left: "3px" })}`: custom properties, or CSS names as a style sheet has them.
 */
export const styled = directive(Styled);

/** The colour of a part and more properties. */
export const partStyle = (colour: string, more: Properties = {}) => styled({ "--part": colour, ...more });
