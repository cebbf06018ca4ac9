// A document that a worker keeps open. Calls about it need not send it again; a fresh worker opens it first.
import type { Pool } from "./pool";

export class OpenDocument<Worker, Info> {
  readonly #open: (worker: Worker, text: string) => Promise<Info>;
  /** The worker that has the document open, and which document. */
  #holder: Worker | null = null;
  #text = "";

  constructor(
    private readonly pool: Pool<Worker>,
    open: (worker: Worker, text: string) => Promise<Info>,
  ) {
    this.#open = open;
  }

  open(text: string): Promise<Info> {
    return this.pool.run((worker) => this.#openIn(worker, text));
  }

  /** Makes a call to a worker that has this document open. */
  ask<Answer>(text: string, call: (worker: Worker) => Promise<Answer>): Promise<Answer> {
    return this.pool.run(async (worker) => {
      if (worker !== this.#holder || text !== this.#text) await this.#openIn(worker, text);
      return call(worker);
    });
  }

  /** The worker has changed the open document itself, into this one. */
  replace(text: string): void {
    this.#text = text;
  }

  async #openIn(worker: Worker, text: string): Promise<Info> {
    this.#holder = null;
    const info = await this.#open(worker, text);
    [this.#holder, this.#text] = [worker, text];
    return info;
  }
}
