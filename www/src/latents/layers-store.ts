// What the plots of latent spaces show: inducing points, and a picture behind the path.
import { Store } from "../ui/store";
import type { Behind } from "./latent-drawing";
import type { Future } from "./outlook-drawing";
import type { Outlook, OutlookStore } from "./outlook-store";

/** The inducing points that the plots show. */
export interface Layers {
  pose: boolean;
  dynamics: boolean;
  between: boolean;
}

/** What the picture shows of an outlook: of a body, or of tables, which have futures alone. */
export interface ShownOutlook
  extends Pick<OutlookStore, "on" | "isShown" | "show" | "seed" | "moments" | "pictureOf" | "drawOthers"> {
  readonly futures: readonly Future[];
}

/** Futures and uncertainty with their drawing; they load when they are asked for. */
export interface OpenedOutlook {
  store: ShownOutlook;
  behindPath(store: ShownOutlook): Behind | null;
}

export class LayersStore extends Store {
  readonly #open: () => Promise<OpenedOutlook | null>;
  #shown: Layers = { pose: true, dynamics: true, between: false };
  #outlook: ShownOutlook | null = null;
  #behind: Behind | null = null;

  /** `open`: loads futures and uncertainty; null if they cannot be loaded. */
  constructor(open: () => Promise<OpenedOutlook | null>) {
    super();
    this.#open = open;
  }

  get shown(): Layers {
    return this.#shown;
  }

  /** Futures and uncertainty; null before their first use. */
  get outlook(): ShownOutlook | null {
    return this.#outlook;
  }

  /** Draws behind the path; null: nothing is there. */
  get behind(): Behind | null {
    return this.#behind;
  }

  toggle(layer: keyof Layers): void {
    this.#shown = { ...this.#shown, [layer]: !this.#shown[layer] };
    this.changed();
  }

  async toggleOutlook(outlook: Outlook): Promise<void> {
    const opened = this.#outlook ? null : await this.#open();
    if (opened) {
      const { store, behindPath } = opened;
      this.#outlook = store;
      store.on(() => {
        this.#behind = behindPath(store);
        this.changed();
      });
    }
    this.#outlook?.show(outlook, !this.#outlook.isShown(outlook));
  }
}
