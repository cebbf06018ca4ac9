// Work that a visitor starts and may cancel.
import { Store } from "./store";

export abstract class Job extends Store {
  #status: "idle" | "running" | "cancelling" = "idle";
  #ending = { words: "", failed: false };
  #stop = new AbortController();

  get status(): "idle" | "running" | "cancelling" {
    return this.#status;
  }

  get busy(): boolean {
    return this.#status !== "idle";
  }

  /** How the last work ended, or why it failed; empty before. */
  get ending(): { words: string; failed: boolean } {
    return this.#ending;
  }

  /** The work begins. Returns the signal that `cancel` gives. */
  protected startJob(): AbortSignal {
    this.#status = "running";
    this.#stop = new AbortController();
    this.setEnding("");
    return this.#stop.signal;
  }

  /** The work is over. */
  protected endJob(words = "", failed = false): void {
    this.#status = "idle";
    this.setEnding(words, failed);
  }

  protected setEnding(words: string, failed = false): void {
    this.#ending = { words, failed };
    this.changed();
  }

  /** Stops the work, which keeps its best so far. */
  cancel(): void {
    if (this.#status !== "running") return;
    this.#status = "cancelling";
    this.#stop.abort();
    this.changed();
  }
}
