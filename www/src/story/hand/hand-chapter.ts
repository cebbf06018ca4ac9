// The first card: a pad, and a model that goes on with what the visitor draws.
import { html } from "lit";
import type { App } from "../../app/app";
import type { DrawingStore, Pad } from "../../drawing/drawing-store";
import { Lazy } from "../../ui/lazy";
import { Store } from "../../ui/store";
import { loadLab } from "../../words/lab";
import type { Chapter } from "../chapter";
import "./pads-stage";

/** Pads on the stage of a chapter, with the model that goes on. */
export class PadsOnStage extends Store {
  /** The view of latent spaces arrives while a hand draws. */
  readonly #plots = new Lazy(async () => {
    await Promise.all([import("../../latents/latent-plot"), loadLab(this.app.words)]);
    this.changed();
    return true;
  });

  constructor(
    private readonly app: App,
    readonly store: DrawingStore,
    private readonly pads: readonly Pad[],
  ) {
    super();
    store.on(() => {
      if (store.busy || store.isDrawing || store.drawn) this.#plots.get().catch(() => {});
      this.changed();
    });
  }

  stage() {
    return html`<pg-pads-stage .store=${this.store} .pads=${this.pads} .plots=${this.#plots.loaded !== null} .settings=${this.app.settings}></pg-pads-stage>`;
  }

  arrive(): void {
    if (this.store.drawn) this.#plots.get().catch(() => {});
  }
}

export class HandChapter extends Store implements Chapter {
  readonly #pads: PadsOnStage;

  constructor(
    private readonly app: App,
    private readonly store: DrawingStore,
  ) {
    super();
    this.#pads = new PadsOnStage(app, store, [0]);
    this.#pads.on(() => this.changed());
  }

  get #now() {
    return this.app.words.now.chapters.hand;
  }

  stage() {
    return this.#pads.stage();
  }

  guess() {
    return null;
  }

  guessed(): void {}

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
  return new HandChapter(app, await app.view("draw").get());
}
