// The first card: a pad, and a model that goes on with what the visitor draws.
import { html } from "lit";
import type { App } from "../../app/app";
import type { Chapter } from "../chapter";
import { PadsChapter } from "./pads-chapter";

class HandChapter extends PadsChapter {
  get #now() {
    return this.app.words.now.chapters.hand;
  }

  control() {
    const { store } = this;
    const { example, two, again } = this.#now;
    if (!store.drawn)
      return html`<button class="story-button" data-testid="hand-example" ?disabled=${store.busy} @click=${() => void store.example([0])}>${example}</button>`;
    return html`
      <div class="story-row">
        <a class="story-button" href="#view=draw" data-testid="hand-two">${two}</a>
        <button class="story-button" data-testid="hand-again" @click=${() => store.clear()}>${again}</button>
      </div>`;
  }

  reveal() {
    const { store } = this;
    const points = store.model.model?.dynamicsInducing[0]?.[0]?.count;
    if (!store.words) return null;
    const isDone = store.drawn && !store.busy && points !== undefined;
    return html`<p data-testid="hand-words">${store.words}</p>${isDone ? html`<p>${this.#now.learned(points)}</p>` : null}`;
  }
}

export async function openChapter(app: App): Promise<Chapter> {
  return new HandChapter(app, await app.view("draw").get(), [0]);
}
