// The card that explains a term. The page has one, a popover, which Escape and a click outside close.
import { TERMS, type TermName } from "./terms";
import type { TermsWords } from "../words/en/terms";

export async function termWords(language = document.documentElement.lang): Promise<TermsWords> {
  return language === "de"
    ? (await import("../words/de/terms")).terms
    : (await import("../words/en/terms")).terms;
}

/** Pixels from the edges of the window and from the control. */
const EDGE = 8;
const GAP = 4;

interface Size {
  width: number;
  height: number;
}

/** The place of a box: below the anchor, or above it when the box does not fit below, within the window. */
export function popoverPlace(
  anchor: DOMRectReadOnly | (Size & { x: number; y: number }),
  box: Size,
  window: Size,
) {
  const below = anchor.y + anchor.height + GAP;
  const above = anchor.y - GAP - box.height;
  const fits = below + box.height <= window.height - EDGE;
  const most = Math.max(EDGE, window.height - EDGE - box.height);
  const top = fits || above < EDGE ? Math.min(below, most) : above;
  const left = Math.max(EDGE, Math.min(anchor.x, window.width - EDGE - box.width));
  return { left, top };
}

/** Shows a popover next to a control. */
function showPopoverAt(popover: HTMLElement, anchor: HTMLElement): void {
  popover.showPopover();
  const { left, top } = popoverPlace(anchor.getBoundingClientRect(), popover.getBoundingClientRect(), {
    width: document.documentElement.clientWidth,
    height: innerHeight,
  });
  popover.style.left = `${left}px`;
  popover.style.top = `${top}px`;
}

let card: HTMLElement | null = null;

function made(): HTMLElement {
  const element = document.createElement("div");
  element.className = "term-card";
  element.popover = "auto";
  // The card takes the focus, so that screen readers read it; Escape gives the focus back.
  element.setAttribute("role", "dialog");
  element.setAttribute("aria-labelledby", "term-title");
  element.setAttribute("aria-describedby", "term-words");
  element.tabIndex = -1;
  return element;
}

/** Explains a term next to the button that was pressed. */
export async function showTerm(name: TermName, asked: HTMLElement): Promise<void> {
  const { more: moreText, texts } = await termWords();
  card ??= made();
  const { symbol } = TERMS[name];
  const { title, words } = texts[name];
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
  more.textContent = moreText;
  more.addEventListener("click", () => {
    card?.hidePopover();
    asked.closest("dialog")?.close();
    asked.dispatchEvent(new CustomEvent("show-method", { bubbles: true }));
  });
  card.replaceChildren(heading, text, more);
  // Elements outside an open dialog cannot be reached.
  (asked.closest("dialog") ?? document.body).append(card);
  showPopoverAt(card, asked);
  card.focus();
}
