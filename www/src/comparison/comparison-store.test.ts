import { beforeEach, describe, expect, it, vi } from "vitest";
import type { ClipEntry } from "../clips/clips-store";
import { HeldWorkers } from "../engine/held.fake";
import type { PartSpec } from "../engine/protocol";
import type { Evaluated, ModelKind } from "../engine/whole-protocol";
import { initialSettings, type Settings } from "../settings/settings";
import { Store } from "../ui/store";
import { visitor } from "../unsaved/choice-dialog.fake";
import { smallClip } from "./small-clip.fake";
import { type ClipsNow, ComparisonStore, type EngineState, type SettingsNow } from "./comparison-store";

vi.mock("../unsaved/choice-dialog", () => import("../unsaved/choice-dialog.fake"));

class FakeEngine extends Store implements EngineState {
  state: EngineState["state"] = "ready";
}

class FakeSettings extends Store implements SettingsNow {
  values: Settings = { ...initialSettings(), framesPerSecond: 10, models: ["dmp-discrete", "dmp-rhythmic"] };
  change(change: Partial<Settings>): void {
    this.values = { ...this.values, ...change };
    this.changed();
  }
}

class FakeClips extends Store implements ClipsNow {
  #ids: number[] = [];
  samplesLoaded = true;
  clash = "";
  readonly parts: PartSpec[] = [{ name: "whole", joints: [0, 1] }];
  get ticked() {
    const info = { figure: { nodes: [{}, {}] }, joints: [] };
    return this.#ids.map((id) => ({ title: `Clip ${id}`, loaded: { info } }) as unknown as ClipEntry);
  }
  get toTrainOn() {
    return this.#ids.map((id) => ({ ...smallClip(id), title: `Clip ${id}` }));
  }
  tick(...ids: number[]): void {
    this.#ids = ids;
    this.changed();
  }
}

/** What the trainings of this file have found: each is done once. */
const known = new Map<string, Evaluated>();
let workers: HeldWorkers;
let settings: FakeSettings;
let clips: FakeClips;
let comparison: ComparisonStore;
beforeEach(() => {
  [workers, settings, clips] = [new HeldWorkers(), new FakeSettings(), new FakeClips()];
  workers.answer("evaluate", async (real, job, report, signal) => {
    const key = JSON.stringify(job);
    const found = (!signal.aborted && known.get(key)) || (await real(job, report, signal));
    if (found) known.set(key, found);
    return found;
  });
  clips.tick(1, 2, 3);
  visitor.arrives("discard");
  comparison = new ComparisonStore(new FakeEngine(), settings, clips, workers);
});

const FIRST = "dmp-discrete, 20 bases; trial 1 held out, 2 trained on, seed 0";
const states = () => comparison.shown?.jobs.map(({ state }) => state).join(" ");
const plans = () => workers.asked("planComparison").length;
const finished = () => comparison.shown?.results.finished.map(({ id }) => id) ?? [];
const trainings = () => workers.held("evaluate");

/** Lets the trainings from this one on go. */
function goOn(from = 0): void {
  workers.letGo("evaluate");
  for (const training of trainings().slice(from)) training.go();
}

/** Begins, and waits for the first trainings, which are held. */
async function begun(): Promise<{ over: Promise<void> }> {
  workers.hold("evaluate");
  const over = comparison.begin();
  await workers.settled();
  return { over };
}

/** The next outcomes cannot be added, for these reasons. */
function failToAdd(...reasons: string[]): void {
  workers.answer("addOutcome", (real, ...given) => {
    const reason = reasons.shift();
    if (reason) throw new Error(reason);
    return real(...given);
  });
}

/** The results of an earlier comparison in which the first of these clips was held out. */
async function savedResults(ids: number[], ...models: ModelKind[]): Promise<string> {
  const [others, those] = [new FakeSettings(), new FakeClips()];
  others.change({ models, heldOut: 0 });
  those.tick(...ids);
  const earlier = new ComparisonStore(new FakeEngine(), others, those, workers);
  await workers.settled();
  await earlier.begin();
  return earlier.shown?.results.text ?? "";
}

