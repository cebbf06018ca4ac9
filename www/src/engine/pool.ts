// Work for several workers, on as many at once as the pool is wide. Knows no model.
//
// Work with the same signal is one task, such as a comparison of a hundred jobs. A free worker goes to the
// task with the fewest workers, so that a training does not wait for all jobs of a comparison; among equals
// the order is that of asking.

/** A worker that the pool has started. */
export interface Hired<Worker> {
  worker: Worker;
  /** Resolves when the worker can work. */
  ready: Promise<unknown>;
  /** Fails, with a sentence for the visitor, when the worker dies. */
  broken: Promise<never>;
  dismiss(): void;
}

interface Waiting<Worker> {
  work(worker: Worker): Promise<unknown>;
  /** The worker for this work; null: any. */
  on: Worker | null;
  signal: AbortSignal | undefined;
  /** Called when the work begins. */
  begun(): void;
  done(result: unknown): void;
  failed(problem: unknown): void;
}

/** Milliseconds that aborted work may take to end by itself. */
const GRACE = 30_000;

export class Pool<Worker> {
  readonly #idle: Hired<Worker>[] = [];
  #waiting: Waiting<Worker>[] = [];
  /** The signal of each work under way. */
  readonly #tasks: (AbortSignal | undefined)[] = [];
  /**
   * Fails the work of a worker that dies. There is one listener for each worker: one for each piece of work
   * would keep its result in memory for as long as the worker lives.
   */
  readonly #atWork = new Map<Hired<Worker>, (problem: unknown) => void>();
  /** Workers that are kept for work that continues. */
  readonly #kept = new Set<Worker>();

  constructor(
    /** How many workers work at once. */
    readonly width: number,
    private readonly hire: () => Hired<Worker>,
    private readonly grace: number = GRACE,
  ) {}

  /**
   * Does the work on a worker of its own, now or when one is free. An abort drops work that still waits. Work
   * under way reads the signal itself and ends early with a result, before the grace is over. `on`: a worker
   * that was kept.
   */
  run<Result>(
    work: (worker: Worker) => Promise<Result>,
    signal?: AbortSignal,
    on: Worker | null = null,
  ): Promise<Result> {
    return new Promise<Result>((resolve, reject) => {
      if (signal?.aborted) return reject(signal.reason);
      if (on !== null && !this.keeps(on)) return reject(new Error("the worker that trained it is gone."));
      const aborted = () => this.#drop(job);
      const begun = () => signal?.removeEventListener("abort", aborted);
      const job: Waiting<Worker> = {
        work,
        on,
        signal,
        begun,
        done: resolve as (result: unknown) => void,
        failed: reject,
      };
      this.#waiting.push(job);
      signal?.addEventListener("abort", aborted, { once: true });
      this.#next();
    });
  }

  /** Reserves the worker, until it is let go. */
  keep(worker: Worker): void {
    this.#kept.add(worker);
  }

  /** Whether the worker is reserved and alive. */
  keeps(worker: Worker): boolean {
    return this.#kept.has(worker);
  }

  letGo(worker: Worker): void {
    this.#kept.delete(worker);
    this.#next();
  }

  /** The work that begins next. Work for a worker that is busy does not keep other work waiting. */
  #choose(): Waiting<Worker> | undefined {
    const workers = ({ signal }: Waiting<Worker>) => this.#tasks.filter((task) => task === signal).length;
    return this.#waiting
      .filter(({ on }) => on === null || this.#idle.some(({ worker }) => worker === on))
      .reduce<Waiting<Worker> | undefined>(
        (best, job) => (best && workers(best) <= workers(job) ? best : job),
        undefined,
      );
  }

  #drop(job: Waiting<Worker>): void {
    if (!this.#waiting.includes(job)) return;
    this.#waiting = this.#waiting.filter((other) => other !== job);
    job.failed(job.signal?.reason);
  }

  #next(): void {
    while (this.#tasks.length < this.width) {
      const job = this.#choose();
      if (!job) break;
      this.#waiting.splice(this.#waiting.indexOf(job), 1);
      job.begun();
      void this.#attend(job);
    }
    if (this.#tasks.length > 0) return;
    // One worker stays for the next work. The memory of the others, unless they are kept, is freed.
    const [, ...spare] = this.#idle.filter(({ worker }) => !this.#kept.has(worker));
    for (const hired of spare) this.#forget(hired);
  }

  #forget(hired: Hired<Worker>): void {
    this.#kept.delete(hired.worker);
    this.#atWork.delete(hired);
    const at = this.#idle.indexOf(hired);
    if (at >= 0) this.#idle.splice(at, 1);
    hired.dismiss();
  }

  /** Takes an idle worker: this one, or any that is not kept. */
  #take(on: Worker | null): Hired<Worker> | null {
    const fits = ({ worker }: Hired<Worker>) => (on === null ? !this.#kept.has(worker) : worker === on);
    const at = this.#idle.findLastIndex(fits);
    return at < 0 ? null : (this.#idle.splice(at, 1)[0] ?? null);
  }

  async #attend({ work, on, signal, done, failed }: Waiting<Worker>): Promise<void> {
    this.#tasks.push(signal);
    const silence = patience(signal, this.grace);
    let hired: Hired<Worker> | null = null;
    try {
      hired = this.#take(on) ?? this.#open();
      const result = await Promise.race([this.#workOn(hired, work), silence.promise]);
      this.#idle.push(hired);
      done(result);
    } catch (problem) {
      // A worker whose work failed may be damaged: the next work gets a fresh one.
      if (hired) this.#forget(hired);
      failed(problem);
    } finally {
      silence.end();
      this.#tasks.splice(this.#tasks.indexOf(signal), 1);
      this.#next();
    }
  }

  /** Fails when the worker dies. */
  async #workOn<Result>(hired: Hired<Worker>, work: (worker: Worker) => Promise<Result>): Promise<Result> {
    try {
      return await new Promise<Result>((resolve, reject) => {
        this.#atWork.set(hired, reject);
        hired.ready.then(() => work(hired.worker)).then(resolve, reject);
      });
    } finally {
      this.#atWork.delete(hired);
    }
  }

  #open(): Hired<Worker> {
    const hired = this.hire();
    hired.broken.catch((problem) => {
      // A worker at work is dismissed by `#attend`, when its work fails.
      if (this.#idle.includes(hired)) this.#forget(hired);
      else this.#atWork.get(hired)?.(problem);
    });
    return hired;
  }
}

/** Fails when the work has not ended `grace` milliseconds after the abort. */
function patience(signal: AbortSignal | undefined, grace: number) {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let wait = () => {};
  const promise = new Promise<never>((_, fail) => {
    const words = `the worker did not stop within ${Math.round(grace / 1000)} seconds.`;
    wait = () => (timer = setTimeout(() => fail(new Error(words)), grace));
  });
  if (signal?.aborted) wait();
  else signal?.addEventListener("abort", wait, { once: true });
  return {
    promise,
    end() {
      signal?.removeEventListener("abort", wait);
      clearTimeout(timer);
    },
  };
}
