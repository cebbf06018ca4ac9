import { describe, expect, it, vi } from "vitest";
import type { OpenedModel } from "./protocol";
import { type RunningWorkbench, SupervisedEngine } from "./supervised";

/** A worker that answers, until it is killed. */
function worker() {
  let die: (problem: Error) => void = () => {};
  const broken = new Promise<never>((_, fail) => {
    die = fail;
  });
  broken.catch(() => {});
  const remote = {
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
  const workers = [worker(), worker(), worker(), worker()];
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
  it("is replaced by one that holds the same model", async () => {
    const { engine, workers, events } = supervised();
    const opened = await engine.openModel("a model", 300);
    workers[0].die("it stopped");
    await settle();
    expect(workers[0].dismiss).toHaveBeenCalledOnce();
    expect(events.restarted).toHaveBeenCalledExactlyOnceWith("it stopped");
    expect(workers[1]!.remote.openModel).toHaveBeenCalledWith("a model", 300, opened.model.revision);
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

  it("is not replaced for ever when each replacement dies soon", async () => {
    const { engine, workers, events } = supervised();
    for (const { die } of workers) {
      die("no memory");
      await settle();
    }
    expect(events.restarted).toHaveBeenCalledTimes(3);
    await expect(engine.modelJson()).rejects.toThrow(/3 workers in a row failed \(no memory\)/);
  });

  // A replacement opens the model again, so it dies just then when memory is short.
  it("is replaced by a third when the second dies opening the model", async () => {
    const { engine, workers, events } = supervised();
    await engine.openModel("a model", 300);
    const [first, second, third] = workers as [Worker, Worker, Worker];
    second.remote.openModel.mockImplementation(() => new Promise<never>(() => {}));
    first.die("it stopped");
    await settle();
    const json = engine.modelJson();
    expect(events.restarted).not.toHaveBeenCalled();
    second.die("no memory");
    expect(await json).toBe("model");
    expect(second.dismiss).toHaveBeenCalledOnce();
    expect(third.remote.openModel).toHaveBeenCalledWith("a model", 300, 1);
    expect(events.restarted).toHaveBeenCalledExactlyOnceWith("it stopped");
  });

  it("says so when three replacements die in a row, and dismisses them all", async () => {
    const { engine, workers, events } = supervised();
    await engine.openModel("a model", 300);
    for (const { remote } of workers.slice(1)) remote.openModel.mockRejectedValue(trap());
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

it("a model that kills its worker is not opened again", async () => {
  const { engine, workers } = supervised();
  workers[0].remote.openModel.mockRejectedValue(trap());
  await expect(engine.openModel("bad", 300)).rejects.toThrow(/stopped/);
  await engine.modelJson();
  expect(workers[1]!.remote.openModel).not.toHaveBeenCalled();
});
