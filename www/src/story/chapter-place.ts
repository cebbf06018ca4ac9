// The way from chapter to chapter: back, the list of all chapters, and next.
import { html, nothing } from "lit";
import type { Words } from "../words/words";
import { addressOf, type ChapterName, ORDER } from "../settings/chapters";

interface Place {
  words: Words;
  /** The open chapter. */
  name: ChapterName;
  step(direction: 1 | -1): void;
}

const chevron = (path: string) => html`<svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"
  fill="none" stroke="currentColor" stroke-width="1.8" stroke-linecap="round" stroke-linejoin="round"><path d=${path}></path></svg>`;
const LEFT = "M10 3L5 8l5 5";
const RIGHT = "M6 3l5 5-5 5";

/** The list hides when a chapter is chosen. */
const hide = ({ currentTarget }: Event) =>
  (currentTarget as HTMLElement).closest<HTMLElement>("[popover]")?.hidePopover();

function list({ words, name }: Place) {
  return html`
    <ol id="story-chapters" popover data-testid="chapter-list">
      ${ORDER.map(
        (other, place) => html`
        <li>
          <a href="#story=${addressOf(other)}" aria-current=${other === name ? "step" : "false"} @click=${hide}>
            <span>${place + 1}</span> ${words.chapters[other].title}</a>
        </li>`,
      )}
    </ol>`;
}

export function chapterPlace(place: Place) {
  const { words, name, step } = place;
  const [number, count] = [ORDER.indexOf(name) + 1, ORDER.length];
  const { frame } = words;
  return html`
    <nav class="story-place" aria-label=${frame.chapters}>
      ${
        number > 1
          ? html`<button class="story-step" aria-label=${frame.back} data-testid="chapter-back" @click=${() => step(-1)}>${chevron(LEFT)}</button>`
          : nothing
      }
      <button class="story-dots" popovertarget="story-chapters" data-testid="chapters">
        <span class="dots" aria-hidden="true">${Array.from(
          { length: count },
          (_, i) => html`<i class=${i + 1 === number ? "now" : i + 1 < number ? "past" : ""}></i>`,
        )}</span>
        <span>${frame.place(number, count)}</span>
      </button>
      ${
        number < count
          ? html`<button class="story-next" aria-label=${frame.nextChapter} data-testid="chapter-next" @click=${() => step(1)}>${frame.next} ${chevron(RIGHT)}</button>`
          : nothing
      }
      ${list(place)}
    </nav>`;
}
