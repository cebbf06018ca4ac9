import { beforeEach, describe, expect, it, vi } from "vitest";
import { documentText, modelText } from "../engine/documents.fake";
import { HeldWorkers } from "../engine/held.fake";
import { FakeAddressBar } from "../settings/address.fake";
import { download } from "../ui/download";
import { App } from "./app";
import { openFiles } from "./open-files";
import { save } from "./saving";
import { modelOnStage } from "./stage-model";

vi.mock("../ui/download", () => ({ download: vi.fn() }));

const OTHER = documentText("tmp");
const own: unknown = JSON.parse(modelText(1));

let app: App;
beforeEach(async () => {
  Object.assign(globalThis, { document: { documentElement: { lang: "" }, createElement: () => ({}) } });
  const workers = new HeldWorkers();
  workers.bring("walk-1");
  app = new App(new FakeAddressBar("alpha=0.1:50&frames=90"), false, workers);
  await app.words.load("en");
  await app.start(
    async () => workers.started(),
    async () => modelText(1),
  );
  await workers.settled();
  vi.mocked(download).mockClear();
});

const open = (name: string, text: string) => openFiles(app, [new File([text], name)], null);

/** The files that were saved: names and documents. */
const files = () =>
  Promise.all(
    vi.mocked(download).mock.calls.map(async ([name, blob]) => [name, JSON.parse(await blob.text())]),
  );

describe("the model on the stage", () => {
  it("is the page's own at first", async () => {
    const model = modelOnStage(app);
    expect([model?.isOnHost, JSON.parse(await model!.content())]).toEqual([true, own]);
    expect(app.fragmentWith({ modelFile: "a.json" })).toBe("frames=90&model=a.json&alpha=0.1:50");
  });

  it("is a model without couplings in front of it, whose link has no couplings", async () => {
    await open("walk.model.json", OTHER);
    const model = modelOnStage(app);
    expect([model?.name, model?.isOnHost, await model?.content()]).toEqual(["walk.model.json", false, OTHER]);
    expect(app.fragmentWith({ packedModel: "1.2.AA" })).toBe("frames=90&packed=1.2.AA");
    app.stage.endClip();
    expect(JSON.parse(await modelOnStage(app)!.content())).toEqual(own);
  });
});

describe("Save", () => {
  it("writes the model on the stage, of any kind", async () => {
    await save(app, "model");
    await open("walk.json", OTHER);
    await save(app, "model");
    expect(await files()).toEqual([
      [expect.stringMatching(new RegExp(`${app.model.id}\\.model\\.json$`)), own],
      ["walk.model.json", JSON.parse(OTHER)],
    ]);
  });

  it("does not take the model behind for saved when it writes the one in front", async () => {
    await app.model.open(modelText(5));
    app.model.markMadeHere();
    await open("walk.json", OTHER);
    await save(app, "model");
    expect(app.model.unsaved).toBe(true);
    app.stage.endClip();
    await save(app, "model");
    expect(app.model.unsaved).toBe(false);
  });
});
