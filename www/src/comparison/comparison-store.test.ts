import { beforeEach, describe, expect, it, vi } from "vitest";
import type { ClipEntry } from "../clips/clips-store";
import type { PartSpec } from "../engine/protocol";
import { clip, evaluated, FakeProgram, savedResults, settled } from "../engine/whole-workers.fake";
import { initialSettings, type Settings } from "../settings/settings";
import { Store } from "../ui/store";
import { visitor } from "../unsaved/choice-dialog.fake";
import { type ClipsNow, ComparisonStore, type EngineState, type SettingsNow } from "./comparison-store";

vi.mock("../unsaved/choice-dialog", () => import("../unsaved/choice-dialog.fake"));

class FakeEngine extends Store implements EngineState {
  state: EngineState["state"] = "ready";
}

class FakeSettings extends Store implements SettingsNow {
  values: Settings = { ...initialSettings(), models: ["tmp", "dmp-rhythmic"] };
  change(change: Partial<Settings>): void {
    this.values = { ...this.values, ...change };
    this.changed();
  }
}

class FakeClips extends Store implements ClipsNow {
  #ids: number[] = [];
  samplesLoaded = true;
  clash = "";
  readonly parts: PartSpec[] = [{ name: "whole", joints: [0] }];
  get ticked() {
    const info = { figure: { nodes: [{}, {}] }, joints: [] };
    return this.#ids.map((id) => ({ title: `Clip ${id}`, loaded: { info } }) as unknown as ClipEntry);
  }
  get toTrainOn() {
    return this.#ids.map((id) => ({ ...clip(id), title: `Clip ${id}` }));
  }
  tick(...ids: number[]): void {
    this.#ids = ids;
    this.changed();
  }
}

let program: FakeProgram;
let settings: FakeSettings;
let clips: FakeClips;
let comparison: ComparisonStore;
beforeEach(() => {
  [program, settings, clips] = [new FakeProgram(), new FakeSettings(), new FakeClips()];
  clips.tick(1, 2, 3);
  visitor.arrives("discard");
  comparison = new ComparisonStore(new FakeEngine(), settings, clips, program);
});

const states = () => comparison.shown?.jobs.map(({ state }) => state).join(" ");
const finished = () => comparison.shown?.results.finished.map(({ id }) => id) ?? [];

/** Ends all trainings with success, until none runs. */
async function endAll(): Promise<void> {
  await settled();
  for (let next = program.evaluations.shift(); next; next = program.evaluations.shift()) {
    next.end(evaluated);
    await settled();
  }
}

async function compare(): Promise<void> {
  const over = comparison.begin();
  await endAll();
  await over;
}

