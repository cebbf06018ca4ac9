import { beforeEach, describe, expect, it, vi } from "vitest";
import { seriesText, seriesTmpText } from "../engine/documents.fake";
import { HeldWorkers } from "../engine/held.fake";
import { FakeAddressBar } from "../settings/address.fake";
import { initialSettings } from "../settings/settings";
import { SettingsStore } from "../settings/settings-store";
import { download } from "../ui/download";
import { visitor } from "../unsaved/choice-dialog.fake";
import { curvesOf } from "./series-curves";
import { openSeries, type Series } from "./series";
import { goingOn } from "./going-on";
import { SeriesStore } from "./series-store";
import type { TableEntry } from "./tables-store";

vi.mock("../unsaved/choice-dialog", () => import("../unsaved/choice-dialog.fake"));
vi.mock("../ui/download", () => ({ download: vi.fn() }));

/** Ten rows of waves; another file for each name. */
function file(name: string, columns = ["arm_x", "arm_y", "leg_x"]): File {
  const wave = (row: number) => columns.map((_, column) => Math.sin(row + column + name.charCodeAt(0)));
  const rows = Array.from({ length: 10 }, (_, row) => wave(row).join());
  return new File([[columns.join(), ...rows].join("\n")], name);
}

let workers: HeldWorkers;
let series: Series;
beforeEach(() => {
  workers = new HeldWorkers();
  const settings = "latent=1&iterations=20&dynamics=2&poses=2";
  series = openSeries(workers, new SettingsStore(new FakeAddressBar(settings)));
});
const OTHER = seriesText(["old.csv"]);
const rollouts = () => workers.asked("rolloutSeries").map(([request]) => request);

describe("tables", () => {
  it("are opened once each, with parts by their columns", async () => {
    const { tables, training } = series;
    expect(training.whyNot).toMatch(/Open a table/);
    for (const name of ["a.csv", "b.csv", "a.csv"]) await tables.open(file(name));
    expect(tables.all.map(({ info, ticked }) => [info.name, ticked])).toEqual([
      ["a.csv", true],
      ["b.csv", true],
    ]);
    expect(tables.parts.map(({ name }) => name)).toEqual(["arm", "leg"]);
    await expect(tables.open(new File(["x\n"], "c.csv"))).rejects.toThrow(/^c\.csv.* row/);
    expect(training.whyNot).toBe("");
  });

  it("of other columns get other parts, and say why they do not go together", async () => {
    const { tables, training } = series;
    await tables.open(file("a.csv"));
    tables.moveColumn("arm_y", 1);
    await tables.open(file("b.csv", ["x", "y"]));
    expect(tables.clash).toMatch(/b\.csv/);
    expect(training.whyNot).toMatch(/do not go together/);
    // The parts that the visitor changed stay as long as the columns stay the same.
    expect(tables.parts[1]?.columns).toEqual(["arm_y", "leg_x"]);
    const [first] = tables.all;
    if (first) await tables.tick(first, false);
    expect([tables.parts, tables.clash]).toEqual([[{ name: "whole", columns: ["x", "y"] }], ""]);
  });

  it("leave columns out by name, also of tables that open later, until all tables are removed", async () => {
    const { tables, training } = series;
    await tables.open(file("a.csv"));
    await tables.leaveOut(" arm_y, ");
    expect([tables.columns, tables.leftOut]).toEqual([["arm_x", "leg_x"], ["arm_y"]]);
    expect(tables.all[0]?.values.length).toBe(2 * 10);
    await tables.open(file("b.csv"));
    expect(tables.all[1]?.info.columns).toEqual(["arm_x", "leg_x"]);
    await tables.leaveOut("arm_z");
    expect(tables.leftOutProblem).toMatch(/^a\.csv: expected some of the columns .*, found "arm_z"$/);
    expect([tables.columns, tables.leftOut]).toEqual([["arm_x", "leg_x"], ["arm_y"]]);
    await training.train();
    expect(series.model.opened?.info.columns).toEqual(["arm_x", "leg_x"]);
    await tables.leaveOut("");
    expect([tables.columns.length, tables.leftOutProblem]).toEqual([3, ""]);
    await tables.leaveOut("leg_x");
    for (const table of [...tables.all]) await tables.remove(table);
    expect(tables.leftOut).toEqual([]);
  });

  it("have parts with names of their own: another gives way to the old one, with a word until the next change", async () => {
    const { tables } = series;
    await tables.open(file("a.csv"));
    expect([tables.renamePart(0, " hand "), tables.refused]).toEqual(["hand", ""]);
    expect([tables.renamePart(0, "leg"), tables.refused]).toEqual(["hand", "Another part is called “leg”."]);
    expect(tables.parts.map(({ name }) => name)).toEqual(["hand", "leg"]);
    tables.addPart();
    expect(tables.refused).toBe("");
    expect([tables.renamePart(2, " "), tables.refused]).toEqual(["part 3", "A part needs a name."]);
    const [table] = tables.all;
    if (table) await tables.tick(table, false);
    expect(tables.refused).toBe("");
  });
});