describe("a comparison", () => {
  it("holds out each trial in turn, and stores the result of each training", async () => {
    await comparison.begin();
    expect(comparison.ending.words).toBe("6 of 6 trainings done.");
    expect(finished()).toHaveLength(6);
    expect(comparison.shown?.predictions.size).toBe(6);
    expect([...(comparison.shown?.actual.keys() ?? [])]).toEqual([0, 1, 2]);
    const [predicted] = comparison.shown?.predictions.values() ?? [];
    const [first] = workers.asked("evaluate");
    expect(await predicted?.model?.text()).toBe(known.get(JSON.stringify(first?.[0]))?.model);
    await comparison.begin();
    expect(comparison.ending.words).toBe("All of this was finished before.");
  });

  it("runs a training on each worker, and reports the progress", async () => {
    expect(comparison.isPlanning).toBe(false);
    const { over } = await begun();
    expect([comparison.status, comparison.isPlanning]).toEqual(["running", false]);
    expect(states()).toBe("running running waiting waiting waiting waiting");
    trainings()[0]?.given[1](0.5);
    expect(comparison.shown?.jobs[0]?.fraction).toBe(0.5);
    goOn();
    await over;
    expect(comparison.status).toBe("idle");
  });

  it("keeps finished trainings when it is cancelled, and continues from there", async () => {
    const { over } = await begun();
    trainings()[0]?.go();
    await workers.settled();
    comparison.cancel();
    expect(comparison.status).toBe("cancelling");
    await over;
    expect(comparison.ending.words).toBe("1 of 6 trainings done; the others were cancelled.");
    expect(states()).toBe("done cancelled cancelled cancelled cancelled cancelled");
    expect(finished()).toEqual([FIRST]);
    workers.letGo("evaluate");
    await comparison.begin();
    expect(comparison.ending.words).toBe("5 of 5 trainings done.");
    expect(finished()).toHaveLength(6);
  });

  it("can be cancelled before it began", async () => {
    const over = comparison.begin();
    comparison.cancel();
    await over;
    expect(comparison.ending.words).toBe("You cancelled before it began.");
    expect([comparison.ending.failed, comparison.shown]).toEqual([false, null]);
  });

  it("continues when one training fails, and repeats that training the next time", async () => {
    const { over } = await begun();
    trainings()[0]?.fail(new Error("no period was found"));
    goOn(1);
    await over;
    expect(comparison.ending.words).toBe("5 of 6 trainings done, 1 failed.");
    expect(comparison.shown?.jobs[0]).toMatchObject({ state: "failed", why: "no period was found" });
    await comparison.begin();
    expect(comparison.ending.words).toBe("1 of 1 trainings done.");
  });

  it("continues when a worker dies during a training", async () => {
    const { over } = await begun();
    trainings()[0]?.die(new Error("out of memory"));
    goOn(1);
    await over;
    expect(comparison.ending.words).toBe("5 of 6 trainings done, 1 failed.");
  });

  it("loses no outcome when a worker dies while it adds one", async () => {
    const { over } = await begun();
    trainings()[0]?.go();
    await workers.settled();
    failToAdd("the worker stopped");
    goOn(1);
    await over;
    expect(comparison.ending.words).toBe("6 of 6 trainings done.");
    expect(finished()).toHaveLength(6);
    // The worker that follows knows no results: it gets the file.
    expect(workers.asked("addOutcome").filter(([from]) => typeof from === "string")).toHaveLength(2);
    const { text, finished: all } = comparison.shown!.results;
    expect((await workers.desk.run((worker) => worker.openResults(text))).finished).toEqual(all);
  });

  it("sends the file of the results once, and then only outcomes", async () => {
    await comparison.begin();
    expect(workers.asked("addOutcome").map(([from]) => typeof from)).toEqual([
      "string",
      ...Array(5).fill("number"),
    ]);
  });

  it("says why an outcome cannot be added, and keeps the others", async () => {
    const { over } = await begun();
    failToAdd("not finite", "not finite");
    goOn();
    await over;
    expect(comparison.ending.words).toBe("5 of 6 trainings done, 1 failed.");
    expect(comparison.shown?.jobs.find(({ state }) => state === "failed")?.why).toBe("not finite");
    expect(finished()).toHaveLength(5);
  });

  it("says why the program could not be loaded, and can begin again", async () => {
    workers.unreachable = "offline";
    await comparison.begin();
    const found = [comparison.ending.failed, comparison.ending.words, comparison.whyNot];
    expect(found).toEqual([true, "offline", ""]);
    workers.unreachable = "";
    await comparison.begin();
    expect([comparison.ending.failed, comparison.ending.words]).toEqual([false, "6 of 6 trainings done."]);
  });

  it("ignores settings that change while it runs", async () => {
    comparison.follow();
    const { over } = await begun();
    settings.change({ framesPerSecond: 5, models: ["dmp-discrete"] });
    clips.tick(1, 2);
    await workers.settled();
    goOn();
    await over;
    expect(comparison.ending.words).toBe("6 of 6 trainings done.");
    await workers.settled();
    expect(comparison.outlook).toMatchObject({ asked: 2, open: 2, goesOn: false });
    await comparison.begin();
    expect(finished()).toHaveLength(2);
    settings.change({ framesPerSecond: 10, models: ["dmp-discrete", "dmp-rhythmic"] });
    clips.tick(1, 2, 3);
    await workers.settled();
    expect(comparison.outlook).toMatchObject({ asked: 6, open: 0, goesOn: false });
    await comparison.begin();
    expect([comparison.ending.words, finished().length]).toEqual(["All of this was finished before.", 6]);
  });
});

