// The last card: what the visitor knows now, what nobody knows, and what to make next: both pads, to begin with.
import { html } from "lit";
import type { App } from "../../app/app";
import type { DrawingStore } from "../../drawing/drawing-store";
import { Store } from "../../ui/store";
import { repliesNow, loadReplies } from "../../words/sections";
import type { Chapter } from "../chapter";
import { PadsOnStage } from "../hand/hand-chapter";

/** Where the visitor can make something, by the names of the words. */
const DOORS = {
  draw: "view=draw",
  lab: "view=play",
  own: "view=play&tab=learn",
  primitives: "view=primitives",
} as const;

export class EndChapter extends Store implements Chapter {
  readonly #pads: PadsOnStage;

  constructor(
    app: App,
    private readonly store: DrawingStore,
  ) {
    super();
    this.#pads = new PadsOnStage(app, store, [0, 1]);
    this.#pads.on(() => this.changed());
  }

  get #now() {
    return repliesNow()!.end;
  }

  stage() {
    return this.#pads.stage();
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
    return html`<p>${this.store.busy ? this.store.words : this.#now.unknown}</p>`;
  }

  equation() {
    return null;
  }

  lab() {
    return { view: "draw" as const };
  }

  arrive(): void {
    this.#pads.arrive();
  }

  leave(): void {}
}

export async function openChapter(app: App): Promise<Chapter> {
  const [store] = await Promise.all([app.view("draw").get(), loadReplies(app.words)]);
  return new EndChapter(app, store);
}
