import { beforeEach, describe, expect, it, vi } from "vitest";
import { bvhText, modelText } from "../engine/documents.fake";
import { HeldWorkers } from "../engine/held.fake";
import { FakeAddressBar } from "../settings/address.fake";
import { App } from "./app";
import { download } from "../ui/download";
import { visitor } from "../unsaved/choice-dialog.fake";
import { openFiles, openModel } from "./open-files";
import { nothing } from "../session/visit.fake";
import { visitOf } from "./holdings";
import { loadNewVersion, wouldLose } from "./leaving";

vi.mock("../unsaved/choice-dialog", () => import("../unsaved/choice-dialog.fake"));
vi.mock("../ui/download", () => ({ download: vi.fn() }));

let workers: HeldWorkers;
let bar: FakeAddressBar;
let app: App;

/** A training is short. */
function begin(
  fragment = "seed=5&iterations=10&latent=1&order=1&dynamics=2&poses=2&fps=5&papers=1&frames=60",
): void {
  workers = new HeldWorkers(1);
  workers.bring("walk-1");
  bar = new FakeAddressBar(fragment);
  app = new App(bar, false, workers);
}
beforeEach(() => begin());

const start = (text: string | null = modelText(1)) =>
  app.start(
    async () => workers.started(),
    async () => text,
  );
const file = (name: string, text: string) => new File([text], name);
/** Begins a training. Returns a function that lets it train. */
async function train() {
  workers.hold("train");
  const over = app.training.start();
  await workers.settled();
  return () => {
    workers.held("train").at(-1)?.go();
    return over;
  };
}
const titles = () => app.notices.all.map(({ title }) => title);

describe("the start of the page", () => {
  it("takes up the model and the couplings of the address, then the clips", async () => {
    begin("alpha=0.1:50");
    await start();
    await workers.settled();
    const { version } = workers.started();
    expect([app.engine.state, app.engine.version, app.clips.all.length]).toEqual(["ready", version, 1]);
    expect([app.model.rollout?.request.alpha?.[0]?.[1], app.stage.content?.kind]).toEqual([50, "model"]);
    expect(app.training.whyNot()).toBe("");
  });

  it("says why the engine cannot start, and opens no files then", async () => {
    await app.start(
      () => Promise.reject(new Error("this browser has no WebAssembly")),
      async () => null,
    );
    expect([app.engine.state, app.engine.problem]).toEqual(["failed", "this browser has no WebAssembly"]);
    expect(app.training.whyNot()).toBe("The model cannot run in this browser");
    await openFiles(app, [file("a.bvh", bvhText())], { x: 1, y: 2 });
    expect(app.notices.all).toMatchObject([
      { title: "Nothing was opened", text: "This browser has no WebAssembly.", at: { x: 1, y: 2 } },
    ]);
  });

  it("fails with a model that cannot be read, or without its clips", async () => {
    await start("no model");
    const found = [app.engine.state, app.engine.problem, app.clips.samplesLoaded];
    expect(found).toEqual(["failed", expect.stringContaining("expected a model as JSON"), false]);
    begin();
    workers.hold("sampleClip");
    const over = start();
    await workers.settled();
    expect(app.engine.state).toBe("ready");
    workers.held("sampleClip")[0]?.fail(new Error("out of memory"));
    await over;
    expect([app.engine.state, app.engine.problem]).toEqual(["failed", "out of memory"]);
  });

  it("works without a model when the host has none", async () => {
    await start(null);
    expect([app.engine.state, app.model.model]).toEqual(["ready", null]);
  });
});

it("follows a link to other couplings", async () => {
  await start();
  bar.pages.push("alpha=1.0:3");
  app.followAddress();
  await workers.settled();
  expect(app.model.rollout?.request.alpha?.[1]?.[0]).toBe(3);
});

describe("files", () => {
  beforeEach(() => start());

  it("are opened one after the other by their kinds, with notices at the place of the drop", async () => {
    const at = { x: 3, y: 4 };
    const files = [
      file("mine.bvh", bvhText()),
      file("empty.bvh", ""),
      file("model.json", modelText(9)),
      file("picture.png", "x"),
      file("wrong.json", "x"),
    ];
    await openFiles(app, files, at);
    expect(titles()).toEqual(["empty.bvh", "picture.png", "wrong.json"]);
    expect(app.notices.all.every((notice) => notice.at === at)).toBe(true);
    expect(app.clips.ticked.map(({ title }) => title)).toEqual(["mine"]);
    expect(app.model.model?.info.provenance.settings.seed).toBe(9);
    await openFiles(app, [], null);
    expect(titles()).toEqual([]);
  });

  it("with a model replace the model of a finished run, but not of a running training", async () => {
    const end = await train();
    await openFiles(app, [file("model.json", modelText(9))], null);
    expect(app.notices.all[0]?.text).toMatch(/A training is running/);
    await end();
    expect(app.training.chosen?.state).toBe("done");
    await openFiles(app, [file("model.json", modelText(9))], null);
    expect([app.training.chosen, app.model.model?.info.provenance.settings.seed]).toEqual([null, 9]);
  });
});

