// The switch between the languages of the page: a button with the name of the other language.
import { html } from "lit";
import { LANGUAGES, type Language, type WordsStore } from "../words/words";

export function languageSwitch(words: WordsStore, style = "story-language") {
  const other = Object.keys(LANGUAGES).find((language) => language !== words.language) as Language;
  return html`<button class=${style} lang=${other} data-testid="language" @click=${() => void words.choose(other)}>${LANGUAGES[other]}</button>`;
}
