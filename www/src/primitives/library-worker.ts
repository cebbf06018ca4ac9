// The worker that has the library open. A replaced worker opens the library again.
import type { CouplingsFrom, LibraryInfo } from "../engine/library-protocol";
import type { Couplings } from "../engine/protocol";
import type { WholeCalls, WholeWorkers } from "../engine/whole-workers";

export class LibraryWorker {
  #text = "";
  #holder: WholeCalls | null = null;

  constructor(private readonly whole: WholeWorkers) {}

  /** The document of the library; empty before there is one. */
  get text(): string {
    return this.#text;
  }

  /** Opens another library. The previous one stays open if that fails. */
  async open(text: string): Promise<LibraryInfo> {
    this.#holder = null;
    const info = await this.whole.library.run(async (worker) => {
      const info = await worker.openLibrary(text);
      this.#holder = worker;
      return info;
    });
    this.#text = text;
    return info;
  }

  /** Adds a combination as a movement, and returns the new library. */
  async add(
    name: string,
    uses: readonly number[],
    alpha: Couplings,
    from: CouplingsFrom | null,
  ): Promise<{ text: string; info: LibraryInfo }> {
    const added = await this.ask((worker) => worker.addCombination(name, [...uses], alpha, from));
    this.#text = added.text;
    return added;
  }

  /** Adds the primitives of another library. Throws the reason if they do not fit. */
  async take(text: string): Promise<{ text: string; info: LibraryInfo }> {
    const added = await this.ask((worker) => worker.addPrimitives(text));
    this.#text = added.text;
    return added;
  }

  /** Calls the worker that has the library open. */
  async ask<Answer>(question: (worker: WholeCalls) => Promise<Answer>): Promise<Answer> {
    return this.whole.library.run(async (worker) => {
      if (worker !== this.#holder) {
        await worker.openLibrary(this.#text);
        this.#holder = worker;
      }
      return question(worker);
    });
  }
}