describe("results that come with the page", () => {
  it("are shown until there are others, and are no unsaved work", async () => {
    const text = await savedResults([8, 9], "dmp-discrete");
    await comparison.showGiven(async () => text);
    expect([comparison.shown?.given, comparison.ending.words, comparison.unsaved]).toEqual([true, "", []]);
    comparison.follow();
    await workers.settled();
    expect(comparison.outlook?.goesOn).toBe(true);
    await comparison.begin();
    expect(comparison.shown?.given).toBe(false);
    const own = comparison.shown;
    await comparison.showGiven(async () => text);
    expect(comparison.shown).toBe(own);
  });

  it("do not replace a comparison that began meanwhile", async () => {
    const text = await savedResults([8, 9], "dmp-discrete");
    let come: (text: string) => void = () => {};
    const given = comparison.showGiven(() => new Promise((done) => (come = done)));
    const over = comparison.begin();
    come(text);
    await given;
    expect(comparison.busy).toBe(true);
    expect(comparison.shown?.given).not.toBe(true);
    await over;
  });
});

describe("the plan", () => {
  it("follows settings and clips while somebody listens", async () => {
    workers.answer("planComparison", async (real, ...given) => {
      const plan = await real(...given);
      return { ...plan, costs: plan.costs.map(() => ({ seconds: 60, bytes: 1e7 })) };
    });
    const stop = comparison.follow();
    await workers.settled();
    const cost = { words: "At most about 3 min.", absurd: false };
    expect(comparison.outlook).toEqual({ asked: 6, open: 6, goesOn: true, growth: false, cost });
    settings.change({ models: ["dmp-discrete"] });
    await workers.settled();
    expect(comparison.outlook?.asked).toBe(3);
    const asked = plans();
    settings.change({ plot: "3d" });
    await workers.settled();
    expect(plans()).toBe(asked);
    stop();
    clips.tick(1, 2);
    await workers.settled();
    expect(plans()).toBe(asked);
  });

  it("names what is missing for a comparison, without asking the program", async () => {
    comparison.follow();
    clips.tick(1);
    expect(comparison.whyNot).toMatch(/^Tick at least two clips/);
    clips.tick(1, 2);
    settings.change({ heldOut: 2 });
    expect(comparison.whyNot).toBe("There is no trial 3: 2 clips are ticked");
    settings.change({ heldOut: "each", models: [] });
    expect(comparison.whyNot).toBe("Tick at least one model");
    await workers.settled();
    expect([comparison.outlook, plans()]).toEqual([null, 1]);
  });

  it("gives the reason when the program refuses it", async () => {
    // Clip 11 has the motion of clip 1.
    clips.tick(1, 11);
    comparison.follow();
    await workers.settled();
    expect(comparison.whyNot).toMatch(/^trials 1 and 2 are the same motion/);
    expect(comparison.outlook).toBeNull();
    clips.tick(1, 2);
    await workers.settled();
    expect(comparison.whyNot).toBe("");
  });

  it("leaves Compare enabled when the program could not be loaded", async () => {
    workers.unreachable = "offline";
    comparison.follow();
    await workers.settled();
    expect([comparison.whyNot, comparison.outlook]).toEqual(["", null]);
  });

  it("drops the failed load when the machine is online again", async () => {
    workers.unreachable = "offline";
    comparison.follow();
    await comparison.begin();
    expect([comparison.ending.failed, comparison.ending.words]).toEqual([true, "offline"]);
    workers.unreachable = "";
    comparison.reconnected();
    await workers.settled();
    expect([comparison.ending.failed, comparison.ending.words]).toEqual([false, ""]);
    expect(comparison.outlook?.asked).toBeGreaterThan(0);
  });
});

