// The state of one subject of the page. Only the store's own methods change it; views and other stores
// listen.

/** Milliseconds between two redraws of workers' reports. */
const SOON = 100;

/** Something whose changes others listen to. */
export interface Observed {
  /** Calls back after each change. Returns a function that stops the calls. */
  on(listener: () => void): () => void;
}

export abstract class Store implements Observed {
  readonly #listeners = new Set<() => void>();
  #waiting = false;

  /** Calls back after each change. Returns a function that stops the calls. */
  on(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Tells all listeners at once. */
  protected changed(): void {
    for (const listener of [...this.#listeners]) listener();
  }

  /** The same at most every 100 ms, because workers report often. */
  protected changedSoon(): void {
    if (this.#waiting) return;
    this.#waiting = true;
    setTimeout(() => {
      this.#waiting = false;
      this.changed();
    }, SOON);
  }
}
