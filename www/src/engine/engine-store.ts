// Whether the model can be computed here, and by whom.
import { messageOf } from "../ui/format";
import { Store } from "../ui/store";
import type { StartedEngine } from "./engine";
import type { Pool } from "./pool";
import type { ClipCalls, Engine, SampleInfo } from "./protocol";
import type { TrainingWorker } from "./whole-workers";

/** "stopped": it worked, but the program cannot be started again in this visit. */
export type EngineState = "loading" | "ready" | "failed" | "stopped";

export class EngineStore extends Store {
  #state: EngineState = "loading";
  #problem = "";
  #started: StartedEngine | null = null;

  get state(): EngineState {
    return this.#state;
  }

  /** Why it cannot be computed here, as a sentence for the visitor. */
  get problem(): string {
    return this.#problem;
  }

  /** The worker that shows; null until it has started. */
  get engine(): Engine | null {
    return this.#started?.engine ?? null;
  }

  /** The worker that reads clips. */
  get clips(): ClipCalls | null {
    return this.#started?.clips ?? null;
  }

  /** The workers that train. */
  get pool(): Pool<TrainingWorker> | null {
    return this.#started?.pool ?? null;
  }

  /** Clips that the engine can make itself. */
  get samples(): readonly SampleInfo[] {
    return this.#started?.samples ?? [];
  }

  get version(): string {
    return this.#started?.version ?? "";
  }

  /** Starts the engine; it is ready when `prepare` is done too. */
  async start(start: () => Promise<StartedEngine>, prepare: () => Promise<void>): Promise<void> {
    try {
      this.#started = await start();
      await prepare();
      this.#state = "ready";
      this.changed();
    } catch (problem) {
      this.fail(problem);
    }
  }

  fail(problem: unknown): void {
    this.#end("failed", problem);
  }

  stop(problem: unknown): void {
    this.#end("stopped", problem);
  }

  #end(state: EngineState, problem: unknown): void {
    this.#state = state;
    this.#problem = messageOf(problem);
    this.changed();
  }
}