describe("a training", () => {
  it("has the parts that have columns, and its model is looked at", async () => {
    const { tables, model, training } = series;
    await tables.open(file("a.csv"));
    tables.addPart();
    await training.train();
    const { info, trainingLatents } = model.opened!;
    expect(info.parts.map(({ name, latent, poseIps }) => [name, latent, poseIps])).toEqual([
      ["arm", 1, 2],
      ["leg", 1, 2],
    ]);
    expect(info.sequences.map(({ name }) => name)).toEqual(["a.csv"]);
    const { order, framesPerSecond, seed } = initialSettings();
    expect(workers.asked("trainSeries")[0]?.[0].settings).toMatchObject({
      ...{ latent: 1, dynamicsIps: 2, poseIps: 2, maxIterations: 20, order, framesPerSecond, seed },
    });
    expect(trainingLatents?.map(({ length }) => length)).toEqual([10, 10]);
    expect(model.recorded?.info.name).toBe("a.csv");
    expect([model.clock.lastFrame, model.couplings.altered]).toEqual([14, false]);
  });

  it("gives a model that makes place for no other, opened or trained, before the visitor was asked", async () => {
    const { tables, model, training } = series;
    visitor.arrives("keep");
    await tables.open(file("a.csv"));
    await model.open(OTHER);
    await training.train();
    expect(visitor.asked).toEqual([]);
    const { opened } = model;
    expect(await model.open(OTHER)).toBe(false);
    await training.train();
    expect([training.busy, model.opened === opened]).toEqual([false, true]);
    expect(visitor.asked).toHaveLength(2);
    // Once the model is saved, the page does not ask again.
    visitor.arrives("save");
    for (let times = 0; times < 2; times++) await training.train();
    expect([workers.asked("trainSeries").length, visitor.asked.length]).toEqual([3, 2]);
    model.save();
    expect([await model.open(OTHER), visitor.asked.length]).toEqual([true, 2]);
    expect(vi.mocked(download)).toHaveBeenCalledTimes(3);
  });

  it("that fails leaves the model that was there", async () => {
    const { tables, model, training } = series;
    await model.open(OTHER);
    await tables.open(file("a.csv"));
    workers.hold("trainSeries");
    const over = training.train();
    await workers.settled();
    workers.held("trainSeries")[0]?.fail(new Error("out of memory"));
    await over;
    expect([model.opened?.text === OTHER, training.busy]).toEqual([true, false]);
  });
});

