// The calls of a worker as promises.
import * as Comlink from "comlink";
import "./transfers";

/** A worker's interface as the page sees it: each call answers with a promise. */
export type Calls<Face> = {
  [Call in keyof Face]: Face[Call] extends (...given: infer Given) => infer Answer
    ? (...given: Given) => Promise<Awaited<Answer>>
    : never;
};

/** Answers every call by `ask`. A call needs no entry in a list: its name is the property that is read. */
export function callsBy<Face>(ask: (name: keyof Face, given: unknown[]) => Promise<unknown>): Calls<Face> {
  return new Proxy({} as Calls<Face>, {
    // A promise that resolves to this object asks whether the object has a `then`.
    get: (_, name) => (name === "then" ? undefined : (...given: unknown[]) => ask(name as keyof Face, given)),
  });
}

/** The calls of a worker. An abort signal ends a call early; `transfers.ts` carries it over. */
export function callsOf<Face>(worker: Worker): Calls<Face> {
  const remote = Comlink.wrap(worker) as unknown as Record<
    keyof Face,
    (...given: unknown[]) => Promise<unknown>
  >;
  return callsBy(async (name, given) => {
    for (const value of given) if (value instanceof AbortSignal) value.throwIfAborted();
    return await remote[name](...given);
  });
}
