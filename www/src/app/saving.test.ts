import { beforeEach, describe, expect, it, vi } from "vitest";
import { FakeEngine, FakeTrainers, modelHash, modelText, settled, started } from "../engine/engine.fake";
import { FakeProgram } from "../engine/whole-workers.fake";
import { FakeAddressBar } from "../settings/address.fake";
import { download } from "../ui/download";
import { App } from "./app";
import { openFiles } from "./open-files";
import { save } from "./saving";
import { modelOnStage } from "./stage-model";

// Its marks are drawn with the DOM.
vi.mock("../figures/model-style", () => ({ modelStyle: () => ({ name: "TMP" }) }));
vi.mock("../ui/download", () => ({ download: vi.fn() }));

const OTHER = '{"kind":"map-gpdm"}';

let app: App;
beforeEach(async () => {
  app = new App(new FakeAddressBar("alpha=0.1:50&frames=90"), false, new FakeProgram());
  await app.start(
    async () => started(new FakeEngine(), new FakeTrainers(1)),
    async () => modelText(1),
  );
  await settled();
  vi.mocked(download).mockClear();
});

const open = (name: string, text: string) => openFiles(app, [new File([text], name)], null);

/** The files that were saved: names and texts. */
const files = () =>
  Promise.all(vi.mocked(download).mock.calls.map(async ([name, blob]) => [name, await blob.text()]));

describe("the model on the stage", () => {
  it("is the page's own at first", async () => {
    const model = modelOnStage(app);
    expect([model?.isOnHost, await model?.content()]).toEqual([true, modelText(1)]);
    expect(app.fragmentWith({ modelFile: "a.json" })).toBe("frames=90&model=a.json&alpha=0.1:50");
  });

  it("is a model without couplings in front of it, whose link has no couplings", async () => {
    await open("walk.model.json", OTHER);
    const model = modelOnStage(app);
    expect([model?.name, model?.isOnHost, await model?.content()]).toEqual(["walk.model.json", false, OTHER]);
    expect(app.fragmentWith({ packedModel: "1.2.AA" })).toBe("frames=90&packed=1.2.AA");
    app.stage.endClip();
    expect(await modelOnStage(app)?.content()).toBe(modelText(1));
  });
});

describe("Save", () => {
  it("writes the model on the stage, of any kind", async () => {
    await save(app, "model");
    await open("walk.json", OTHER);
    await save(app, "model");
    const id = modelHash(1).slice(0, 8);
    expect(await files()).toEqual([
      [expect.stringMatching(new RegExp(`${id}\\.model\\.json$`)), modelText(1)],
      ["walk.model.json", OTHER],
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
