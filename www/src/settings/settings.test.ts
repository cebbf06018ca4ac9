import { describe, expect, it } from "vitest";
import {
  ALPHA_MAX,
  initialSettings,
  isEmbedded,
  limited,
  readSettings,
  SETTINGS,
  writeSettings,
} from "./settings";

describe("settings in the URL", () => {
  it("leaves out initial values, but names the view when nothing else is left", () => {
    expect(writeSettings(initialSettings())).toBe("view=play");
    expect(readSettings("view=play")).toEqual(initialSettings());
    expect(readSettings("")).toEqual(initialSettings());
  });

  it("writes only the chapter of the story", () => {
    const settings = { ...initialSettings(), chapter: 3, latent: 2 };
    expect(writeSettings(settings)).toBe("story=3");
    expect(readSettings("#story=3").chapter).toBe(3);
    expect(readSettings("#story=77").chapter).toBe(11);
  });

  it("has camera, time and cut in the link of a chapter, and names the page for teachers in one word", () => {
    const moment = { camera: [1.2, 0.1, 0.9], time: 2.5, cut: "kept" as const };
    const settings = { ...initialSettings(), chapter: 2, latent: 2, ...moment };
    const fragment = writeSettings(settings);
    expect(fragment).toBe("story=2&camera=1.2,0.1,0.9&time=2.5&cut=kept");
    expect(readSettings(fragment)).toEqual({ ...initialSettings(), chapter: 2, ...moment });
    expect(writeSettings({ ...settings, teach: true })).toBe("teach");
    expect(readSettings("#teach").teach).toBe(true);
    for (const camera of ["1,2", "1,2,x", "1,2,1e999", "NaN,0,0"])
      expect(readSettings(`#camera=${camera}`).camera).toEqual([]);
  });

  it("brings every setting of the Lab back", () => {
    const { chapter, teach, cut, ...lab } = initialSettings();
    const settings = {
      ...lab,
      camera: [1.2, 0.1, 0.9],
      time: 2.5,
      exercise: 3,
      panel: "more" as const,
      parts: "hand",
      split: [
        { name: "legs & hips", joints: [0, 1, 2, 3, 7] },
        { name: "rest", joints: [4, 5, 6] },
      ],
      latent: 2,
      dynamicsIps: 8,
      poseIps: 25,
      order: 1,
      framesPerSecond: 24,
      seed: 4294967295,
      maxIterations: 1000,
      poseWeight: 0.3 as const,
      asInPapers: true,
      trainings: 5,
      frames: 600,
      start: 3,
      startFrame: 12,
      samples: true,
      model: "0123abcd",
      reading: "as-learned" as const,
      alpha: { "0.1": 4.6, "1.0": 0.001 },
      plot: "3d" as const,
      speed: 0.25 as const,
      loop: false,
      large: true,
      view: "draw" as const,
      models: ["vgpdm", "tmp"] as const,
      ips: [4, 20],
      bases: [5],
      balanced: true,
      heldOut: 2,
      seeds: 3,
      comparedIterations: 20,
      growth: true,
      drawn: 7,
      driving: false,
      drawnPoints: 4 as const,
      says: "für dich",
      drawing: "01.Ab-_",
      packedModel: "1.4.Ab-_",
    };
    const untouched = Object.entries(settings).filter(
      ([name, value]) =>
        // It has the key of `model`.
        name !== "modelFile" &&
        JSON.stringify(value) === JSON.stringify(SETTINGS[name as keyof typeof SETTINGS].initial),
    );
    expect(untouched).toEqual([]);
    expect(readSettings(`#${writeSettings({ ...settings, chapter, teach, cut })}`)).toEqual({
      ...settings,
      chapter,
      teach,
      cut,
    });
  });

  it("names neighbouring joints of a part by the first and the last, so that links stay short", () => {
    const split = [
      { name: "legs", joints: [3, 0, 1, 2, 7] },
      { name: "rest", joints: [4, 5, 6] },
    ];
    expect(writeSettings({ ...initialSettings(), split })).toBe("split=legs:0-3.7;rest:4-6");
  });

  it("counts the trial held out from 0, and in the URL from 1", () => {
    expect(readSettings("#heldout=3").heldOut).toBe(2);
    expect(writeSettings({ ...initialSettings(), heldOut: 0 })).toBe("heldout=1");
    for (const text of ["#heldout=0", "#heldout=-4", ""]) expect(readSettings(text).heldOut).toBe("each");
    expect(readSettings("#heldout=1000").heldOut).toBe(98);
    expect(limited({ heldOut: Number.NaN })).toEqual({});
  });

  it("limits the values of the URL", () => {
    const settings = readSettings(
      "#latent=900&dynamics=-4&seed=99999999999&speed=77&alpha=0.1:1e9&draw=-3&driving=maybe",
    );
    expect(settings.latent).toBe(SETTINGS.latent.max);
    expect([settings.drawn, settings.driving]).toEqual([0, true]);
    expect(settings.dynamicsIps).toBe(SETTINGS.dynamicsIps.min);
    expect(settings.seed).toBe(4294967295);
    expect(settings.speed).toBe(1);
    expect(settings.alpha).toEqual({ "0.1": ALPHA_MAX });
  });

  it("takes a model that is no hash for a file, whose name then stands for the model in the address", () => {
    const settings = readSettings("#model=walks/mine.json&alpha=0.1:2");
    expect([settings.model, settings.modelFile]).toEqual(["", "walks/mine.json"]);
    expect(writeSettings({ ...settings, model: "0123abcd" })).toBe("model=walks/mine.json&alpha=0.1:2");
    expect(readSettings("#model=0123abcd").modelFile).toBe("");
  });

  it("ignores invalid values", () => {
    const text =
      "#model=&latent=NaN&fps=Infinity&alpha=0.1:-2&split=legs:5-2&reading=maybe&loop=perhaps&parts=<b>&unknown=1";
    expect(readSettings(text)).toEqual(initialSettings());
  });

  it("reads lists in any order, each value once and within its limits", () => {
    const settings = readSettings("#models=tmp,vcgpdm&ips=16,4,16,900&bases=,");
    expect(settings.models).toEqual(["vcgpdm", "tmp"]);
    expect(settings.ips).toEqual([4, 16, 40]);
    expect(settings.bases).toEqual(initialSettings().bases);
    expect(readSettings("#models=gplvm").models).toEqual(initialSettings().models);
  });

  it("refuses a joint in two parts", () => {
    expect(readSettings("#split=a:0-4;b:4-6").split).toEqual([]);
  });

  it("refuses more parts than the page can show", () => {
    const split = (count: number) =>
      Array.from({ length: count }, (_, part) => ({ name: `part ${part}`, joints: [part] }));
    const read = (count: number) =>
      readSettings(writeSettings({ ...initialSettings(), split: split(count) }));
    expect(read(8).split).toEqual(split(8));
    expect(read(9).split).toEqual([]);
  });

  it("refuses two parts of one name, also when the names are equal only in the address", () => {
    expect(readSettings("#parts=hand&split=a:0-4;a:5-6").split).toEqual([]);
    const split = ["a b", "a:b"].map((name, joint) => ({ name, joints: [joint] }));
    expect(limited({ split })).toEqual({});
  });
});

describe("limits", () => {
  it("apply to controls too", () => {
    expect(limited({ latent: 0 })).toEqual({ latent: 1 });
    expect(limited({ latent: 2.4 })).toEqual({ latent: 2 });
    expect(limited({ latent: Number.NaN, order: 3 })).toEqual({ order: 3 });
    expect(limited({ ips: [], alpha: { "0.1": 1e9 } })).toEqual({ alpha: { "0.1": ALPHA_MAX } });
  });

  it("round couplings only in the text", () => {
    const alpha = { "0.1": 1.23456789 };
    expect(limited({ alpha })).toEqual({ alpha });
    expect(writeSettings({ ...initialSettings(), alpha })).toBe("alpha=0.1:1.235");
  });
});

describe("embedding", () => {
  it("has a parameter of the query", () => {
    expect(isEmbedded("?embed")).toBe(true);
    expect(isEmbedded("?embed=1&x=2")).toBe(true);
    expect(isEmbedded("?embed=0")).toBe(false);
    expect(isEmbedded("")).toBe(false);
  });
});
