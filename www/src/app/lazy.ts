// What is loaded only when it is first asked for.

export class Lazy<Value> {
  #value: Promise<Value> | null = null;

  constructor(private readonly load: () => Promise<Value>) {}

  #loaded: Value | null = null;

  /** What was loaded; null before. */
  get loaded(): Value | null {
    return this.#loaded;
  }

  /** Loads it, once; after a failure it may be tried again. */
  get(): Promise<Value> {
    this.#value ??= this.#load();
    return this.#value;
  }

  async #load(): Promise<Value> {
    try {
      this.#loaded = await this.load();
      return this.#loaded;
    } catch (problem) {
      this.#value = null;
      throw problem;
    }
  }
}
