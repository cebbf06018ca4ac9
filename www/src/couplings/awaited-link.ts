// A link whose couplings belong to another model than the one on the stage. The link waits until the visitor
// opens that model.
import type { Settings } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";

type Link = Pick<Settings, "model" | "alpha" | "start" | "startFrame">;

export class AwaitedLink {
  readonly #settings: SettingsStore;
  #link: Link | null = null;

  constructor(settings: SettingsStore) {
    this.#settings = settings;
  }

  /** The first digits of the hash of the model that the link names; null without a link. */
  get model(): string | null {
    return this.#link?.model ?? null;
  }

  /** The address keeps the link, so that it is still there after a reload. */
  wait(link: Link): void {
    this.#link = link;
    this.#settings.holdBack(link);
  }

  forget(): void {
    if (!this.#link) return;
    this.#link = null;
    this.#settings.holdBack({});
  }

  /** The couplings and the start of the link, if it names this model. The link then waits no longer. */
  takeFor(model: string): Omit<Link, "model"> | null {
    const link = this.#link;
    if (link?.model !== model) return null;
    this.forget();
    const { alpha, start, startFrame } = link;
    return { alpha, start, startFrame };
  }
}
