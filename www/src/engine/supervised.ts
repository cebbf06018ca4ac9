// Supervises the workbench: when the worker dies, another takes over with the same model. Callers pass in the
// function that starts a worker.
import { messageOf } from "../ui/format";
import { callsBy } from "./calls";
import type { Engine, Workbench } from "./protocol";
import type { Running } from "./running";
import { isTrap } from "./traps";

export type RunningWorkbench = Running<Omit<Workbench, "start">>;
type Remote = RunningWorkbench["calls"];

export interface SupervisedEvents {
  /** The worker stopped for this reason, and another has taken over with the same model. */
  restarted(why: string): void;
  /** No other worker could take over. */
  stopped(problem: unknown): void;
}

/** How many workers in a row may die while they take over. */
const TAKE_OVERS = 3;

/** A worker that dies within as many milliseconds after it took over counts as well. */
const SOON = 2_000;

/** The worker died during a call. */
class Died extends Error {}

export class SupervisedEngine {
  readonly engine: Engine;
  #worker: Promise<RunningWorkbench>;
  #model: { text: string; frames: number; revision: number } | null = null;
  #revision = 0;
  /** When the last worker took over, and how many in a row died soon after that. */
  #tookOver = Number.NEGATIVE_INFINITY;
  #early = 0;
  /** The unfinished calls, which fail when the worker dies. */
  readonly #underWay = new Set<(problem: Died) => void>();

  constructor(
    first: RunningWorkbench,
    private readonly start: () => Promise<RunningWorkbench>,
    private readonly events: SupervisedEvents,
  ) {
    this.#worker = Promise.resolve(first);
    this.#watch(first);
    this.engine = callsBy<Engine>((name, given) => {
      // A replacement worker must get the model too.
      if (name === "openModel") return this.#openModel(...(given as Parameters<Engine["openModel"]>));
      type Call = (...given: unknown[]) => Promise<unknown>;
      return this.#ask((remote) => (remote[name] as Call)(...given));
    }) as Engine;
  }

  async #openModel(text: string, frames: number) {
    this.#revision += 1;
    const model = { text, frames, revision: this.#revision };
    const opened = await this.#ask((remote) => remote.openModel(text, frames, model.revision));
    // The answer for a later model may have arrived first.
    if (!this.#model || this.#model.revision < model.revision) this.#model = model;
    return opened;
  }

  /**
   * Calls the worker. If the worker dies during the call, the call is repeated once. A call that stops the
   * program is not repeated.
   */
  async #ask<Answer>(call: (remote: Remote) => Promise<Answer>, again = true): Promise<Answer> {
    const worker = await this.#worker;
    let fail: (problem: Died) => void = () => {};
    const died = new Promise<never>((_, reject) => {
      fail = reject;
    });
    this.#underWay.add(fail);
    try {
      return await Promise.race([call(worker.calls), died]);
    } catch (problem) {
      if (problem instanceof Died && again) return await this.#ask(call, false);
      if (problem instanceof Died) throw new Error(`the program stopped twice: ${problem.message}`);
      if (isTrap(problem)) this.#replace(worker, problem.message);
      throw problem;
    } finally {
      this.#underWay.delete(fail);
    }
  }

  #watch(worker: RunningWorkbench): void {
    worker.broken.catch((problem: Error) => this.#replace(worker, problem.message));
  }

  readonly #replaced = new WeakSet<RunningWorkbench>();

  /** Replaces a dead worker. Calls wait for the new worker. */
  #replace(dead: RunningWorkbench, why: string): void {
    if (this.#replaced.has(dead)) return;
    this.#replaced.add(dead);
    dead.dismiss();
    this.#early = performance.now() - this.#tookOver < SOON ? this.#early + 1 : 0;
    this.#worker = this.#takeOver(why);
    this.#worker.then(
      () => this.events.restarted(why),
      (problem: unknown) => this.events.stopped(problem),
    );
    for (const fail of [...this.#underWay]) fail(new Died(why));
  }

  async #takeOver(why: string): Promise<RunningWorkbench> {
    let problem: unknown = new Error(why);
    for (let attempt = this.#early; attempt < TAKE_OVERS; attempt += 1) {
      try {
        const worker = await this.#successor();
        this.#tookOver = performance.now();
        return worker;
      } catch (failure) {
        problem = failure;
      }
    }
    throw new Error(
      `The program could not be started again: ${TAKE_OVERS} workers in a row failed (${messageOf(problem)}).`,
    );
  }

  /** Starts a worker with the same model. The worker may die at each step. */
  async #successor(): Promise<RunningWorkbench> {
    const worker = await this.start();
    try {
      await Promise.race([this.#fill(worker.calls), worker.broken]);
    } catch (problem) {
      worker.dismiss();
      throw problem;
    }
    this.#watch(worker);
    return worker;
  }

  async #fill(remote: Remote): Promise<void> {
    const model = this.#model;
    if (model) await remote.openModel(model.text, model.frames, model.revision);
  }
}
