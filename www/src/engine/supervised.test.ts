import { describe, expect, it, vi } from "vitest";
import type { LoadedClip, OpenedModel } from "./protocol";
import { type RemoteWorkbench, type RunningWorkbench, SupervisedEngine } from "./supervised";

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
  const running: RunningWorkbench = { remote: remote as unknown as RemoteWorkbench, broken, dismiss };
  return { remote, running, dismiss, die: (why: string) => die(new Error(why)) };
}

function supervised() {
  const workers = [worker(1), worker(10), worker(20), worker(30)];
  let at = 0;
  const events = { restarted: vi.fn(), failed: vi.fn() };
  const start = vi.fn(() => {
    at += 1;
    return Promise.resolve(workers[at]!.running);
  });
  const { engine } = new SupervisedEngine(workers[0]!.running, start, events);
  return {
    engine,
    workers: workers as [ReturnType<typeof worker>, ...ReturnType<typeof worker>[]],
    events,
    start,
  };
}

const settle = () => new Promise((done) => setTimeout(done));
const trap = () => Object.assign(new Error("unreachable"), { name: "RuntimeError" });

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
    await expect(engine.modelJson()).rejects.toThrow(
      /the program stopped \(unreachable\), perhaps for want of memory/,
    );
    expect(await engine.modelJson()).toBe("model");
    expect(workers[1]!.remote.modelJson).toHaveBeenCalledOnce();
    expect(events.restarted).toHaveBeenCalledOnce();
  });

  it("stays dead where no other starts, and says so", async () => {
    const { engine, workers, events, start } = supervised();
    start.mockRejectedValue(new Error("offline"));
    workers[0].die("it stopped");
    await settle();
    expect(events.failed).toHaveBeenCalledOnce();
    await expect(engine.modelJson()).rejects.toThrow("offline");
  });
});

it("an error of a question is the question's alone", async () => {
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
