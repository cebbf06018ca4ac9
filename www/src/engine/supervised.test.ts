import { describe, expect, it, vi } from "vitest";
import type { LoadedClip, OpenedModel } from "./protocol";
import { type RunningWorkbench, SupervisedEngine } from "./supervised";

/** A worker that answers, until it is killed. Its first clip has the number `from`. */
function worker(from: number) {
  let die: (problem: Error) => void = () => {};
  const broken = new Promise<never>((_, fail) => {
    die = fail;
  });
  broken.catch(() => {});
  let last = from - 1;
  const opened = () => {
    last += 1;
    return Promise.resolve({ id: last } as LoadedClip);
  };
  const remote = {
    sampleClip: vi.fn(opened),
    readClip: vi.fn((_name: string, _bytes: Uint8Array) => opened()),
    dropClip: vi.fn(() => Promise.resolve()),
    clipBvh: vi.fn((id: number) => Promise.resolve(`clip ${id}`)),
    checkTogether: vi.fn(() => Promise.resolve(null)),
    openModel: vi.fn((text: string, _frames: number, revision: number) =>
      Promise.resolve({ model: { revision, text } } as unknown as OpenedModel),
    ),
    modelJson: vi.fn(() => Promise.resolve("model")),
    rolloutBvh: vi.fn((): Promise<string> => new Promise(() => {})),
  };
  const dismiss = vi.fn();
  const calls = remote as unknown as RunningWorkbench["calls"];
  const running: RunningWorkbench = { calls, broken, dismiss };
  return { remote, running, dismiss, die: (why: string) => die(new Error(why)) };
}

type Worker = ReturnType<typeof worker>;

function supervised() {
  const workers = [worker(1), worker(10), worker(20), worker(30)];
  let at = 0;
  const events = { restarted: vi.fn(), stopped: vi.fn() };
  const start = vi.fn(() => {
    at += 1;
    return Promise.resolve(workers[at]!.running);
  });
  const { engine } = new SupervisedEngine(workers[0]!.running, start, events);
  return {
    engine,
    workers: workers as [Worker, ...Worker[]],
    events,
    start,
  };
}

const settle = () => new Promise((done) => setTimeout(done));
const trap = () => Object.assign(new Error("the program stopped"), { name: "RuntimeError" });