describe("a comparison", () => {
  it("holds out each trial in turn, and stores the result of each training", async () => {
    await compare();
    expect(comparison.ending.words).toBe("6 of 6 trainings done.");
    expect(finished()).toHaveLength(6);
    expect(comparison.shown?.predictions.size).toBe(6);
    expect([...(comparison.shown?.actual.keys() ?? [])]).toEqual([0, 1, 2]);
    const [predicted] = comparison.shown?.predictions.values() ?? [];
    expect(await predicted?.model?.text()).toBe(evaluated.model);
    await compare();
    expect(comparison.ending.words).toBe("All of this was finished before.");
  });

  it("runs a training on each worker, and reports the progress", async () => {
    const over = comparison.begin();
    await settled();
    expect(comparison.status).toBe("running");
    expect(states()).toBe("running running waiting waiting waiting waiting");
    program.evaluations[0]?.report(0.5);
    expect(comparison.shown?.jobs[0]?.fraction).toBe(0.5);
    await endAll();
    await over;
    expect(comparison.status).toBe("idle");
  });

  it("keeps finished trainings when it is cancelled, and continues from there", async () => {
    const over = comparison.begin();
    await settled();
    program.evaluations.shift()?.end(evaluated);
    await settled();
    comparison.cancel();
    expect(comparison.status).toBe("cancelling");
    await over;
    expect(comparison.ending.words).toBe("1 of 6 trainings done; the others were cancelled.");
    expect(states()).toBe("done cancelled cancelled cancelled cancelled cancelled");
    expect(finished()).toEqual(["tmp 1 of 2 seed 0"]);
    program.evaluations.length = 0;
    await compare();
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
    const over = comparison.begin();
    await settled();
    program.evaluations.shift()?.fail(new Error("no period was found"));
    await endAll();
    await over;
    expect(comparison.ending.words).toBe("5 of 6 trainings done, 1 failed.");
    expect(comparison.shown?.jobs[0]).toMatchObject({ state: "failed", why: "no period was found" });
    await compare();
    expect(comparison.ending.words).toBe("1 of 1 trainings done.");
  });

  it("continues when a worker dies during a training", async () => {
    const over = comparison.begin();
    await settled();
    program.evaluations.shift()?.die(new Error("out of memory"));
    await endAll();
    await over;
    expect(comparison.ending.words).toBe("5 of 6 trainings done, 1 failed.");
  });

  it("loses no outcome when a worker dies while it adds one", async () => {
    const over = comparison.begin();
    await settled();
    program.evaluations.shift()?.end(evaluated);
    await settled();
    program.failures.push(new Error("the worker stopped"));
    await endAll();
    await over;
    expect(comparison.ending.words).toBe("6 of 6 trainings done.");
    expect(finished()).toHaveLength(6);
    const { jobs } = JSON.parse(comparison.shown?.results.text ?? "{}");
    expect(jobs).toEqual(comparison.shown?.results.finished.map(({ job }) => job));
  });

  it("sends the file of the results once, and then only outcomes", async () => {
    await compare();
    expect(program.sent.map((from) => typeof from)).toEqual(["string", ...Array(5).fill("number")]);
  });

  it("says why an outcome cannot be added, and keeps the others", async () => {
    const over = comparison.begin();
    await settled();
    program.failures.push(new Error("not finite"), new Error("not finite"));
    await endAll();
    await over;
    expect(comparison.ending.words).toBe("5 of 6 trainings done, 1 failed.");
    expect(comparison.shown?.jobs.find(({ state }) => state === "failed")?.why).toBe("not finite");
    expect(finished()).toHaveLength(5);
  });

  it("says why the program could not be loaded, and can begin again", async () => {
    program.unreachable = "offline";
    await comparison.begin();
    const found = [comparison.ending.failed, comparison.ending.words, comparison.whyNot];
    expect(found).toEqual([true, "offline", ""]);
    program.unreachable = "";
    await compare();
    expect([comparison.ending.failed, comparison.ending.words]).toEqual([false, "6 of 6 trainings done."]);
  });

  it("ignores settings that change while it runs", async () => {
    comparison.follow();
    const over = comparison.begin();
    await settled();
    settings.change({ framesPerSecond: 10, models: ["tmp"] });
    clips.tick(1, 2);
    await endAll();
    await over;
    expect(comparison.ending.words).toBe("6 of 6 trainings done.");
    await settled();
    expect(comparison.outlook).toMatchObject({ asked: 2, open: 2, goesOn: false });
    await compare();
    expect(finished()).toHaveLength(2);
    settings.change({ framesPerSecond: 30, models: ["tmp", "dmp-rhythmic"] });
    clips.tick(1, 2, 3);
    await settled();
    expect(comparison.outlook).toMatchObject({ asked: 6, open: 0, goesOn: false });
    await compare();
    expect([comparison.ending.words, finished().length]).toEqual(["All of this was finished before.", 6]);
  });
});

describe("results that come with the page", () => {
  it("are shown until there are others, and are no unsaved work", async () => {
    const text = savedResults([clip(8), clip(9)], { parts: clips.parts, framesPerSecond: 30 }, ["tmp"]);
    await comparison.showGiven(async () => text);
    expect([comparison.shown?.given, comparison.ending.words, comparison.unsaved]).toEqual([true, "", []]);
    comparison.follow();
    await settled();
    expect(comparison.outlook?.goesOn).toBe(true);
    await compare();
    expect(comparison.shown?.given).toBe(false);
    const own = comparison.shown;
    await comparison.showGiven(async () => text);
    expect(comparison.shown).toBe(own);
  });

  it("do not replace a comparison that began meanwhile", async () => {
    let come: (text: string) => void = () => {};
    const given = comparison.showGiven(() => new Promise((done) => (come = done)));
    const over = comparison.begin();
    come(savedResults([clip(8), clip(9)], { parts: clips.parts, framesPerSecond: 30 }, ["tmp"]));
    await given;
    expect(comparison.shown?.given).not.toBe(true);
    await endAll();
    await over;
  });
});

