// Requests of which only the newest matters: one is under way at a time, and older waiting ones are dropped.

export class Latest<Request, Result> {
  private busy = false;
  private waiting: { request: Request } | null = null;

  constructor(
    private readonly ask: (request: Request) => Promise<Result>,
    private readonly done: (result: Result, request: Request) => void,
    private readonly failed: (problem: unknown) => void,
  ) {}

  request(request: Request): void {
    this.waiting = { request };
    if (!this.busy) void this.run();
  }

  /** Forgets what waits, and the answer of what is under way. */
  drop(): void {
    this.generation += 1;
    this.waiting = null;
  }

  private generation = 0;

  private async run(): Promise<void> {
    this.busy = true;
    try {
      while (this.waiting) {
        const { request } = this.waiting;
        const generation = this.generation;
        this.waiting = null;
        try {
          const result = await this.ask(request);
          if (generation === this.generation) this.done(result, request);
        } catch (problem) {
          if (generation === this.generation) this.failed(problem);
        }
      }
    } finally {
      this.busy = false;
    }
  }
}
