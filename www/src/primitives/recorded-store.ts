// Movements of recorded people: the models of the page's library as files, and clips that they make.
import type { ClipsStore } from "../clips/clips-store";
import type { RecordedMovement } from "../engine/library-protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import { messageOf } from "../ui/format";
import { Store } from "../ui/store";
import { primitivesWords } from "./view-words";

export class RecordedStore extends Store {
  #movements: readonly RecordedMovement[] = [];
  #problem = "";
  #loading: Promise<void> | null = null;

  constructor(
    private readonly whole: WholeWorkers,
    private readonly clips: Pick<ClipsStore, "all" | "addModelled">,
    private readonly fetchLibrary: () => Promise<string>,
  ) {
    super();
  }

  /** The movements with their models; empty before they are loaded. */
  get movements(): readonly RecordedMovement[] {
    return this.#movements;
  }

  /** The reason why they could not be loaded; else empty. */
  get problem(): string {
    return this.#problem;
  }

  /** Adds the clips to the others, once; after a failure the next call tries again. */
  load(): Promise<void> {
    this.#loading ??= this.#load().catch((problem) => {
      this.#problem = messageOf(problem);
      this.#loading = null;
      this.changed();
    });
    return this.#loading;
  }

  async #load(): Promise<void> {
    this.#problem = "";
    const text = await this.fetchLibrary();
    const found = await this.whole.desk.run((worker) => worker.recordedMovements(text));
    const { clip } = primitivesWords().recorded;
    // An earlier visit may have brought the clips back.
    if (!this.clips.all.some(({ origin }) => origin === "model"))
      for (const { name, clips } of found)
        for (const [place, bvh] of clips.entries()) await this.clips.addModelled(clip(name, place + 1), bvh);
    this.#movements = found;
    this.changed();
  }
}
