// Pictures of how sure the model is in the planes of the plots. A worker paints them; the newest of each part
// is kept.
import { Latest } from "../engine/latest";
import type { RolloutResult } from "../engine/protocol";
import type { PlanePicture } from "../engine/whole-protocol";

export interface Wanted {
  rollout: RolloutResult;
  part: number;
  picture: PlanePicture;
}

interface Painted {
  key: string;
  bitmap: ImageBitmap;
}

export class PlanePictures {
  readonly #paint: (wanted: Wanted) => Promise<ImageBitmap>;
  readonly #arrived: () => void;
  readonly #failed: (problem: unknown) => void;
  readonly #painted = new Map<number, Painted>();
  /** One queue for each part: the newest request of each counts. */
  readonly #queues = new Map<number, Latest<Wanted, ImageBitmap>>();
  readonly #wanted = new Map<number, string>();

  constructor(
    paint: (wanted: Wanted) => Promise<ImageBitmap>,
    arrived: () => void,
    failed: (problem: unknown) => void,
  ) {
    this.#paint = paint;
    this.#arrived = arrived;
    this.#failed = failed;
  }

  /** The picture, or null before it has arrived; a picture of other couplings stays until then. */
  pictureOf(wanted: Wanted): ImageBitmap | null {
    const { part, picture, rollout } = wanted;
    const geometry = JSON.stringify([rollout.revision, picture]);
    const key = JSON.stringify([geometry, rollout.request]);
    if (this.#wanted.get(part) !== key) {
      this.#wanted.set(part, key);
      this.#queue(part).request(wanted);
    }
    const painted = this.#painted.get(part);
    return painted?.key === geometry ? painted.bitmap : null;
  }

  clear(): void {
    for (const queue of this.#queues.values()) queue.drop();
    for (const { bitmap } of this.#painted.values()) bitmap.close();
    this.#painted.clear();
    this.#wanted.clear();
  }

  #queue(part: number): Latest<Wanted, ImageBitmap> {
    const known = this.#queues.get(part);
    if (known) return known;
    const queue = new Latest<Wanted, ImageBitmap>(
      (wanted) => this.#paint(wanted),
      (bitmap, { rollout, picture }) => {
        this.#painted.get(part)?.bitmap.close();
        this.#painted.set(part, { key: JSON.stringify([rollout.revision, picture]), bitmap });
        this.#arrived();
      },
      (problem) => this.#failed(problem),
    );
    this.#queues.set(part, queue);
    return queue;
  }
}
