import { beforeEach, describe, expect, it, vi } from "vitest";
import { progress } from "../engine/engine.fake";
import type { TrainingReport } from "../engine/protocol";
import { seriesText } from "../engine/series.fake";
import type { TrainedSeries } from "../engine/series-protocol";
import { FakeProgram, settled } from "../engine/whole-workers.fake";
import { FakeAddressBar } from "../settings/address.fake";
import { SettingsStore } from "../settings/settings-store";
import { download } from "../ui/download";
import { visitor } from "../unsaved/choice-dialog.fake";
import { curvesOf } from "./series-curves";
import { openSeries, type Series } from "./series";
import { goingOn } from "./going-on";
import { SeriesStore } from "./series-store";

vi.mock("../unsaved/choice-dialog", () => import("../unsaved/choice-dialog.fake"));
vi.mock("../ui/download", () => ({ download: vi.fn() }));

const CSV = "arm_x,arm_y,leg_x\n1,2,3\n4,5,6\n";
const file = (name: string, text = CSV) => new File([text], name);

let program: FakeProgram;
let series: Series;
beforeEach(() => {
  program = new FakeProgram();
  series = openSeries(program, new SettingsStore(new FakeAddressBar("latent=2&iterations=50")));
});

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
    await expect(tables.open(file("c.csv", "x\n"))).rejects.toThrow(/^c\.csv, line 1/);
    expect(training.whyNot).toBe("");
  });

  it("of other columns get other parts, and say why they do not go together", async () => {
    const { tables, training } = series;
    await tables.open(file("a.csv"));
    tables.moveColumn("arm_y", 1);
    program.series.clash = "b.csv cannot be trained together with a.csv";
    await tables.open(file("b.csv", "x,y\n1,2\n3,4\n"));
    expect(tables.clash).toMatch(/b\.csv cannot/);
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
    expect([...(tables.all[0]?.values ?? [])]).toEqual([1, 3, 4, 6]);
    await tables.open(file("b.csv"));
    expect(tables.all[1]?.info.columns).toEqual(["arm_x", "leg_x"]);
    await tables.leaveOut("arm_z");
    expect(tables.leftOutProblem).toMatch(/^a\.csv: expected some of the columns .*, found arm_z$/);
    expect([tables.columns, tables.leftOut]).toEqual([["arm_x", "leg_x"], ["arm_y"]]);
    void training.train();
    await settled();
    expect(program.series.trainings[0]?.job.tables.map(({ without }) => without)).toEqual([
      ["arm_y"],
      ["arm_y"],
    ]);
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
  const report = (found: TrainedSeries | null) =>
    ({ progress: { ...progress(50), fraction: 1 }, elapsed: 2, found }) as TrainingReport<TrainedSeries>;

  it("is asked for with the parts that have columns, and its model is looked at", async () => {
    const { tables, model, training } = series;
    await tables.open(file("a.csv"));
    tables.addPart();
    const over = training.train();
    await settled();
    const [asked] = program.series.trainings;
    expect(asked?.job.settings).toMatchObject({
      latent: 2,
      maxIterations: 50,
      parts: [{ name: "arm" }, { name: "leg" }],
    });
    expect(asked?.job.tables.map(({ name }) => name)).toEqual(["a.csv"]);
    const latents = [new Float64Array(4), new Float64Array(2)];
    asked?.report(report({ text: seriesText(["a.csv"]), latents }));
    asked?.end({ cancelled: false, reason: "settled" });
    await over;
    expect(model.opened?.trainingLatents).toEqual(latents);
    expect(model.recorded?.info.name).toBe("a.csv");
    expect([model.clock.lastFrame, model.couplings.altered]).toEqual([14, false]);
  });

  it("gives a model that makes place for no other, opened or trained, before the visitor was asked", async () => {
    const { tables, model, training } = series;
    const train = async () => {
      const over = training.train();
      await settled();
      const asked = program.series.trainings.shift();
      asked?.report(report({ text: seriesText(["a.csv"]), latents: [new Float64Array(4)] }));
      asked?.end({ cancelled: false, reason: "settled" });
      await over;
      return asked !== undefined;
    };
    visitor.arrives("keep");
    await tables.open(file("a.csv"));
    await model.open(seriesText(["old.csv"]));
    await train();
    expect(visitor.asked).toEqual([]);
    const { opened } = model;
    expect(await model.open(seriesText(["old.csv"]))).toBe(false);
    expect([await train(), training.busy, model.opened]).toEqual([false, false, opened]);
    expect(visitor.asked).toHaveLength(2);
    // Once the model is saved, the page does not ask again.
    visitor.arrives("save");
    expect([await train(), await train(), visitor.asked.length]).toEqual([true, true, 2]);
    model.save();
    expect([await model.open(seriesText(["old.csv"])), visitor.asked.length]).toEqual([true, 2]);
    expect(vi.mocked(download)).toHaveBeenCalledTimes(3);
  });

  it("that fails leaves the model that was there", async () => {
    const { tables, model, training } = series;
    await model.open(seriesText(["old.csv"]));
    await tables.open(file("a.csv"));
    const over = training.train();
    await settled();
    program.series.trainings[0]?.report(report(null));
    program.series.trainings[0]?.end({ cancelled: true, reason: null });
    await over;
    expect(model.opened?.text).toBe(seriesText(["old.csv"]));
    expect(training.busy).toBe(false);
  });
});

