// A file for the visitor's disk.
import { download } from "../ui/download";
import { messageOf } from "../ui/format";
import { lab } from "../words/lab";
import type { App } from "./app";

export interface SavedFile {
  name: string;
  type: string;
  content(): Promise<string | ArrayBuffer>;
  /** Called when the file was saved. */
  saved?(): void;
}

/** Saves a file; a notice says why it was not saved. */
export async function saveFile({ notices }: App, { name, type, content, saved }: SavedFile): Promise<void> {
  try {
    download(name, new Blob([await content()], { type }));
    saved?.();
  } catch (problem) {
    notices.addError(lab().files.notSaved(name), messageOf(problem));
  }
}
