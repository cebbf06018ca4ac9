import { beforeEach, describe, expect, it, vi } from "vitest";
import { mayLose, type Work } from "./unsaved";
import { visitor } from "./choice-dialog.fake";

vi.mock("./choice-dialog", () => import("./choice-dialog.fake"));

let saved: string[];
const work = (what: string): Work => ({ what, save: async () => void saved.push(what) });
beforeEach(() => {
  saved = [];
  visitor.arrives("keep");
});

describe("work that is not saved", () => {
  it("is asked about; without such work there is no question", async () => {
    expect(await mayLose()).toBe(true);
    expect(await mayLose(null, null)).toBe(true);
    expect(visitor.asked).toEqual([]);
    expect(await mayLose(null, work("a model"), work("a study"))).toBe(false);
    expect(visitor.asked).toEqual(["Not saved: a model, and a study. What comes now takes their place."]);
  });

  it("is discarded or saved as the visitor says", async () => {
    visitor.arrives("discard");
    expect([await mayLose(work("a model")), saved]).toEqual([true, []]);
    visitor.arrives("save");
    expect([await mayLose(work("a model"), work("a study")), saved]).toEqual([true, ["a model", "a study"]]);
  });

  it("stays when it cannot be saved", async () => {
    visitor.arrives("save");
    const full = { what: "a model", save: () => Promise.reject(new Error("the disk is full")) };
    await expect(mayLose(full)).rejects.toThrow("the disk is full");
  });
});
