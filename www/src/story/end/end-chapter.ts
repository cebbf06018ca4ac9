// The last card: what the visitor knows now, what nobody knows, and what to make next.
import { html } from "lit";
import { Store } from "../../ui/store";
import { repliesNow, loadReplies } from "../../words/sections";
import type { StoryBody } from "../../app/story-body";
import type { Chapter } from "../chapter";
import { EndlessWalk } from "../endless-walk";
import type { App } from "../../app/app";
import "../../stage/stage-view";

/** Where the visitor can make something, by the names of the words. */
const DOORS = {
  draw: "view=draw",
  lab: "view=play",
  own: "view=play&tab=learn",
  primitives: "view=primitives",
} as const;

export class EndChapter extends Store implements Chapter {
  readonly #walk: EndlessWalk;

  constructor(private readonly body: StoryBody) {
    super();
    this.#walk = new EndlessWalk(body, () => this.changed());
  }

  get #now() {
    return repliesNow()!.end;
  }

  stage() {
    const { stage, playback } = this.body;
    return html`<pg-stage .stage=${stage} .playback=${playback} .running=${true} .label=${this.#now.figure}></pg-stage>`;
  }

  guess() {
    return null;
  }

  guessed(): void {}

  control() {
    return html`<div class="story-row">${Object.entries(DOORS).map(
      ([door, fragment]) =>
        html`<a class="story-button" href="#${fragment}" data-testid="end-${door}">${this.#now.doors[door as keyof typeof DOORS]}</a>`,
    )}</div>`;
  }

  reveal() {
    return html`<p>${this.#now.unknown}</p>`;
  }

  equation() {
    return null;
  }

  lab() {
    return {};
  }

  arrive(): void {
    this.#walk.arrive();
  }

  leave(): void {
    this.#walk.leave();
  }
}

export async function openChapter(app: App): Promise<Chapter> {
  await loadReplies(app.words);
  return new EndChapter(app.story);
}
