// The card that says what a term means: one for the page, a popover, so that Escape and a click beside it
// close it.
import { showPopoverAt } from "../ui/popover";
import { TERMS, type TermName } from "./terms";

let card: HTMLElement | null = null;

function made(): HTMLElement {
  const element = document.createElement("div");
  element.className = "term-card";
  element.popover = "auto";
  // Read out when it opens, because it takes the focus; Escape gives the focus back.
  element.setAttribute("role", "dialog");
  element.setAttribute("aria-labelledby", "term-title");
  element.setAttribute("aria-describedby", "term-words");
  element.tabIndex = -1;
  return element;
}

/** Says what a term means, beside the button that asks. */
export function showTerm(name: TermName, asked: HTMLElement): void {
  card ??= made();
  const { title, symbol, words } = TERMS[name];
  const heading = document.createElement("h3");
  heading.id = "term-title";
  heading.append(title);
  if (symbol) {
    const letter = document.createElement("i");
    letter.textContent = symbol;
    heading.append(letter);
  }
  const text = document.createElement("p");
  text.id = "term-words";
  text.textContent = words;
  const more = document.createElement("button");
  more.type = "button";
  more.className = "small";
  more.textContent = "The method, with its equations";
  more.addEventListener("click", () => {
    card?.hidePopover();
    asked.closest("dialog")?.close();
    asked.dispatchEvent(new CustomEvent("show-method", { bubbles: true }));
  });
  card.replaceChildren(heading, text, more);
  // What lies outside an open dialog cannot be reached.
  (asked.closest("dialog") ?? document.body).append(card);
  showPopoverAt(card, asked);
  card.focus();
}
