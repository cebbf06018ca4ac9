// The workers of the whole program. The first work that is asked of one loads the program.
import type { Calls } from "./calls";
import { type Hired, Pool } from "./pool";
import { loadWhole } from "./programs";
import type { ClipCalls } from "./protocol";
import { nameOf, startIn } from "./running";
import type { WholeWorker } from "./whole-protocol";

/**
 * The calls of a worker of the whole program. When their signal comes, trainings keep the best so far, an
 * evaluation answers null, and a fold finds nothing.
 */
export type WholeCalls = Omit<Calls<WholeWorker>, "start">;

export type TrainingWorker = Pick<WholeCalls, "train" | "goOn">;

export interface WholeWorkers {
  /** For trainings: as many at once as the machine has cores. */
  pool: Pool<WholeCalls>;
  /** For short questions: answers at once, whatever the pool is doing. */
  desk: Pool<WholeCalls>;
  /** One worker, which holds the library of primitives that the page shows. */
  library: Pool<WholeCalls>;
}

function hire(): Hired<WholeCalls> {
  const name = nameOf("whole");
  const worker = new Worker(new URL("../workers/whole.ts", import.meta.url), { type: "module", name });
  const { calls, ...rest } = startIn<WholeWorker>(worker, name, loadWhole());
  return { worker: calls, ...rest };
}

/** The workers of a page. Each starts at its first work. */
export function hireWholeWorkers(): WholeWorkers {
  const cores = Math.max(1, navigator.hardwareConcurrency || 1);
  return { pool: new Pool(cores, hire), desk: new Pool(1, hire), library: new Pool(1, hire) };
}

/** The calls about clips, by the worker for short questions. */
export function clipCalls({ desk }: WholeWorkers): ClipCalls {
  return {
    readClip: (source) => desk.run((worker) => worker.readClip(source)),
    madeClips: () => desk.run((worker) => worker.madeClips()),
    checkTogether: (clips) => desk.run((worker) => worker.checkTogether(clips)),
    clipBvh: (clip) => desk.run((worker) => worker.clipBvh(clip)),
  };
}
