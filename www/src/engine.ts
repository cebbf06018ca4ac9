// Promises over the worker. The page knows the model only through this.
import * as Comlink from "comlink";
import type { Report, TrainingJob, TrainingOutcome, Workbench } from "./protocol";

type Remote = Comlink.Remote<Workbench>;

export type Engine = Omit<Remote, "train"> & {
  train(job: TrainingJob, report: Report): Promise<TrainingOutcome>;
};

/** Starts the worker. The promise fails, with words for a person, where wasm or workers are missing. */
export async function startEngine(): Promise<{
  engine: Engine;
  version: string;
  samples: Awaited<ReturnType<Remote["start"]>>["samples"];
}> {
  if (typeof WebAssembly !== "object") {
    throw new Error("this browser has no WebAssembly, which the model needs.");
  }
  const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module", name: "vcgpdm" });
  const broken = new Promise<never>((_, fail) => {
    worker.addEventListener("error", (event) => {
      fail(new Error(event.message || "the worker that computes it could not be started"));
    });
  });
  const remote = Comlink.wrap<Workbench>(worker);
  const { version, samples } = await Promise.race([remote.start(), broken]).catch((problem: unknown) => {
    const why = problem instanceof Error ? problem.message : String(problem);
    throw new Error(`its program could not be loaded (${why}). Reloading the page may help.`);
  });
  const engine = new Proxy(remote, {
    get(target, name) {
      if (name === "train") {
        return (job: TrainingJob, report: Report) =>
          target.train(job, Comlink.proxy(report));
      }
      if (name === "then") return undefined;
      return Reflect.get(target, name);
    },
  }) as unknown as Engine;
  return { engine, version, samples };
}
