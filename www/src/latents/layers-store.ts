// What the plots of latent spaces show: inducing points, and a picture behind the path.
import { Store } from "../ui/store";
import type { Behind } from "./latent-drawing";
import type { Outlook, OutlookStore } from "./outlook-store";

/** The inducing points that the plots show. */
export interface Layers {
  pose: boolean;
  dynamics: boolean;
  between: boolean;
}

/** Futures and uncertainty with their drawing; they load when they are asked for. */
export interface OpenedOutlook {
  store: OutlookStore;
  behindPath(store: OutlookStore): Behind | null;
}

export class LayersStore extends Store {
  readonly #open: () => Promise<OpenedOutlook | null>;
  #shown: Layers = { pose: true, dynamics: true, between: false };
  #outlook: OutlookStore | null = null;
  /** Draws behind the path; null: nothing is there. */
  behind: Behind | null = null;

  /** `open`: loads futures and uncertainty; null if they cannot be loaded. */
  constructor(open: () => Promise<OpenedOutlook | null>) {
    super();
    this.#open = open;
  }

  get shown(): Layers {
    return this.#shown;
  }

  /** Futures and uncertainty; null before their first use. */
  get outlook(): OutlookStore | null {
    return this.#outlook;
  }

  toggle(layer: keyof Layers): void {
    this.#shown = { ...this.#shown, [layer]: !this.#shown[layer] };
    this.changed();
  }

  async toggleOutlook(outlook: Outlook): Promise<void> {
    const opened = await this.#open();
    if (!opened) return;
    const { store, behindPath } = opened;
    if (!this.#outlook) {
      this.#outlook = store;
      store.on(() => {
        this.behind = behindPath(store);
        this.changed();
      });
    }
    store.show(outlook, !store.isShown(outlook));
  }
}
