import { beforeEach, describe, expect, it, vi } from "vitest";
import { documentText, modelText } from "../engine/documents.fake";
import { HeldWorkers } from "../engine/held.fake";
import { packed, unpacked } from "../links/packed-model";
import { FakeAddressBar } from "../settings/address.fake";
import { visitor } from "../unsaved/choice-dialog.fake";
import { App } from "./app";

vi.mock("../unsaved/choice-dialog", () => import("../unsaved/choice-dialog.fake"));

const TMP = documentText("tmp");
/** Two models in links: digits of their documents are left out. */
const [link, tmpLink] = [await packed(modelText(9)), await packed(TMP)];
const linked = await unpacked(link);

let workers: HeldWorkers;
let bar: FakeAddressBar;
let app: App;
let fetchedFirst: number;

function load(fragment: string): void {
  workers = new HeldWorkers(1);
  workers.bring("walk-1");
  bar = new FakeAddressBar(fragment);
  app = new App(bar, false, workers);
}

/** Opens the page at an address. */
async function open(fragment: string): Promise<void> {
  load(fragment);
  fetchedFirst = 0;
  await app.words.load("en");
  await app.start(
    async () => workers.started(),
    async () => {
      fetchedFirst += 1;
      return modelText(1);
    },
  );
  await workers.settled();
}

/** Follows a link, and waits until its model is open or refused. */
async function follow(fragment: string): Promise<void> {
  bar.pages.push(fragment);
  const before = app.notices.all.length;
  const text = app.model.openedText;
  app.followAddress();
  await vi.waitFor(() => expect(app.notices.all.length > before || app.model.openedText !== text).toBe(true));
  await vi.waitFor(() => expect(app.settings.address.fragment).toBe(bar.read()));
}

const notices = () => app.notices.all.map(({ title, text }) => `${title}: ${text}`);

beforeEach(() => {
  const createElement = () => ({});
  const page = { documentElement: { lang: "" }, baseURI: "https://a.org/p/", createElement };
  Object.assign(globalThis, { document: page });
  vi.unstubAllGlobals();
});

describe("the address of the first visit", () => {
  it("opens the model in it, with its couplings, and asks for no other", async () => {
    await open(`alpha=0.1:50&packed=${link}`);
    const found = [app.model.openedText, app.model.couplings.alpha[0]?.[1], fetchedFirst];
    expect(found).toEqual([linked, 50, 0]);
    expect(bar.read()).toContain(`packed=${link}`);
    expect(notices()).toEqual([]);
  });

  it("says what is wrong with a link, and opens the page's model without the link's couplings", async () => {
    await open(`alpha=0.1:50&latent=2&start=1&frame=5&packed=${link.slice(0, -1)}`);
    expect(notices()).toEqual([
      expect.stringMatching(
        /^The model of this link was not opened: Expected [\d,]+ characters of a packed model, found [\d,]+: the link was cut off or changed on its way\.$/,
      ),
    ]);
    expect([app.model.openedText, app.model.couplings.altered, fetchedFirst]).toEqual([null, false, 1]);
    await vi.waitFor(() => expect(bar.read()).toBe("latent=2"));
  });

  it("repeats the words of the reader about a document that is no model", async () => {
    await open(`packed=${await packed('"no model"')}`);
    expect(notices()).toEqual([
      "The model of this link was not opened: At the top of the document: expected an object, found a text.",
    ]);
    expect(app.model.openedText).toBe(null);
  });

  it("opens a file of its host", async () => {
    const fetched = vi.fn(async () => new Response(modelText(7)));
    vi.stubGlobal("fetch", fetched);
    await open("model=models/seven.json&alpha=0.1:50");
    expect(fetched.mock.calls).toMatchObject([["https://a.org/p/models/seven.json", { redirect: "error" }]]);
    expect([app.model.openedText, app.model.couplings.alpha[0]?.[1]]).toEqual([modelText(7), 50]);
  });

  it("shows the motion of a model without couplings in front of the page's own model", async () => {
    vi.stubGlobal(
      "fetch",
      vi.fn(async () => new Response(TMP)),
    );
    await open("model=walk.json");
    await vi.waitFor(() => expect(app.stage.content?.caption?.title).toBe("Made by a TMP"));
    expect([app.model.openedText, fetchedFirst]).toEqual([null, 1]);
    await vi.waitFor(() => expect(bar.read()).toBe("model=walk.json"));
    expect(notices()).toEqual([]);
  });

  it("shows a model without couplings that is in the link, which stays there until the model leaves", async () => {
    await open(`frames=90&packed=${tmpLink}`);
    const title = () => app.stage.content?.caption?.title;
    await vi.waitFor(() =>
      expect([title(), app.stage.content?.motion.frames]).toEqual(["Made by a TMP", 90]),
    );
    await vi.waitFor(() => expect(bar.read()).toBe(`frames=90&packed=${tmpLink}`));
    // The visitor comes back from another view.
    bar.pages.push(`tab=more&frames=90&packed=${tmpLink}`);
    app.followAddress();
    expect([title(), app.settings.values.panel]).toEqual(["Made by a TMP", "more"]);
    app.stage.endClip();
    await vi.waitFor(() => expect(bar.read()).toBe("tab=more&frames=90"));
    expect([app.model.openedText, fetchedFirst, notices()]).toEqual([null, 1, []]);
  });

  it("asks no other host for a file", async () => {
    const fetched = vi.fn();
    vi.stubGlobal("fetch", fetched);
    await open("model=https://b.org/seven.json");
    expect(fetched).not.toHaveBeenCalled();
    expect(notices()).toEqual([
      "The model of this link was not opened: Expected the name of a JSON file on the host of this page, found “https://b.org/seven.json”.",
    ]);
  });
});

