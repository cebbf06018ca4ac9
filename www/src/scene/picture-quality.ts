// How fine a picture this machine can draw: finest first, and coarser only where it falls behind.

/** Seconds a drawn frame may take; beyond it the machine is slow, and fast again below the second. */
const SLOW = 0.042;
const FAST = 0.024;
/** Seconds without a change after which a coarse picture is drawn again finely. */
const REST = 0.25;

export type Quality = "fine" | "plain" | "coarse";

export class PictureQuality {
  /** Seconds a drawn frame takes, smoothed. */
  #taken = 0.017;
  #slow = false;
  #sinceChange = REST;
  #coarse = false;
  #drew = false;

  /**
   * Called once a display frame. `seconds` since the last call; `changed`: there is something to draw;
   * `playing`: or soon will be.
   */
  next(seconds: number, changed: boolean, playing: boolean): Quality {
    if (this.#drew) this.#taken += 0.1 * (Math.min(seconds, 0.2) - this.#taken);
    this.#drew = false;
    this.#slow = this.#taken > (this.#slow ? FAST : SLOW);
    const again = changed && this.#sinceChange < REST;
    this.#sinceChange = changed ? 0 : this.#sinceChange + seconds;
    // Changes in quick succession without play: something is dragged, and its answers matter more than the
    // picture.
    this.#coarse = this.#slow && !playing && (again || (this.#coarse && this.#sinceChange < REST));
    return this.#coarse ? "coarse" : this.#slow ? "plain" : "fine";
  }

  /** The frame of the last call of `next` was drawn. */
  drawn(): void {
    this.#drew = true;
  }
}
