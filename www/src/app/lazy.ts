// What is loaded only when it is first asked for.

export class Lazy<Value> {
  #value: Promise<Value> | null = null;

  constructor(private readonly load: () => Promise<Value>) {}

  /** Loads it, once; after a failure it may be tried again. */
  get(): Promise<Value> {
    this.#value ??= this.load().catch((problem: unknown) => {
      this.#value = null;
      throw problem;
    });
    return this.#value;
  }
}
