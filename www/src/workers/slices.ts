// How a worker works and still hears messages: step after step, with a pause for them after each slice.

/** Milliseconds of work before a report, and before messages (a cancel) get their turn. */
const SLICE = 100;

/** Work under way, until it is over or cancelled. */
export class Task {
  #cancelled = false;
  #paused = 0;

  cancel(): void {
    this.#cancelled = true;
  }

  /** Milliseconds that other messages took: they are no part of the work. */
  get paused(): number {
    return this.#paused;
  }

  /**
   * Takes steps until one answers that it was the last, or until a cancel comes; answers whether all were
   * taken. `report` is called after each slice.
   */
  async inSlices(step: () => boolean, report: (done: boolean) => unknown): Promise<boolean> {
    let done = false;
    while (!done && !this.#cancelled) {
      const start = performance.now();
      do done = step();
      while (!done && performance.now() - start < SLICE);
      await report(done);
      await this.#pause();
    }
    return done;
  }

  /** Lets waiting messages in. */
  async #pause(): Promise<void> {
    const start = performance.now();
    await new Promise((resolve) => setTimeout(resolve, 0));
    this.#paused += performance.now() - start;
  }
}

/** A worker that has one task at a time. */
export class OneTask {
  #task: Task | null = null;

  async run<Result>(work: (task: Task) => Promise<Result>): Promise<Result> {
    if (this.#task) throw new Error("This worker is at work already.");
    this.#task = new Task();
    try {
      return await work(this.#task);
    } finally {
      this.#task = null;
    }
  }

  cancel(): void {
    this.#task?.cancel();
  }
}