describe("a model on the stage", () => {
  const seed = () => app.model.model?.info.provenance.settings.seed;
  beforeEach(async () => {
    visitor.arrives("keep");
    await start();
  });

  it("from a file or of a training is replaced unasked: the file and the list still have it", async () => {
    await openModel(app, modelText(9));
    await (await train())();
    await openModel(app, modelText(9));
    await app.training.choose(app.training.runs[0] ?? expect.fail());
    await workers.settled();
    expect([seed(), visitor.asked]).toEqual([5, []]);
  });

  it("that was made here is not replaced before the visitor is asked", async () => {
    await openModel(app, modelText(7), true);
    expect(await openModel(app, modelText(9))).toBe(false);
    await app.training.start();
    expect([seed(), app.training.runs.length, visitor.asked.length]).toEqual([7, 0, 2]);
    visitor.arrives("save");
    expect(await openModel(app, modelText(9))).toBe(true);
    expect(vi.mocked(download).mock.calls.map(([name]) => name)).toEqual([
      expect.stringMatching(/model\.json$/),
    ]);
    // The model is on a disk now.
    await openModel(app, modelText(7), true);
    expect([await openModel(app, modelText(9)), visitor.asked.length]).toEqual([true, 1]);
  });

  it("whose training was removed from the list is not replaced unasked either", async () => {
    await (await train())();
    app.training.clear();
    expect(await openModel(app, modelText(9))).toBe(false);
    expect(visitor.asked).toHaveLength(1);
  });
});

it("leaving the page loses only work that the browser does not store", async () => {
  visitor.arrives("keep");
  await start();
  expect(wouldLose(app)).toBe(false);
  await openModel(app, modelText(9));
  expect(wouldLose(app)).toBe(false);
  await openModel(app, modelText(7), true);
  expect(wouldLose(app)).toBe(true);
  const session = { loaded: { keeps: true } };
  const stored = (comparison: unknown) => {
    const view = (name: string) => ({ loaded: name === "compare" ? comparison : null });
    return wouldLose({ ...app, session, view } as unknown as App);
  };
  expect(stored(null)).toBe(false);
  // The browser stores only the shown comparison.
  const [shown, other] = [{}, {}];
  const compared = (unsaved: unknown[]) => stored({ unsaved, shown });
  expect([compared([]), compared([shown]), compared([shown, other])]).toEqual([false, false, true]);
});

describe("an earlier visit", () => {
  const earlier = { ...nothing, model: modelText(9), unsaved: { model: true, results: false } };
  beforeEach(async () => {
    visitor.arrives("keep");
    await start();
  });

  it("with a model takes the stage from a training that is over, and is stored from then on", async () => {
    await (await train())();
    const visit = visitOf(app);
    expect(await visit.takeUp(earlier)).toEqual([]);
    expect([visit.holdings().model, visit.holdings().unsaved.model]).toEqual([modelText(9), true]);
  });

  it("with a model waits for a training: its models would take the stage unasked", async () => {
    const end = await train();
    await expect(visitOf(app).takeUp(earlier)).rejects.toThrow("A training is running");
    expect(app.model.openedText).not.toBe(modelText(9));
    await end();
  });

  it("is taken up but for the pieces that cannot be read", async () => {
    const clip = (name: string, text: string) => ({
      ...{ key: `own-${name}`, id: 7, title: name, origin: "own" as const, ticked: true, first: 0, end: 90 },
      source: { name, file: new Blob([text]) },
    });
    const clips = [clip("empty", ""), clip("walk", bvhText())];
    const problems = await visitOf(app).takeUp({ ...earlier, clips, model: "no model" });
    expect(problems).toEqual([
      expect.stringMatching(/^The clip empty: /),
      expect.stringMatching(/^The model: expected a model as JSON/),
    ]);
    expect(app.clips.all.map(({ title }) => title)).toContain("walk");
  });
});

describe("a new version of the page", () => {
  const taken = vi.fn();
  beforeEach(async () => {
    await start();
    vi.spyOn(app.offline, "takeNewVersion").mockImplementation(taken.mockReset());
  });

  it("is loaded unasked where nothing runs", async () => {
    visitor.arrives("keep");
    await loadNewVersion(app);
    expect([visitor.asked, taken.mock.calls.length]).toEqual([[], 1]);
  });

  it("does not end a training before the visitor says so", async () => {
    visitor.arrives("keep");
    const end = await train();
    await loadNewVersion(app);
    expect([visitor.asked, taken.mock.calls.length]).toEqual([
      ["Loading it ends what runs here: a training."],
      0,
    ]);
    visitor.arrives("yes");
    await loadNewVersion(app);
    expect(taken).toHaveBeenCalledTimes(1);
    await end();
  });
});
