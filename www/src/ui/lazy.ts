// A value that is loaded at its first use.

export class Lazy<Value> {
  #loading: Promise<Value> | null = null;
  #loaded: Value | null = null;

  constructor(private readonly load: () => Promise<Value>) {}

  /** The loaded value; null before. */
  get loaded(): Value | null {
    return this.#loaded;
  }

  /** Loads the value, once; after a failure the next call tries again. */
  get(): Promise<Value> {
    this.#loading ??= this.#loadNow();
    return this.#loading;
  }

  async #loadNow(): Promise<Value> {
    try {
      this.#loaded = await this.load();
      return this.#loaded;
    } catch (problem) {
      this.#loading = null;
      throw problem;
    }
  }
}
