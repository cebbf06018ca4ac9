// The quality of pictures that this machine can draw in time.

/** Seconds of a drawn frame: above the first value the machine is slow, below the second it is fast again. */
const SLOW = 0.042;
const FAST = 0.024;
/** Seconds without a change after which a coarse picture is drawn again in fine quality. */
const REST = 0.25;

export type Quality = "fine" | "plain" | "coarse";

export class PictureQuality {
  /** Seconds a drawn frame takes, smoothed. */
  #taken = 0.017;
  #slow = false;
  #sinceChange = REST;
  #coarse = false;
  #drew = false;

  /** Called once a display frame. `seconds` since the last call; `changed`: the picture is out of date. */
  next(seconds: number, changed: boolean, playing: boolean): Quality {
    if (this.#drew) this.#taken += 0.1 * (Math.min(seconds, 0.2) - this.#taken);
    this.#drew = false;
    this.#slow = this.#taken > (this.#slow ? FAST : SLOW);
    const again = changed && this.#sinceChange < REST;
    this.#sinceChange = changed ? 0 : this.#sinceChange + seconds;
    // Many changes without play mean a drag, whose answers matter more than the picture.
    this.#coarse = this.#slow && !playing && (again || (this.#coarse && this.#sinceChange < REST));
    return this.#coarse ? "coarse" : this.#slow ? "plain" : "fine";
  }

  /** The frame of the last call of `next` was drawn. */
  drawn(): void {
    this.#drew = true;
  }
}
