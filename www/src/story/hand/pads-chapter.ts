// A card with the pads of the view Draw on its stage, and the model that goes on with what the visitor draws.
import { html, type TemplateResult } from "lit";
import type { App } from "../../app/app";
import type { DrawingStore, Pad } from "../../drawing/drawing-store";
import { Lazy } from "../../ui/lazy";
import { Store } from "../../ui/store";
import { loadLab } from "../../words/lab";
import type { Chapter } from "../chapter";
import "./pads-stage";

export abstract class PadsChapter extends Store implements Chapter {
  /** The view of latent spaces arrives while a hand draws. */
  readonly #plots = new Lazy(async () => {
    await Promise.all([import("../../latents/latent-plot"), loadLab(this.app.words)]);
    this.changed();
    return true;
  });

  constructor(
    protected readonly app: App,
    protected readonly store: DrawingStore,
    private readonly pads: readonly Pad[],
  ) {
    super();
    store.on(() => {
      if (store.busy || store.isDrawing || store.drawn) this.#plots.get().catch(() => {});
      this.changed();
    });
  }

  abstract control(): TemplateResult | null;
  abstract reveal(): TemplateResult | null;

  stage() {
    return html`<pg-pads-stage .store=${this.store} .pads=${this.pads} .plots=${this.#plots.loaded !== null} .settings=${this.app.settings}></pg-pads-stage>`;
  }

  guess() {
    return null;
  }

  guessed(): void {}

  equation() {
    return null;
  }

  lab() {
    return { view: "draw" as const };
  }

  arrive(): void {
    if (this.store.drawn) this.#plots.get().catch(() => {});
  }

  leave(): void {}
}
