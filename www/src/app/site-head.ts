// The head of the story and of the page for teachers: the doors of the page and the switch of the language.
import { html } from "lit";
import { lastChapter } from "../settings/door";
import type { App } from "./app";
import { LANGUAGES, type Language, type WordsStore } from "../words/words";

export function languageSwitch(words: WordsStore, style = "story-language") {
  const other = Object.keys(LANGUAGES).find((language) => language !== words.language) as Language;
  return html`<button class=${style} lang=${other} data-testid="language" @click=${() => void words.choose(other)}>${LANGUAGES[other]}</button>`;
}

type Door = "story" | "lab" | "teach";

export function siteHead({ settings, words }: App, here: Door) {
  const { frame } = words.now;
  const door = (name: Door, address: string) =>
    name === here
      ? html`<span aria-current="page">${frame[name]}</span>`
      : html`<a href="#${address}" data-testid="to-${name}">${frame[name]}</a>`;
  return html`
    <header class="story-head row">
      <p>${frame.page}</p>
      <nav aria-label=${frame.views}>
        ${door("story", `story=${lastChapter()}`)}${door("lab", settings.labFragment)}${door("teach", "teach")}
      </nav>
      ${languageSwitch(words)}
    </header>`;
}
