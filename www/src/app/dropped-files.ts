// The files of a drop, those in folders included.
import { messageOf } from "../ui/format";
import { lab } from "../words/lab";

/** A folder with more files than that was hardly meant. */
const MOST_FILES = 500;

const isOurs = (name: string) => /^[^.].*\.(bvh|json|csv)$/i.test(name);

/** What a folder of the visitor's disk is to a page. */
export interface FolderEntry {
  isDirectory: true;
  name: string;
  createReader(): { readEntries(found: (entries: Entry[]) => void, failed: (why: unknown) => void): void };
}
interface FileEntry {
  isDirectory: false;
  name: string;
  file(found: (file: File) => void, failed: (why: unknown) => void): void;
}
export type Entry = FolderEntry | FileEntry;

/** A dropped item while its event lasts. */
export interface Item {
  kind: string;
  getAsFile(): File | null;
  webkitGetAsEntry(): unknown;
}

export interface DroppedFiles {
  files: File[];
  /** A sentence for each folder that gave no files. */
  problems: { title: string; text: string }[];
}

/** Reads the items of a drop. Call it while the event lasts: the items are gone afterwards. */
export function droppedFiles(items: Iterable<Item>): Promise<DroppedFiles> {
  const dropped = [...items]
    .filter(({ kind }) => kind === "file")
    .map((item) => ({ file: item.getAsFile(), entry: item.webkitGetAsEntry() as Entry | null }));
  return collect(dropped);
}

async function collect(
  dropped: readonly { file: File | null; entry: Entry | null }[],
): Promise<DroppedFiles> {
  const files: File[] = [];
  const problems: DroppedFiles["problems"] = [];
  for (const { file, entry } of dropped) {
    if (!entry?.isDirectory) {
      if (file) files.push(file);
      continue;
    }
    try {
      const found = await filesIn(entry);
      if (found.length === 0) throw new Error(lab().files.expectedFolder);
      files.push(...found);
    } catch (problem) {
      problems.push({ title: entry.name, text: messageOf(problem) });
    }
  }
  return { files, problems };
}

/** The files of a folder and of all folders in it that this page may open, by their names. */
async function filesIn(folder: FolderEntry): Promise<File[]> {
  const files: File[] = [];
  const folders = [folder];
  for (let next = folders.pop(); next; next = folders.pop()) {
    for (const entry of await entriesOf(next)) {
      if (entry.isDirectory) folders.push(entry);
      else if (isOurs(entry.name))
        files.push(await new Promise<File>((found, failed) => entry.file(found, failed)));
      if (files.length + folders.length > MOST_FILES) throw new Error(lab().files.largeFolder(MOST_FILES));
    }
  }
  return files.sort((a, b) => a.name.localeCompare(b.name, "en", { numeric: true }));
}

async function entriesOf(folder: FolderEntry): Promise<Entry[]> {
  const reader = folder.createReader();
  const entries: Entry[] = [];
  // A browser gives the entries of a large folder in several portions.
  for (;;) {
    const portion = await new Promise<Entry[]>((found, failed) => reader.readEntries(found, failed));
    if (portion.length === 0) return entries;
    entries.push(...portion);
  }
}
