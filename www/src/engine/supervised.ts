// The worker that shows, kept alive: when it dies it is started anew, with the clips and the model that it
// held. Knows no worker.
import type { Engine, LoadedClip, Workbench } from "./protocol";

/** Each call to the worker answers with a promise. */
export type RemoteWorkbench = {
  [Call in Exclude<keyof Workbench, "start">]: (
    ...args: Parameters<Workbench[Call]>
  ) => Promise<ReturnType<Workbench[Call]>>;
};

/** A worker that has started. */
export interface RunningWorkbench {
  remote: RemoteWorkbench;
  /** Fails, with words for a person, when the worker dies. */
  broken: Promise<never>;
  dismiss(): void;
}

export interface SupervisedEvents {
  /** The worker stopped, for this reason; another has taken its place and holds what it held. */
  restarted(why: string): void;
  /** No other worker could take its place. */
  failed(problem: unknown): void;
}

/** A program that has stopped in the middle of something: what it holds is no longer to be trusted. */
export const isTrap = (problem: unknown): problem is Error =>
  problem instanceof Error &&
  (problem.name === "RuntimeError" || (problem.name === "RangeError" && /call stack/.test(problem.message)));

/** The worker died while it was asked. */
class Died extends Error {}

/** What is passed on as it is; the others are about what the worker holds. */
const STATELESS: Record<
  Exclude<keyof Engine, "readClip" | "sampleClip" | "dropClip" | "checkTogether" | "clipBvh" | "openModel">,
  true
> = {
  freshSeed: true,
  bestToShow: true,
  trainingCost: true,
  rollout: true,
  inducing: true,
  modelJson: true,
  rolloutBvh: true,
  bodyReport: true,
  predictions: true,
  futures: true,
  startLive: true,
  advanceLive: true,
  endLive: true,
};

export class SupervisedEngine {
  readonly engine: Engine;
  readonly #start: () => Promise<RunningWorkbench>;
  readonly #events: SupervisedEvents;
  #worker: Promise<RunningWorkbench>;
  /** The clips by the page's numbers, which stay when another worker gives them others. */
  readonly #clips = new Map<
    number,
    { inWorker: number; read(remote: RemoteWorkbench): Promise<LoadedClip> }
  >();
  #lastClip = 0;
  #model: { text: string; frames: number; revision: number } | null = null;
  #revision = 0;
  /** The questions under way, which fail when the worker dies. */
  readonly #asked = new Set<(problem: Died) => void>();

  constructor(first: RunningWorkbench, start: () => Promise<RunningWorkbench>, events: SupervisedEvents) {
    this.#start = start;
    this.#events = events;
    this.#worker = Promise.resolve(first);
    this.#watch(first);
    const ask =
      (call: keyof typeof STATELESS) =>
      (...given: unknown[]) =>
        this.#ask((remote) => (remote[call] as (...given: unknown[]) => Promise<unknown>)(...given));
    const calls = Object.keys(STATELESS) as (keyof typeof STATELESS)[];
    this.engine = {
      ...(Object.fromEntries(calls.map((call) => [call, ask(call)])) as Pick<Engine, keyof typeof STATELESS>),
      readClip: (name, bytes) => {
        const file = new Blob([bytes as Uint8Array<ArrayBuffer>]);
        return this.#addClip(async (remote) =>
          remote.readClip(name, new Uint8Array(await file.arrayBuffer())),
        );
      },
      sampleClip: (id) => this.#addClip((remote) => remote.sampleClip(id)),
      dropClip: async (id) => {
        const known = this.#clips.get(id);
        this.#clips.delete(id);
        if (known) await this.#ask((remote) => remote.dropClip(known.inWorker));
      },
      checkTogether: (ids, firstBones) =>
        this.#ask((remote) => remote.checkTogether(ids.map(this.#inWorker), firstBones)),
      clipBvh: (id, first, end) => this.#ask((remote) => remote.clipBvh(this.#inWorker(id), first, end)),
      openModel: (text, frames) => this.#openModel(text, frames),
    };
  }

  readonly #inWorker = (id: number): number => this.#clips.get(id)?.inWorker ?? id;

  async #addClip(read: (remote: RemoteWorkbench) => Promise<LoadedClip>): Promise<LoadedClip> {
    const loaded = await this.#ask(read);
    this.#lastClip += 1;
    const id = this.#lastClip;
    this.#clips.set(id, { inWorker: loaded.id, read });
    return { ...loaded, id };
  }

  async #openModel(text: string, frames: number) {
    this.#revision += 1;
    const model = { text, frames, revision: this.#revision };
    const opened = await this.#ask((remote) => remote.openModel(text, frames, model.revision));
    // What is asked for later and answered earlier stays.
    if (!this.#model || this.#model.revision < model.revision) this.#model = model;
    return opened;
  }

  /**
   * Asks the worker. A question during which it dies is asked once more; one that stops the program is not.
   */
  async #ask<Answer>(question: (remote: RemoteWorkbench) => Promise<Answer>, again = true): Promise<Answer> {
    const worker = await this.#worker;
    let fail: (problem: Died) => void = () => {};
    const died = new Promise<never>((_, reject) => {
      fail = reject;
    });
    this.#asked.add(fail);
    try {
      return await Promise.race([question(worker.remote), died]);
    } catch (problem) {
      if (problem instanceof Died && again) return await this.#ask(question, false);
      if (problem instanceof Died) throw new Error(`the program stopped twice: ${problem.message}`);
      if (!isTrap(problem)) throw problem;
      const why = `the program stopped (${problem.message}), perhaps for want of memory`;
      this.#replace(worker, why);
      throw new Error(`${why}.`);
    } finally {
      this.#asked.delete(fail);
    }
  }

  #watch(worker: RunningWorkbench): void {
    worker.broken.catch((problem: Error) => this.#replace(worker, problem.message));
  }

  readonly #replaced = new WeakSet<RunningWorkbench>();

  /** Another worker takes over; questions wait for it. */
  #replace(dead: RunningWorkbench, why: string): void {
    if (this.#replaced.has(dead)) return;
    this.#replaced.add(dead);
    dead.dismiss();
    this.#worker = this.#takeOver();
    this.#worker.then(
      () => this.#events.restarted(why),
      (problem: unknown) => this.#events.failed(problem),
    );
    for (const fail of [...this.#asked]) fail(new Died(why));
  }

  async #takeOver(): Promise<RunningWorkbench> {
    const worker = await this.#start();
    for (const clip of this.#clips.values()) clip.inWorker = (await clip.read(worker.remote)).id;
    const model = this.#model;
    if (model) await worker.remote.openModel(model.text, model.frames, model.revision);
    this.#watch(worker);
    return worker;
  }
}