describe("a worker that dies", () => {
  it("is replaced by one that holds the same clips, under the same numbers, and the same model", async () => {
    const { engine, workers, events } = supervised();
    const one = await engine.sampleClip("walk-1");
    const two = await engine.readClip("own", new Uint8Array([1, 2, 3]));
    const three = await engine.sampleClip("walk-2");
    await engine.dropClip(one.id);
    const opened = await engine.openModel("a model", 300);
    workers[0].die("it stopped");
    await settle();
    expect(workers[0].dismiss).toHaveBeenCalledOnce();
    expect(events.restarted).toHaveBeenCalledExactlyOnceWith("it stopped");
    const { remote } = workers[1]!;
    expect(remote.readClip).toHaveBeenCalledWith("own", new Uint8Array([1, 2, 3]));
    expect(remote.sampleClip.mock.calls).toEqual([["walk-2"]]);
    expect(remote.openModel).toHaveBeenCalledWith("a model", 300, opened.model.revision);
    // The second clip is the first of the new worker.
    expect(await engine.clipBvh(two.id, 0, 1)).toBe("clip 10");
    expect(await engine.clipBvh(three.id, 0, 1)).toBe("clip 11");
    const next = await engine.sampleClip("walk-3");
    expect([one, two, three].map(({ id }) => id)).not.toContain(next.id);
  });

  it("is asked once more when it died over a question, and says so when it dies over it again", async () => {
    const { engine, workers, events } = supervised();
    workers[1]!.remote.rolloutBvh.mockResolvedValue("a motion");
    const first = engine.rolloutBvh({} as never);
    await settle();
    workers[0].die("it stopped");
    expect(await first).toBe("a motion");

    workers[1]!.remote.rolloutBvh.mockReturnValue(new Promise(() => {}));
    const second = engine.rolloutBvh({} as never);
    const refused = expect(second).rejects.toThrow(/stopped twice: no memory/);
    await settle();
    workers[1]!.die("no memory");
    await settle();
    workers[2]!.die("no memory");
    await refused;
    expect(events.restarted).toHaveBeenCalledTimes(3);
    expect(await engine.modelJson()).toBe("model");
  });

  it("is replaced too when its program traps, and what trapped is not asked again", async () => {
    const { engine, workers, events } = supervised();
    workers[0].remote.modelJson.mockRejectedValue(trap());
    await expect(engine.modelJson()).rejects.toThrow("the program stopped");
    expect(await engine.modelJson()).toBe("model");
    expect(workers[1]!.remote.modelJson).toHaveBeenCalledOnce();
    expect(events.restarted).toHaveBeenCalledOnce();
  });

  it("is not replaced after three failures in a row, and says so", async () => {
    const { engine, workers, events, start } = supervised();
    start.mockRejectedValue(new Error("offline"));
    workers[0].die("it stopped");
    await settle();
    expect(start).toHaveBeenCalledTimes(3);
    expect(events.stopped).toHaveBeenCalledOnce();
    expect(events.restarted).not.toHaveBeenCalled();
    await expect(engine.modelJson()).rejects.toThrow(/could not be started again.*\(offline\)/);
  });

  // A replacement reads all clips again, so it dies just then when memory is short.
  it.each(["reading a clip", "opening the model"])(
    "is replaced by a third when the second dies %s",
    async (step) => {
      const { engine, workers, events } = supervised();
      await engine.sampleClip("walk-1");
      await engine.openModel("a model", 300);
      const [first, second, third] = workers as [Worker, Worker, Worker];
      const never = () => new Promise<never>(() => {});
      if (step === "reading a clip") second.remote.sampleClip.mockImplementation(never);
      else second.remote.openModel.mockImplementation(never);
      first.die("it stopped");
      await settle();
      const json = engine.modelJson();
      expect(events.restarted).not.toHaveBeenCalled();
      second.die("no memory");
      expect(await json).toBe("model");
      expect(second.dismiss).toHaveBeenCalledOnce();
      expect(third.remote.sampleClip).toHaveBeenCalledWith("walk-1");
      expect(third.remote.openModel).toHaveBeenCalledWith("a model", 300, 1);
      expect(events.restarted).toHaveBeenCalledExactlyOnceWith("it stopped");
    },
  );

  it("says so when three replacements die in a row, and dismisses them all", async () => {
    const { engine, workers, events } = supervised();
    await engine.sampleClip("walk-1");
    for (const { remote } of workers.slice(1)) remote.sampleClip.mockRejectedValue(trap());
    workers[0].die("it stopped");
    await settle();
    await expect(engine.modelJson()).rejects.toThrow(/3 workers in a row failed \(the program stopped\)/);
    expect(events.stopped).toHaveBeenCalledOnce();
    for (const { dismiss } of workers) expect(dismiss).toHaveBeenCalledOnce();
  });
});

it("an error of a call does not end the worker", async () => {
  const { engine, workers, events } = supervised();
  workers[0].remote.modelJson.mockRejectedValue(new Error("There is no model yet."));
  await expect(engine.modelJson()).rejects.toThrow("There is no model yet.");
  expect(events.restarted).not.toHaveBeenCalled();
});

it("a clip that kills its worker is not read again", async () => {
  const { engine, workers } = supervised();
  workers[0].remote.readClip.mockRejectedValue(trap());
  await expect(engine.readClip("bad", new Uint8Array())).rejects.toThrow(/stopped/);
  await engine.modelJson();
  expect(workers[1]!.remote.readClip).not.toHaveBeenCalled();
});
