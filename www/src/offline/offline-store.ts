// The page without a network: a service worker keeps its files, and a new version of them is offered.
import { Store } from "../ui/store";

/** What the page needs of workbox-window's `Workbox`. */
export interface ServiceWorkers {
  addEventListener(type: "waiting" | "controlling", listener: (event: { isUpdate?: boolean }) => void): void;
  register(options: { immediate: boolean }): Promise<unknown>;
  messageSkipWaiting(): void;
}

export class OfflineStore extends Store {
  #workers: ServiceWorkers | null = null;
  #state: "current" | "waiting" | "asked" | "taken" = "current";

  constructor(private readonly reload: () => void) {
    super();
  }

  /** Whether another version of the page is there. */
  get hasNewVersion(): boolean {
    return this.#state === "waiting" || this.#state === "taken";
  }

  /**
   * Keeps the files from now on, and looks for a new version. Where that cannot be, the page works as long as
   * there is a network.
   */
  async begin(load: () => Promise<ServiceWorkers>): Promise<void> {
    try {
      this.#workers = await load();
      this.#workers.addEventListener("waiting", () => this.#become("waiting"));
      this.#workers.addEventListener("controlling", ({ isUpdate }) => {
        if (this.#state === "asked") this.reload();
        // Another tab has taken the new version: this one still shows the old.
        else if (isUpdate) this.#become("taken");
      });
      await this.#workers.register({ immediate: true });
    } catch {
      // Not offered by this browser, or forbidden.
    }
  }

  /** Loads the page anew, in its new version. */
  takeNewVersion(): void {
    if (this.#state === "taken") {
      this.reload();
      return;
    }
    this.#become("asked");
    this.#workers?.messageSkipWaiting();
  }

  #become(state: "waiting" | "asked" | "taken"): void {
    this.#state = state;
    this.changed();
  }
}
