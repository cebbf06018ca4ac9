// The worker that shows models, started and kept alive. The page knows the model only through this.
import { messageOf } from "../ui/format";
import { loadPlayer, loadWholeWhenIdle } from "./programs";
import type { ClipCalls, Engine, SampleInfo, Workbench } from "./protocol";
import { nameOf, startIn } from "./running";
import { SupervisedEngine, type SupervisedEvents } from "./supervised";
import { clipCalls, type TrainingWorker, type WholeWorkers } from "./whole-workers";
import type { Pool } from "./pool";

export interface StartedEngine {
  engine: Engine;
  clips: ClipCalls;
  pool: Pool<TrainingWorker>;
  version: string;
  samples: SampleInfo[];
}

/** A worker that shows, and the answer of its start. */
async function startWorkbench(program: Promise<WebAssembly.Module>) {
  const name = nameOf("model");
  const worker = new Worker(new URL("../workers/player.ts", import.meta.url), { type: "module", name });
  const running = startIn<Workbench>(worker, name, program);
  try {
    return { running, ...(await Promise.race([running.ready, running.broken])) };
  } catch (problem) {
    running.dismiss();
    throw new Error(`its program could not be loaded (${messageOf(problem)}). Reloading the page may help.`);
  }
}

/**
 * Starts the worker that shows. The promise fails, with a sentence for the visitor, where wasm or workers are
 * missing.
 */
export async function startEngine(whole: WholeWorkers, events: SupervisedEvents): Promise<StartedEngine> {
  if (typeof WebAssembly !== "object") {
    throw new Error("this browser has no WebAssembly, which the model needs.");
  }
  if (self.origin === "null")
    throw new Error("browsers start no workers in a frame whose sandbox lacks allow-same-origin.");
  const program = loadPlayer();
  const { running, version, samples } = await startWorkbench(program);
  const restart = async () => (await startWorkbench(program)).running;
  const { engine } = new SupervisedEngine(running, restart, events);
  loadWholeWhenIdle();
  return { engine, clips: clipCalls(whole), pool: whole.pool, version, samples };
}