describe("the plan", () => {
  it("follows settings and clips while somebody listens", async () => {
    const stop = comparison.follow();
    await settled();
    const cost = { words: "At most about 3 min.", absurd: false };
    expect(comparison.outlook).toEqual({ asked: 6, open: 6, goesOn: true, growth: false, cost });
    settings.change({ models: ["tmp"] });
    await settled();
    expect(comparison.outlook?.asked).toBe(3);
    const asked = program.plans;
    settings.change({ plot: "3d" });
    await settled();
    expect(program.plans).toBe(asked);
    stop();
    clips.tick(1, 2);
    await settled();
    expect(program.plans).toBe(asked);
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
    await settled();
    expect([comparison.outlook, program.plans]).toEqual([null, 1]);
  });

  it("gives the reason when the program refuses it", async () => {
    program.refused = "trials 1 and 2 are the same motion";
    comparison.follow();
    await settled();
    expect([comparison.whyNot, comparison.outlook]).toEqual(["trials 1 and 2 are the same motion", null]);
    program.refused = "";
    clips.tick(1, 2);
    await settled();
    expect(comparison.whyNot).toBe("");
  });

  it("leaves Compare enabled when the program could not be loaded", async () => {
    program.unreachable = "offline";
    comparison.follow();
    await settled();
    expect([comparison.whyNot, comparison.outlook]).toEqual(["", null]);
  });

  it("drops the failed load when the machine is online again", async () => {
    program.unreachable = "offline";
    comparison.follow();
    await comparison.begin();
    expect([comparison.ending.failed, comparison.ending.words]).toEqual([true, "offline"]);
    program.unreachable = "";
    comparison.reconnected();
    await settled();
    expect([comparison.ending.failed, comparison.ending.words]).toEqual([false, ""]);
    expect(comparison.outlook?.asked).toBeGreaterThan(0);
  });
});

describe("opened results", () => {
  const saved = () =>
    savedResults(clips.toTrainOn, { parts: clips.parts, framesPerSecond: 30 }, ["tmp", "dmp-rhythmic"]);

  it("have no motions; on the same clips only the motions to show are computed again", async () => {
    comparison.follow();
    await comparison.open(saved());
    await settled();
    expect([comparison.ending.words, comparison.shown?.request]).toEqual(["2 results opened.", null]);
    expect(comparison.outlook).toMatchObject({ asked: 6, open: 6, goesOn: true });
    await compare();
    expect(comparison.ending.words).toBe("6 of 6 trainings done.");
    expect(finished()).toHaveLength(6);
    expect(comparison.shown?.predictions.size).toBe(6);
  });

  it("of another setting stay separate, and an unfinished comparison continues", async () => {
    const over = comparison.begin();
    await settled();
    program.evaluations.shift()?.end(evaluated);
    await settled();
    comparison.cancel();
    await over;
    program.evaluations.length = 0;
    const other = savedResults([clip(8), clip(9)], { parts: clips.parts, framesPerSecond: 30 }, ["tmp"]);
    await comparison.open(other);
    expect(finished()).toEqual(["tmp 1 of 1 seed 0"]);
    comparison.follow();
    await settled();
    expect(comparison.outlook).toMatchObject({ open: 5, goesOn: false });
    await compare();
    expect([comparison.ending.words, finished().length]).toEqual(["5 of 5 trainings done.", 6]);
  });

  it("ask before they replace results that are on no disk", async () => {
    await comparison.open(saved());
    await comparison.open(saved());
    expect(visitor.asked).toEqual([]);
    await compare();
    const { shown } = comparison;
    visitor.answer = "keep";
    expect(await comparison.open(saved())).toBe(false);
    expect([visitor.asked, comparison.shown]).toEqual([
      [expect.stringContaining("a comparison of 6 trainings")],
      shown,
    ]);
    visitor.answer = "discard";
    expect(await comparison.open(saved())).toBe(true);
    // The results of an earlier visit are on no disk: neither a file nor another comparison may replace them
    // unasked.
    await comparison.open(saved(), false);
    visitor.answer = "keep";
    clips.tick(1, 2);
    await compare();
    expect(comparison.shown?.request).toBeNull();
    expect(visitor.asked).toHaveLength(3);
    expect(comparison.unsaved).toContain(comparison.shown);
  });

  it("are refused while a comparison runs, also one that began meanwhile", async () => {
    const opening = comparison.open(saved());
    const over = comparison.begin();
    await expect(opening).rejects.toThrow("cancel it before opening");
    await expect(comparison.open(saved())).rejects.toThrow("cancel it before opening");
    await endAll();
    await over;
    expect(finished()).toHaveLength(6);
  });

  it("leave the shown results as they are when they cannot be opened", async () => {
    await compare();
    const { shown, ending } = comparison;
    program.failures.push(new Error("expected the results of an evaluation"));
    await expect(comparison.open("{}")).rejects.toThrow("expected the results");
    expect([comparison.shown, comparison.ending]).toEqual([shown, ending]);
  });
});