describe("a model of tables", () => {
  it("is rolled out anew when a coupling changes, the newest only, and as learned again", async () => {
    const { model } = series;
    await model.open(seriesText(["a.csv", "b.csv"]));
    expect(model.recorded).toBeNull();
    for (const alpha of [10, 20, 30]) model.couplings.set(0, 1, alpha);
    await workers.settled();
    expect(rollouts().map(({ alpha }) => alpha?.[0]?.[1] ?? null)).toEqual([null, 10, 30]);
    // The page sends the document of the model once, not with each event of a slider.
    expect(workers.asked("openSeries").length).toBe(1);
    expect(model.couplings.weight(0, 1)).toBeCloseTo(
      1 / 30 / (1 / 30 + 1 / model.couplings.alphaOf(1, 1)),
      12,
    );
    expect([model.rollout?.weights?.[0]?.[1], model.couplings.altered]).toEqual([
      model.couplings.weight(0, 1),
      true,
    ]);
    expect(model.rollout?.values).not.toEqual(model.learned?.values);
    const [, firstRow] = (await model.csv()).split("\n");
    expect(firstRow?.split(",").slice(2).map(Number)).toEqual([...model.rollout!.values.slice(0, 3)]);
    model.couplings.resetAll();
    await workers.settled();
    expect([model.couplings.altered, model.rollout]).toEqual([false, model.learned]);
  });

  it("without an end goes on from the frame now, and as learned begins again", async () => {
    const model = new SeriesStore(workers, series.tables, 100);
    await model.open(seriesText(["a.csv"]));
    const last = () => rollouts().at(-1);
    model.clock.seek(60);
    await workers.settled();
    expect([model.clock.frame, last()?.start]).toEqual([60, undefined]);
    model.clock.seek(80);
    await workers.settled();
    // 30 frames stay before the next ones, of which one begins the rollout.
    expect([model.clock.frame, model.clock.lastFrame]).toEqual([29, 128]);
    expect(last()?.start?.map((part) => part.map((row) => row.length))).toEqual([[1], [1]]);
    const before = [...model.rollout!.values];
    model.couplings.set(0, 1, 30);
    await workers.settled();
    const now = [...model.rollout!.values];
    expect([now[0], now.at(-1) === before.at(-1)]).toEqual([before[0], false]);
    // The last of three requests at once begins again, as the second one would.
    for (const alpha of [40, null, 50]) alpha ? model.couplings.set(0, 1, alpha) : model.couplings.resetAll();
    await workers.settled();
    expect([last()?.alpha?.[0]?.[1], last()?.start]).toEqual([50, undefined]);
    model.couplings.resetAll();
    await workers.settled();
    expect(model.rollout).toBe(model.learned);
  });

  it("without an end can set a part back", async () => {
    const path = Float64Array.from({ length: 20 }, (_, frame) => frame);
    const { start } = goingOn({ values: path, latents: [path, path], weights: null }, [20, 10, 2], [3]);
    expect(start).toEqual([
      [[6], [7]],
      [[9], [10]],
    ]);
    const model = new SeriesStore(workers, series.tables, 100);
    await model.open(seriesText(["a.csv"]));
    model.setBack([5]);
    await workers.settled();
    expect(rollouts().at(-1)).toMatchObject({ alpha: null, start: [{ length: 1 }, { length: 1 }] });
  });

  it("has futures from where its rollout was asked for last, and none when hidden", async () => {
    const model = new SeriesStore(workers, series.tables, 100);
    await model.open(seriesText(["a.csv"]));
    model.showFutures(1);
    await workers.settled();
    expect(new Set(model.futures.map(({ latents }) => latents[0]?.at(-1))).size).toBe(5);
    model.clock.seek(80);
    await workers.settled();
    expect([model.futures[0]?.request.frames, model.futures[0]?.latents[0]?.length]).toEqual([129, 129]);
    model.showFutures(0);
    await workers.settled();
    expect(model.futures).toEqual([]);
  });

  it("begins as another table when asked to", async () => {
    const { model } = series;
    await model.open(seriesText(["a.csv", "b.csv"]));
    model.setSequence(1);
    await workers.settled();
    expect(rollouts().at(-1)).toMatchObject({ sequence: 1, frames: 30, alpha: null });
  });

  it("infers columns from those that a recording or a hand gives, until the model moves all again", async () => {
    const { tables, model } = series;
    await tables.open(file("a.csv", ["x", "y", "z"]));
    const [{ info, values }] = tables.all as [TableEntry];
    await model.open(seriesText([info.sha256]));
    const asked = (row: number) => [...(rollouts().at(-1)?.observed ?? [])].slice(3 * row, 3 * row + 3);
    model.give("y", "recording");
    await workers.settled();
    const missing = Number.NaN;
    expect([asked(1), asked(10)]).toEqual([
      [missing, values[4], missing],
      [missing, missing, missing],
    ]);
    const given = (row: number, column: number) => model.rollout?.values[3 * row + column];
    expect(given(1, 1)).toBeCloseTo(values[4]!, 9);
    model.give("z", "hand");
    model.draw("z", [0, 7], [1, 8]);
    await workers.settled();
    expect([asked(0)[2], asked(1)[2]]).toEqual([7, 8]);
    expect([given(0, 2), given(1, 2)]).toEqual([7, 8].map((number) => expect.closeTo(number, 9)));
    expect(["x", "y", "z"].map((column) => model.giverOf(column))).toEqual([null, "recording", "hand"]);
    model.give("y", null);
    model.give("z", null);
    await workers.settled();
    expect(model.rollout).toBe(model.learned);
    model.give("z", "hand");
    await model.open(OTHER);
    expect(model.giverOf("z")).toBeNull();
  });

  it("of another kind has curves alone", async () => {
    const { model } = series;
    await model.open(seriesTmpText());
    model.couplings.set(0, 1, 5);
    await workers.settled();
    expect([model.couplings.alpha, model.rollout?.latents, rollouts().length]).toEqual([[], [], 1]);
  });
});

it("a curve finds its recording by name, wherever it stands in the table", () => {
  const info = {
    parts: [
      { name: "leg", joints: [1] },
      { name: "arm", joints: [0] },
    ],
    columns: ["a", "l"],
  };
  const table = {
    info: { name: "t", sha256: "", columns: ["l", "x", "a"], rows: 2, frameTime: null, warnings: [] },
  };
  const curves = curvesOf(info, Float64Array.of(1, 2, 3, 4), {
    ...table,
    values: Float64Array.of(5, 0, 6, 7, 0, 8),
  });
  expect(curves).toEqual([
    { name: "l", part: 0, rolledOut: [2, 4], recorded: [5, 7] },
    { name: "a", part: 1, rolledOut: [1, 3], recorded: [6, 8] },
  ]);
  expect(curvesOf(info, Float64Array.of(1, 2), null)[0]?.recorded).toBeNull();
});