describe("opened results", () => {
  const saved = () => savedResults([1, 2, 3], "dmp-discrete", "dmp-rhythmic");

  it("have no motions; on the same clips only the motions to show are computed again", async () => {
    comparison.follow();
    await comparison.open(await saved());
    await workers.settled();
    expect([comparison.ending.words, comparison.shown?.request]).toEqual(["2 results opened.", null]);
    expect(comparison.outlook).toMatchObject({ asked: 6, open: 6, goesOn: true });
    await comparison.begin();
    expect(comparison.ending.words).toBe("6 of 6 trainings done.");
    expect(finished()).toHaveLength(6);
    expect(comparison.shown?.predictions.size).toBe(6);
  });

  it("of another setting stay separate, and an unfinished comparison continues", async () => {
    const { over } = await begun();
    trainings()[0]?.go();
    await workers.settled();
    comparison.cancel();
    await over;
    workers.letGo("evaluate");
    const other = await savedResults([8, 9], "dmp-discrete");
    await comparison.open(other);
    expect(finished()).toEqual([FIRST.replace("2 trained", "1 trained")]);
    comparison.follow();
    await workers.settled();
    expect(comparison.outlook).toMatchObject({ open: 5, goesOn: false });
    await comparison.begin();
    expect([comparison.ending.words, finished().length]).toEqual(["5 of 5 trainings done.", 6]);
  });

  it("ask before the oldest of more than four comparisons is lost", async () => {
    for (const ids of [
      [1, 2],
      [1, 3],
      [2, 3],
      [1, 2, 3],
    ]) {
      clips.tick(...ids);
      await comparison.begin();
    }
    expect(visitor.asked).toEqual([]);
    visitor.answer = "keep";
    // Going on with one of them loses none.
    await comparison.begin();
    clips.tick(1, 4);
    await comparison.begin();
    expect(visitor.asked).toEqual([expect.stringContaining("a comparison of 4 trainings")]);
    expect(workers.asked("evaluate")).toHaveLength(3 * 4 + 6);
  });

  it("ask before they replace results that are on no disk", async () => {
    await comparison.open(await saved());
    await comparison.open(await saved());
    expect(visitor.asked).toEqual([]);
    await comparison.begin();
    const { shown } = comparison;
    visitor.answer = "keep";
    expect(await comparison.open(await saved())).toBe(false);
    expect([visitor.asked, comparison.shown]).toEqual([
      [expect.stringContaining("a comparison of 6 trainings")],
      shown,
    ]);
    visitor.answer = "discard";
    expect(await comparison.open(await saved())).toBe(true);
    // The results of an earlier visit are on no disk: neither a file nor another comparison may replace them
    // unasked.
    await comparison.open(await saved(), false);
    visitor.answer = "keep";
    clips.tick(1, 2);
    await comparison.begin();
    expect(comparison.shown?.request).toBeNull();
    expect(visitor.asked).toHaveLength(3);
    expect(comparison.unsaved).toContain(comparison.shown);
  });

  it("are refused while a comparison runs, also one that began meanwhile", async () => {
    const file = await saved();
    const opening = comparison.open(file);
    const over = comparison.begin();
    await expect(opening).rejects.toThrow("cancel it before opening");
    await expect(comparison.open(file)).rejects.toThrow("cancel it before opening");
    await over;
    expect(finished()).toHaveLength(6);
  });

  it("leave the shown results as they are when they cannot be opened", async () => {
    await comparison.begin();
    const { shown, ending } = comparison;
    await expect(comparison.open("{}")).rejects.toThrow("expected the results");
    expect([comparison.shown, comparison.ending]).toEqual([shown, ending]);
  });
});
