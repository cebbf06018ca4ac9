import { afterEach, expect, it, type MockInstance, vi } from "vitest";
import { type Hired, Pool } from "./pool";

interface Fake {
  name: number;
  dismissed: boolean;
  die(problem: Error): void;
}

/** A pool of workers that do nothing themselves, and the work it was given. */
function scene(
  width: number,
  grace?: number,
  ready: (name: number) => Promise<unknown> = () => Promise.resolve(),
) {
  const workers: Fake[] = [];
  const begun: {
    job: string;
    worker: Fake;
    end: (result: string) => void;
    fail: (problem: Error) => void;
  }[] = [];
  const listened: MockInstance[] = [];
  const hire = (): Hired<Fake> => {
    let die = (_: Error) => {};
    const broken = new Promise<never>((_, fail) => (die = fail));
    listened.push(vi.spyOn(broken, "then"));
    const worker: Fake = { name: workers.length, dismissed: false, die };
    workers.push(worker);
    return { worker, ready: ready(worker.name), broken, dismiss: () => (worker.dismissed = true) };
  };
  const pool = new Pool(width, hire, grace);
  const ends = new Map<string, string>();
  const ask = (job: string, signal?: AbortSignal, on: Fake | null = null) => {
    const work = (worker: Fake) => new Promise<string>((end, fail) => begun.push({ job, worker, end, fail }));
    void pool.run(work, signal, on).then(
      (result) => ends.set(job, result),
      (problem: Error) => ends.set(job, `failed: ${problem.message}`),
    );
  };
  const under = () => begun.map(({ job }) => job).join("");
  const at = (job: string) => begun.find((one) => one.job === job)!;
  return {
    pool,
    workers,
    ask,
    begun: under,
    at,
    ends,
    listeners: () => listened.flatMap(({ mock }) => mock.calls).length,
  };
}

const settle = async () => {
  for (let i = 0; i < 12; i++) await Promise.resolve();
};

afterEach(() => void vi.useRealTimers());

it("gives a free worker to the task that has the fewest", async () => {
  const { ask, begun, at } = scene(2);
  const [comparison, training] = [new AbortController().signal, new AbortController().signal];
  for (const job of "abcd") ask(job, comparison);
  for (const job of "xy") ask(job, training);
  await settle();
  expect(begun()).toBe("ab");
  at("a").end("A");
  await settle();
  expect(begun()).toBe("abx");
  at("b").end("B");
  await settle();
  expect(begun()).toBe("abxc");
});

it("works in the order of asking, on no more workers than it is wide, and starts none before it has work", async () => {
  const { workers, ask, begun, at, ends } = scene(2);
  expect(workers).toHaveLength(0);
  for (const job of "abcd") ask(job);
  await settle();
  expect(begun()).toBe("ab");
  expect(at("a").worker).not.toBe(at("b").worker);
  at("b").end("B");
  await settle();
  expect(begun()).toBe("abc");
  expect(at("c").worker).toBe(at("b").worker);
  at("a").end("A");
  at("c").end("C");
  await settle();
  at("d").end("D");
  await settle();
  expect([...ends]).toEqual([
    ["b", "B"],
    ["a", "A"],
    ["c", "C"],
    ["d", "D"],
  ]);
  expect(workers).toHaveLength(2);
});

it("keeps one worker for later and gives the others back", async () => {
  const { workers, ask, at } = scene(3);
  for (const job of "abc") ask(job);
  await settle();
  for (const job of "abc") at(job).end("");
  await settle();
  expect(workers.filter(({ dismissed }) => !dismissed)).toHaveLength(1);
  ask("d");
  await settle();
  expect(workers).toHaveLength(3);
  expect(at("d").worker.dismissed).toBe(false);
});

it("drops what waits at an abort, and lets what is under way come to its own end", async () => {
  const { ask, begun, at, ends } = scene(1);
  const abort = new AbortController();
  ask("a", abort.signal);
  ask("b", abort.signal);
  ask("c");
  await settle();
  abort.abort(new Error("enough"));
  await settle();
  expect([...ends]).toEqual([["b", "failed: enough"]]);
  at("a").end("the best so far");
  await settle();
  expect(ends.get("a")).toBe("the best so far");
  expect(begun()).toBe("ac");
  ask("d", abort.signal);
  await settle();
  expect(ends.get("d")).toBe("failed: enough");
});

