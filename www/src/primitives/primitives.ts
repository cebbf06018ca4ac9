// The stores of this room, which belong together.
import type { ClipsStore } from "../clips/clips-store";
import type { WholeProgram } from "../engine/whole-engine";
import type { NoticesStore } from "../ui/notices-store";
import { FittingStore } from "./fitting-store";
import { LibraryStore } from "./library-store";

/** The document of the library that comes with the page. */
async function fetchLibrary(): Promise<string> {
  const answer = await fetch(new URL("primitives/library.json", document.baseURI));
  if (!answer.ok) throw new Error(`the host answered ${answer.status} for ${answer.url}`);
  return answer.text();
}

export function openPrimitives(whole: WholeProgram, clips: ClipsStore, notices: NoticesStore) {
  const library = new LibraryStore(whole, notices, fetchLibrary);
  return { library, fitting: new FittingStore(whole, clips, library) };
}
