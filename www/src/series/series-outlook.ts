// The futures of a model of tables. Loaded on demand.
import { Latest } from "../engine/latest";
import type { ShownOutlook } from "../latents/layers-store";
import type { Future } from "../latents/outlook-drawing";
import { FUTURES } from "../latents/outlook-store";
import { Store } from "../ui/store";
import type { SeriesStore } from "./series-store";

export class SeriesOutlook extends Store implements ShownOutlook {
  seed = 1;
  futures: readonly Future[] = [];
  readonly moments = null;
  #shown = false;
  /** The rollout whose futures were asked for. */
  #asked: SeriesStore["rollout"] = null;
  readonly #newest: Latest<number, readonly Future[]>;

  constructor(private readonly model: SeriesStore) {
    super();
    this.#newest = new Latest<number, readonly Future[]>(
      (seed) => model.sample(FUTURES, seed),
      (futures) => this.#take(futures),
      () => this.show("futures", false),
    );
    model.on(() => {
      if (model.rollout !== this.#asked) this.#ask();
    });
  }

  isShown(outlook: string): boolean {
    return this.#shown && outlook === "futures";
  }

  pictureOf(): null {
    return null;
  }

  show(_: string, shown: boolean): void {
    this.#shown = shown;
    this.#ask();
  }

  drawOthers(): void {
    this.seed += FUTURES;
    this.#ask();
  }

  #ask(): void {
    this.#asked = this.model.rollout;
    this.#newest.drop();
    this.#take([]);
    if (this.#shown) this.#newest.request(this.seed);
  }

  #take(futures: readonly Future[]): void {
    this.futures = futures;
    this.changed();
  }
}
