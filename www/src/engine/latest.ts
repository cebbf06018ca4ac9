// Requests of which only the newest matters: one is under way at a time, and the newest one waits.

export class Latest<Request, Result> {
  #busy = false;
  #waiting: { request: Request } | null = null;

  /** Grows when the answer under way is dropped. */
  #generation = 0;

  constructor(
    private readonly ask: (request: Request) => Promise<Result>,
    private readonly done: (result: Result, request: Request) => void,
    private readonly failed: (problem: unknown) => void,
  ) {}

  request(request: Request): void {
    this.#waiting = { request };
    if (!this.#busy) void this.#run();
  }

  /** Drops the request that waits, and the answer of the one under way. */
  drop(): void {
    this.#generation += 1;
    this.#waiting = null;
  }

  async #run(): Promise<void> {
    this.#busy = true;
    try {
      while (this.#waiting) {
        const { request } = this.#waiting;
        const generation = this.#generation;
        this.#waiting = null;
        try {
          const result = await this.ask(request);
          if (generation === this.#generation) this.done(result, request);
        } catch (problem) {
          if (generation === this.#generation) this.failed(problem);
        }
      }
    } finally {
      this.#busy = false;
    }
  }
}