describe("a model of tables", () => {
  it("is rolled out anew when a coupling changes, the newest only, and as learned again", async () => {
    const { model } = series;
    await model.open(seriesText(["a.csv", "b.csv"]));
    expect(model.recorded).toBeNull();
    for (const alpha of [10, 20, 30]) model.couplings.set(0, 1, alpha);
    await settled();
    expect(program.series.rollouts.map(({ alpha }) => alpha?.[0]?.[1] ?? null)).toEqual([null, 10, 30]);
    // The page sends the document of the model once, not with each event of a slider.
    expect(program.series.opened.length).toBe(1);
    expect(model.couplings.weight(0, 1)).toBeCloseTo(
      1 / 30 / (1 / 30 + 1 / model.couplings.alphaOf(1, 1)),
      12,
    );
    const found = [model.rollout?.values[0], model.learned?.values[0], model.couplings.altered];
    expect(found).toEqual([30, 0, true]);
    expect(await model.csv()).toContain("30");
    model.couplings.resetAll();
    await settled();
    expect([model.couplings.altered, model.rollout]).toEqual([false, model.learned]);
  });

  it("without an end goes on from the frame now, and as learned begins again", async () => {
    const model = new SeriesStore(program, series.tables, 100);
    await model.open(seriesText(["a.csv"]));
    const last = () => program.series.rollouts.at(-1);
    model.clock.seek(60);
    await settled();
    expect([model.clock.frame, last()?.start]).toEqual([60, undefined]);
    model.clock.seek(80);
    await settled();
    // 30 frames stay before the next ones, of which two begin the rollout.
    expect([model.clock.frame, model.clock.lastFrame]).toEqual([29, 127]);
    expect(last()?.start?.map((part) => part.map((row) => row.length))).toEqual([
      [2, 2],
      [1, 1],
    ]);
    model.couplings.set(0, 1, 30);
    await settled();
    expect([model.rollout?.values.at(0), model.rollout?.values.at(-1)]).toEqual([0, 30]);
    // The last of three requests at once begins again, as the second one would.
    for (const alpha of [40, null, 50]) alpha ? model.couplings.set(0, 1, alpha) : model.couplings.resetAll();
    await settled();
    expect([last()?.alpha?.[0]?.[1], last()?.start]).toEqual([50, undefined]);
    model.couplings.resetAll();
    await settled();
    expect(model.rollout).toBe(model.learned);
  });

  it("without an end can set a part back", async () => {
    const path = Float64Array.from({ length: 20 }, (_, frame) => frame);
    const { start } = goingOn({ values: path, latents: [path, path], weights: null }, [20, 10, 2], [3]);
    expect(start).toEqual([
      [[6], [7]],
      [[9], [10]],
    ]);
    const model = new SeriesStore(program, series.tables, 100);
    await model.open(seriesText(["a.csv"]));
    model.setBack([5]);
    await settled();
    expect(program.series.rollouts.at(-1)).toMatchObject({
      alpha: null,
      start: [{ length: 2 }, { length: 2 }],
    });
  });

  it("has futures from where its rollout was asked for last, and none when hidden", async () => {
    const model = new SeriesStore(program, series.tables, 100);
    await model.open(seriesText(["a.csv"]));
    const firsts = () => model.futures.map(({ latents }) => latents[0]?.at(-1));
    model.showFutures(1);
    await settled();
    expect(firsts()).toEqual([1, 2, 3, 4, 5]);
    model.clock.seek(80);
    await settled();
    expect([model.futures[0]?.request.frames, model.futures[0]?.latents[0]?.length]).toEqual([128, 256]);
    model.showFutures(0);
    await settled();
    expect(model.futures).toEqual([]);
  });

  it("begins as another table when asked to", async () => {
    const { model } = series;
    await model.open(seriesText(["a.csv", "b.csv"]));
    model.setSequence(1);
    await settled();
    expect(program.series.rollouts.at(-1)).toMatchObject({ sequence: 1, frames: 15, alpha: null });
  });

  it("infers columns from those that a recording or a hand gives, until the model moves all again", async () => {
    const { tables, model } = series;
    await model.open(seriesText(["a.csv"]));
    await tables.open(file("a.csv"));
    const asked = () => [...(program.series.rollouts.at(-1)?.observed ?? [])].slice(0, 9);
    model.give("arm_y", "recording");
    await settled();
    // The recording has two rows.
    const missing = Number.NaN;
    expect(asked()).toEqual([missing, 2, missing, missing, 5, missing, missing, missing, missing]);
    model.give("leg_x", "hand");
    model.draw("leg_x", [0, 7], [1, 8]);
    await settled();
    expect(asked()).toEqual([missing, 2, 7, missing, 5, 8, missing, missing, 0]);
    expect([model.giverOf("arm_y"), model.giverOf("leg_x"), model.giverOf("arm_x")]).toEqual([
      ...["recording", "hand", null],
    ]);
    model.give("arm_y", null);
    model.give("leg_x", null);
    await settled();
    expect(model.rollout).toBe(model.learned);
    model.give("leg_x", "hand");
    await model.open(seriesText(["b.csv"]));
    expect(model.giverOf("leg_x")).toBeNull();
  });

  it("of another kind has curves alone", async () => {
    const { model } = series;
    await model.open(seriesText(["a.csv"], { coupled: false }));
    model.couplings.set(0, 1, 5);
    await settled();
    expect([model.couplings.alpha, model.rollout?.latents, program.series.rollouts.length]).toEqual([
      [],
      [],
      1,
    ]);
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
