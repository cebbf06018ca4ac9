// The recordings that can move a part of the combination, and what the combination infers of them.
import type { ClipsStore } from "../clips/clips-store";
import { observed, type Recording, recordingsOf } from "../completing/recordings";
import { OpenDocument } from "../engine/open-document";
import type { CompletedClip } from "../engine/whole-protocol";
import type { WholeCalls, WholeWorkers } from "../engine/whole-workers";
import { completingWords } from "../words/sections";
import { Store } from "../ui/store";
import type { LibraryStore } from "./library-store";

export class LibraryRecordings extends Store {
  readonly #document: OpenDocument<WholeCalls, void>;

  constructor(
    private readonly library: LibraryStore,
    private readonly clips: ClipsStore,
    { desk }: Pick<WholeWorkers, "desk">,
  ) {
    super();
    this.#document = new OpenDocument(desk, (worker, text) => worker.openOutlook(text));
    clips.on(() => this.changed());
  }

  get all(): readonly Recording[] {
    const { current } = this.library;
    return current ? recordingsOf(this.clips, current.info.joints) : [];
  }

  get revision(): number {
    return this.library.revision;
  }

  async infer(part: number, { source, first, end }: Recording): Promise<CompletedClip> {
    const { current } = this.library;
    if (!current || !source) throw new Error(completingWords().notReady);
    const request = { ...observed(current.info, part), clip: { id: 0, source, first, end } };
    return this.#document.ask(await this.library.combinationText(), (worker) => worker.complete(request));
  }
}