it("fails only the work that failed, and gives the next a fresh worker", async () => {
  const { workers, ask, at, ends } = scene(1);
  ask("a");
  ask("b");
  await settle();
  at("a").fail(new Error("no such clip"));
  await settle();
  expect(ends.get("a")).toBe("failed: no such clip");
  expect(workers[0]!.dismissed).toBe(true);
  at("b").end("B");
  await settle();
  expect(ends.get("b")).toBe("B");
  expect(at("b").worker).toBe(workers[1]);
});

it("fails the work of a worker that dies, and goes on", async () => {
  const { workers, ask, at, ends } = scene(2);
  for (const job of "abc") ask(job);
  await settle();
  workers[0]!.die(new Error("out of memory"));
  await settle();
  expect([...ends]).toEqual([["a", "failed: out of memory"]]);
  at("b").end("B");
  at("c").end("C");
  await settle();
  expect([...ends.values()]).toEqual(["failed: out of memory", "B", "C"]);
  expect(at("c").worker).toBe(workers[2]);
});

it("gives no work to a worker that died while it was idle", async () => {
  const { workers, ask, at, ends } = scene(1);
  ask("a");
  await settle();
  at("a").end("A");
  await settle();
  workers[0]!.die(new Error("gone"));
  await settle();
  ask("b");
  await settle();
  at("b").end("B");
  await settle();
  expect(ends.get("b")).toBe("B");
  expect(at("b").worker).toBe(workers[1]);
});

it("goes on when a worker does not start", async () => {
  const { ask, at, ends } = scene(1, undefined, (name) =>
    name === 0 ? Promise.reject(new Error("no memory")) : Promise.resolve(),
  );
  ask("a");
  ask("b");
  await settle();
  expect(ends.get("a")).toBe("failed: no memory");
  at("b").end("B");
  await settle();
  expect(ends.get("b")).toBe("B");
});

it("waits for aborted work only so long", async () => {
  vi.useFakeTimers();
  const { workers, ask, ends } = scene(1, 5000);
  const abort = new AbortController();
  ask("a", abort.signal);
  await settle();
  abort.abort();
  await vi.advanceTimersByTimeAsync(4900);
  expect(ends.size).toBe(0);
  await vi.advanceTimersByTimeAsync(200);
  expect(ends.get("a")).toBe("failed: the worker did not stop within 5 seconds.");
  expect(workers[0]!.dismissed).toBe(true);
});

it("keeps a worker for the work that names it, and for no other", async () => {
  const { pool, workers, ask, begun, at, ends } = scene(2);
  ask("a");
  await settle();
  const { worker } = at("a");
  pool.keep(worker);
  at("a").end("A");
  await settle();
  for (const job of "bc") ask(job);
  await settle();
  expect([at("b").worker, at("c").worker].includes(worker)).toBe(false);
  ask("d", undefined, worker);
  ask("e");
  at("b").end("B");
  await settle();
  expect([begun(), at("d").worker]).toEqual(["abcd", worker]);
  for (const job of "cd") at(job).end(job);
  await settle();
  at("e").end("E");
  await settle();
  // The one that is kept stays, and one more for the next work.
  expect([worker.dismissed, workers.filter(({ dismissed }) => !dismissed).length]).toEqual([false, 2]);
  pool.letGo(worker);
  expect(workers.filter(({ dismissed }) => !dismissed)).toHaveLength(1);
  ask("f", undefined, worker);
  await settle();
  expect(ends.get("f")).toBe("failed: the worker that trained it is gone.");
});

it("no longer keeps a worker that died", async () => {
  const { pool, ask, at } = scene(1);
  ask("a");
  await settle();
  const { worker } = at("a");
  pool.keep(worker);
  at("a").end("A");
  await settle();
  worker.die(new Error("out of memory"));
  await settle();
  expect([pool.keeps(worker), worker.dismissed]).toEqual([false, true]);
});

it("listens once to whether a worker dies, so that what came of its work is not kept while it lives", async () => {
  const { workers, ask, at, ends, listeners } = scene(1);
  for (const job of "abc") {
    ask(job);
    await settle();
    at(job).end(job);
    await settle();
  }
  expect([workers.length, ends.size, listeners()]).toEqual([1, 3, 1]);
  ask("d");
  await settle();
  workers[0]?.die(new Error("out of memory"));
  await settle();
  expect(ends.get("d")).toBe("failed: out of memory");
});
