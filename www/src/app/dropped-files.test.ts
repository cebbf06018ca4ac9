import { expect, it } from "vitest";
import { droppedFiles, type Entry, type FolderEntry, type Item } from "./dropped-files";

const entryOf = (name: string): Entry => ({
  isDirectory: false,
  name,
  file: (found) => found(new File(["x"], name)),
});
/** Gives its entries in portions of two, as browsers give those of a large folder. */
const folder = (name: string, entries: Entry[]): FolderEntry => ({
  isDirectory: true,
  name,
  createReader: () => {
    const left = [...entries];
    return { readEntries: (found) => found(left.splice(0, 2)) };
  },
});
const dropped = (entry: Entry | null, file: File | null = null): Item => ({
  kind: "file",
  getAsFile: () => file,
  webkitGetAsEntry: () => entry,
});
const text: Item = { kind: "string", getAsFile: () => null, webkitGetAsEntry: () => null };

it("a dropped file is taken as it is, whatever its name", async () => {
  const { files } = await droppedFiles([text, dropped(null, new File(["x"], "notes.txt"))]);
  expect(files.map(({ name }) => name)).toEqual(["notes.txt"]);
});

it("a folder gives the files in it that the page may open, those of inner folders too", async () => {
  const inner = folder("more", [entryOf("walk-10.bvh"), entryOf("walk-9.BVH")]);
  const names = ["table.csv", ".hidden.json", "notes.txt", "model.json"];
  const { files, problems } = await droppedFiles([
    dropped(folder("recordings", [...names.map(entryOf), inner]), new File([], "recordings")),
  ]);
  expect(files.map(({ name }) => name)).toEqual(["model.json", "table.csv", "walk-9.BVH", "walk-10.bvh"]);
  expect(problems).toEqual([]);
});

it("a folder without such files, or with too many, gets a sentence, and the other files are taken", async () => {
  const many = Array.from({ length: 501 }, (_, i) => entryOf(`${i}.bvh`));
  const { files, problems } = await droppedFiles([
    dropped(folder("pictures", [entryOf("a.png")])),
    dropped(folder("everything", many)),
    dropped(null, new File(["x"], "walk.bvh")),
  ]);
  expect(files.map(({ name }) => name)).toEqual(["walk.bvh"]);
  expect(problems.map(({ title, text }) => [title, text])).toEqual([
    ["pictures", "Expected a folder with motion clips (.bvh), models (.json) or tables (.csv)."],
    ["everything", "Expected a folder with at most 500 files and folders in it."],
  ]);
});

it("a folder that cannot be read gets the browser's reason", async () => {
  const locked = folder("locked", []);
  locked.createReader = () => ({ readEntries: (_, failed) => failed(new Error("permission denied")) });
  const { problems } = await droppedFiles([dropped(locked)]);
  expect(problems).toEqual([{ title: "locked", text: "permission denied" }]);
});
