// Style properties of an element in a template. Not as an attribute, as lit's own styleMap begins: a strict
// content security policy forbids style attributes.
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

/** `style=${styled({ "--at": 0.5, left: "3px" })}`: custom properties, or CSS names as a style sheet has them. */
export const styled = directive(Styled);

/** In the colour of a part, with more properties if there are some. */
export const partStyle = (colour: string, more: Properties = {}) => styled({ "--part": colour, ...more });