describe("a link that is followed", () => {
  it("opens its model also before the page is ready", async () => {
    load("alpha=0.1:3");
    await app.words.load("en");
    let begin = () => {};
    const engine = new Promise<void>((resolve) => {
      begin = resolve;
    });
    const over = app.start(
      async () => engine.then(() => workers.started()),
      async () => modelText(1),
    );
    bar.pages.push(`packed=${link}`);
    app.followAddress();
    begin();
    await over;
    expect([app.model.openedText, bar.read()]).toEqual([linked, expect.stringContaining("packed=1.")]);
  });

  it("replaces the model and its couplings", async () => {
    await open("alpha=0.1:3");
    const left = vi.spyOn(app.training, "unchoose");
    await follow(`packed=${link}`);
    expect([app.model.openedText, app.model.couplings.altered]).toEqual([linked, false]);
    expect(left).toHaveBeenCalled();
  });

  it("shows a model without couplings at its length, in front of the model as learned", async () => {
    await open("alpha=0.1:3");
    bar.pages.push(`frames=120&packed=${tmpLink}`);
    app.followAddress();
    await vi.waitFor(() => expect(app.stage.content?.caption?.title).toBe("Made by a TMP"));
    expect(app.stage.content?.motion.frames).toBe(120);
    await vi.waitFor(() => expect(app.model.rollout?.request).toMatchObject({ frames: 120, alpha: null }));
    expect(app.model.couplings.altered).toBe(false);
  });

  it("changes nothing when it is damaged", async () => {
    await open("alpha=0.1:3&view=compare");
    await follow(`alpha=0.1:7&packed=${link.replace(/.{4}$/, "AAAA")}`);
    expect(notices()).toEqual([expect.stringContaining("Expected a packed model whose check number fits")]);
    const found = [app.model.openedText, app.model.couplings.alpha[0]?.[1], app.settings.values.view];
    expect(found).toEqual([null, 3, "compare"]);
    await vi.waitFor(() => expect(bar.read()).toMatch(/^(?=.*alpha=0\.1:3)(?!.*packed)/));
  });

  it("changes nothing when the visitor keeps the model that was made here", async () => {
    await open("");
    await app.model.open(modelText(5));
    app.model.markMadeHere();
    visitor.arrives("keep");
    bar.pages.push(`packed=${link}`);
    app.followAddress();
    await vi.waitFor(() => expect(visitor.asked.length).toBeGreaterThan(0));
    await vi.waitFor(() => expect(bar.read()).not.toContain("packed"));
    expect(app.model.openedText).toBe(modelText(5));
  });

  it("stays in the address until another model is opened", async () => {
    await open(`packed=${link}`);
    app.model.couplings.set(0, 1, 20);
    await vi.waitFor(() => expect(bar.read()).toMatch(/alpha=0\.1:20&packed=1\./));
    expect(app.stateFragment).not.toContain("packed");
    await app.model.open(modelText(5));
    await vi.waitFor(() => expect(bar.read()).not.toContain("packed"));
  });

  it.each([new Response(modelText(7)), new Response(TMP), new Response("", { status: 404 })])(
    "does not replace what the visitor opened while its file was on the way",
    async (answer) => {
      let arrive = (_: Response) => {};
      const slow = new Promise<Response>((resolve) => {
        arrive = resolve;
      });
      vi.stubGlobal("fetch", () => slow);
      await open("");
      bar.pages.push("model=slow.json");
      app.followAddress();
      await workers.settled();
      await app.model.open(modelText(5));
      arrive(answer);
      for (let k = 0; k < 5; k++) await workers.settled();
      const { openedText } = app.model;
      expect([openedText, app.stage.content?.caption, notices()]).toEqual([modelText(5), undefined, []]);
    },
  );

  it("does not replace the model while a training runs", async () => {
    await open("");
    vi.spyOn(app.training, "busy", "get").mockReturnValue(true);
    bar.pages.push(`packed=${link}`);
    app.followAddress();
    await vi.waitFor(() => expect(notices()).toEqual([expect.stringContaining("A training is running")]));
    expect(app.model.openedText).toBe(null);
  });
});
