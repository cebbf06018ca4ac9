// The library that a worker holds for the page. A worker that had to be replaced is given it again.
import type { Addition, CouplingsFrom, LibraryInfo } from "../engine/library-protocol";
import type { Couplings } from "../engine/protocol";
import type { WholeCalls, WholeWorkers } from "../engine/whole-workers";

export class LibraryWorker {
  readonly #whole: WholeWorkers;
  #text = "";
  #holder: WholeCalls | null = null;

  constructor(whole: WholeWorkers) {
    this.#whole = whole;
  }

  /** The document of the library; empty before there is one. */
  get text(): string {
    return this.#text;
  }

  /** Takes another library up; the one before stays where that fails. */
  async open(text: string): Promise<LibraryInfo> {
    this.#holder = null;
    const info = await this.#whole.library.run(async (worker) => {
      const info = await worker.openLibrary(text);
      this.#holder = worker;
      return info;
    });
    this.#text = text;
    return info;
  }

  /** Adds a combination as a movement of that name; answers the library with it. */
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

  /** Adds the primitives of another library, where they fit. */
  async take(text: string): Promise<Addition> {
    const addition = await this.ask((worker) => worker.addPrimitives(text));
    if ("text" in addition) this.#text = addition.text;
    return addition;
  }

  /** Asks the worker that holds the library. */
  async ask<Answer>(question: (worker: WholeCalls) => Promise<Answer>): Promise<Answer> {
    return this.#whole.library.run(async (worker) => {
      if (worker !== this.#holder) {
        await worker.openLibrary(this.#text);
        this.#holder = worker;
      }
      return question(worker);
    });
  }
}
