// For tests: the real workers, in the thread of the test. The test can hold their calls, and answer itself.
import init, { Model } from "vcgpdm/inline";
import { version } from "vcgpdm/player";
import { playerCalls, samples } from "../workers/player-calls";
import { using } from "../workers/using";
import { wholeCalls } from "../workers/whole-calls";
import { type Calls, callsBy } from "./calls";
import type { StartedEngine } from "./engine";
import { type Hired, Pool } from "./pool";
import type { Workbench } from "./protocol";
import { SupervisedEngine } from "./supervised";
import { clipCalls, type WholeCalls, type WholeWorkers } from "./whole-workers";

type PlayerCalls = Omit<Calls<Workbench>, "start">;
type AllCalls = PlayerCalls & WholeCalls;
type Name = keyof AllCalls;
type Given<Call extends Name> = Parameters<AllCalls[Call]>;
type Answer<Call extends Name> = Awaited<ReturnType<AllCalls[Call]>>;
type Work = (...given: unknown[]) => unknown;

/** A call that waits for the test. */
interface HeldCall<Call extends Name> {
  given: Given<Call>;
  /** The number of the worker, counted from 0 in the order of their starts. */
  worker: number;
  /** Ends the call with this answer. */
  end(answer: Answer<Call>): void;
  /** Lets the worker work and answer. */
  go(): void;
  /** Lets the worker work now, and answer when this is called. */
  late(): Promise<() => void>;
  fail(problem: Error): void;
  /** Lets the worker die. */
  die(problem: Error): void;
}

await init();

/** The hash of a model's document. */
export const hashOf = (text: string) => using(Model.fromJson(text), (model) => model.sha256());

/** The workers that answer: what an earlier test left behind does not reach into a later one. */
let newest: HeldWorkers | null = null;

/**
 * Tests share one program: there is one open model, library and training, whatever the number of workers, and
 * nothing is copied on the way. A test that needs two trainings lets one go after the other.
 */
export class HeldWorkers implements WholeWorkers {
  readonly #calls: { name: Name; given: unknown[] }[] = [];
  readonly #held: { name: Name; call: HeldCall<Name> }[] = [];
  readonly #holding = new Set<Name>();
  readonly #answers = new Map<Name, Work>();
  #atWork = 0;
  /** The numbers of workers of the whole program that started, and that were dismissed. */
  hired = 0;
  dismissed = 0;
  /** The reason why the whole program cannot be loaded; empty if it can. */
  unreachable = "";
  /** The clips that come with the page. */
  samples = samples();
  readonly pool: Pool<WholeCalls>;
  readonly desk = new Pool(1, () => this.#hire());
  readonly library = new Pool(1, () => this.#hire());

  /** `width`: how many workers of the pool work at once. */
  constructor(width = 2) {
    newest = this;
    this.pool = new Pool(width, () => this.#hire());
    // Each page counts its clips anew, and the program knows them by their numbers: it forgets those of the page before.
    void wholeCalls.checkTogether([]);
  }

  /** Of the clips that come with the page, only these: the start is then shorter. */
  bring(...ids: string[]): void {
    this.samples = this.samples.filter(({ id }) => ids.includes(id));
  }

  /** From now on, calls of these names wait for the test. Their abort signal lets the worker work, which reads it. */
  hold(...names: Name[]): void {
    for (const name of names) this.#holding.add(name);
  }

  /** From now on, calls of this name are no longer held. */
  letGo(...names: Name[]): void {
    for (const name of names) this.#holding.delete(name);
  }

  /** From now on, calls of this name have this answer. `real`: what the worker does. */
  answer<Call extends Name>(
    name: Call,
    answer: (real: AllCalls[Call], ...given: Given<Call>) => Answer<Call> | Promise<Answer<Call>>,
  ): void {
    const real = this.#real(name) as AllCalls[Call];
    this.#answers.set(name, (...given) => answer(real, ...(given as Given<Call>)));
  }

  /** What all calls of this name gave so far. */
  asked<Call extends Name>(name: Call): Given<Call>[] {
    return this.#calls.filter((call) => call.name === name).map(({ given }) => given as Given<Call>);
  }

  /** The calls of this name that were held, in order, also those that have ended. */
  held<Call extends Name>(name: Call): HeldCall<Call>[] {
    const held = this.#held.filter((one) => one.name === name);
    return held.map(({ call }) => call as unknown as HeldCall<Call>);
  }

  /** Waits until no worker works, but for held calls. */
  async settled(): Promise<void> {
    do await new Promise((resolve) => setTimeout(resolve, 0));
    while (this.#atWork > 0);
  }

  /** The worker that shows has started too. */
  started(): StartedEngine {
    const start = () => {
      const { worker, broken } = this.#worker<PlayerCalls>(-1);
      return { calls: worker, broken, dismiss: () => {} };
    };
    const events = { restarted: () => {}, stopped: () => {} };
    const { engine } = new SupervisedEngine(start(), async () => start(), events);
    return { engine, clips: clipCalls(this), pool: this.pool, version: version(), samples: this.samples };
  }

  #hire(): Hired<WholeCalls> {
    const ready = this.unreachable ? Promise.reject(new Error(this.unreachable)) : Promise.resolve();
    const dismiss = () => {
      this.dismissed += 1;
    };
    return { ...this.#worker<WholeCalls>(this.hired++), ready, dismiss };
  }

  #worker<Face>(number: number): { worker: Face; broken: Promise<never> } {
    let die: (problem: Error) => void = () => {};
    const broken = new Promise<never>((_, fail) => {
      die = fail;
    });
    broken.catch(() => {});
    const worker = callsBy<AllCalls>((name, given) => this.#ask(name, given, number, die)) as Face;
    return { worker, broken };
  }

  #real(name: Name): Work {
    const calls = { ...playerCalls, ...wholeCalls } as unknown as Record<Name, Work>;
    return async (...given) => calls[name](...given);
  }

  async #ask(name: Name, given: unknown[], worker: number, die: (problem: Error) => void): Promise<unknown> {
    if (newest !== this) return new Promise(() => {});
    this.#calls.push({ name, given });
    const signal = given.find((value) => value instanceof AbortSignal);
    signal?.throwIfAborted();
    const work = this.#answers.get(name) ?? this.#real(name);
    const atWork = async () => {
      this.#atWork += 1;
      try {
        return await work(...given);
      } finally {
        this.#atWork -= 1;
      }
    };
    if (!this.#holding.has(name)) return atWork();
    return new Promise((end, fail) => {
      let over = false;
      const ends =
        <Values extends unknown[], Result>(way: (...values: Values) => Result) =>
        (...values: Values) => {
          over = true;
          return way(...values);
        };
      const go = ends(() => void atWork().then(end, fail));
      const late = ends(async () => {
        const answer = (await atWork()) as Answer<Name>;
        return () => end(answer);
      });
      const call = {
        given: given as Given<Name>,
        worker,
        go,
        late,
        end: ends(end),
        fail: ends(fail),
        die: ends(die),
      };
      this.#held.push({ name, call });
      signal?.addEventListener("abort", () => over || go(), { once: true });
    });
  }
}
