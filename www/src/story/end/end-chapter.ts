// The last card: what the visitor knows now, what nobody knows, and what to make next: both pads, to begin with.
import { html } from "lit";
import type { App } from "../../app/app";
import { repliesNow, loadReplies } from "../../words/sections";
import type { Chapter } from "../chapter";
import { PadsChapter } from "../hand/pads-chapter";

/** Where the visitor can make something, by the names of the words. */
const DOORS = {
  draw: "view=draw",
  lab: "view=play",
  own: "view=play&tab=learn",
  primitives: "view=primitives",
} as const;

class EndChapter extends PadsChapter {
  get #now() {
    return repliesNow()!.end;
  }

  control() {
    return html`<div class="story-row">${Object.entries(DOORS).map(
      ([door, fragment]) =>
        html`<a class="story-button" href="#${fragment}" data-testid="end-${door}">${this.#now.doors[door as keyof typeof DOORS]}</a>`,
    )}</div>`;
  }

  reveal() {
    return html`<p>${this.store.busy ? this.store.words : this.#now.unknown}</p>`;
  }
}

export async function openChapter(app: App): Promise<Chapter> {
  const [store] = await Promise.all([app.view("draw").get(), loadReplies(app.words)]);
  return new EndChapter(app, store, [0, 1]);
}
