// The large figure, which goes on without an end while its primitives, couplings and tempos change.
import type { LibraryInfo, WalkChange } from "../engine/library-protocol";
import type { Motion } from "../engine/protocol";
import { LiveTrack } from "../scene/live-track";
import { Player } from "../stage/player";
import { LONGEST_PICTURE } from "../ui/each-frame";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import type { LibraryWorker } from "./library-worker";
import { onwards, TRANSITION_FRAMES, Transition } from "./transition";

/** Seconds that are kept. */
const KEPT_SECONDS = 4;
/**
 * Frames that are there before the clock needs them. Where the visitor changes something, those not yet seen
 * are made again.
 */
const LEAD = 3;
/**
 * So many are asked for at once, so that the worker is nearly always free when the visitor changes something.
 */
const PIECE = 6;

/** What acts on all frames after this one. */
interface Made {
  after: number;
  changes: readonly WalkChange[];
}

/** What a change is about. */
const subjectOf = (change: WalkChange): string =>
  "part" in change ? `${change.kind} ${change.part}` : "couplings";

/** Of changes of one thing only the newest. */
function newest(changes: readonly WalkChange[]): WalkChange[] {
  const places = new Map(changes.map((change, place) => [subjectOf(change), place]));
  return changes.filter((change, place) => places.get(subjectOf(change)) === place);
}

/** Where a figure was on its way to after a frame; null where that is not known. */
function expectedAfter(track: LiveTrack, frame: number): Float32Array | null {
  const [before, last, next] = [track.frame(frame - 1), track.frame(frame), track.frame(frame + 1)];
  if (next) return next.slice();
  return before && last && onwards(before, last);
}

export class WalkStore extends Store {
  readonly player = new Player();
  readonly #held: LibraryWorker;
  readonly #notices: NoticesStore;
  #track: LiveTrack | null = null;
  #transition = new Transition();
  #changes: WalkChange[] = [];
  /** What may have to be made again. */
  #made: Made[] = [];
  /** The farthest that the clock has been. */
  #seen = 0;
  /** Whether one of them would make the figure jump. */
  #leaps = false;
  #busy = false;
  /** Grows with every walk: answers for an older one are dropped. */
  #walks = 0;

  constructor(held: LibraryWorker, notices: NoticesStore) {
    super();
    this.#held = held;
    this.#notices = notices;
  }

  /** The newest frames; null without a walk. */
  get track(): LiveTrack | null {
    return this.#track;
  }

  /** Begins with a combination, in the place of the walk before. */
  async start({ figure, frameTime }: LibraryInfo, uses: readonly number[]): Promise<void> {
    this.#walks += 1;
    const walks = this.#walks;
    this.#track = null;
    this.#changes = [];
    this.#made = [];
    const track = new LiveTrack(
      { nodes: figure.nodes.length, frameTime },
      Math.round(KEPT_SECONDS / frameTime),
    );
    const motion = await this.#held.ask(async (worker) => {
      await worker.startWalk([...uses]);
      return worker.advanceWalk(0, [], LEAD);
    });
    if (walks !== this.#walks) return;
    this.#transition = new Transition();
    track.append(motion);
    this.#track = track;
    this.player.frame = 0;
    this.#seen = 0;
    this.player.follow(track.last, frameTime);
    this.changed();
  }

  /**
   * From the next frame on that nobody has seen. Of changes of one thing only the newest counts. `leaps`: it
   * is a large one, not a step of a slider that is dragged.
   */
  change(change: WalkChange, leaps = change.kind === "use"): void {
    this.#leaps ||= leaps;
    this.#changes.push(change);
    this.#fillSoon();
  }

  togglePlay(): void {
    if (this.player.playing) this.player.pause();
    else this.player.play();
    this.changed();
  }

  /** Called once a display frame, so many seconds after the last call. */
  advance(seconds: number): void {
    this.player.advance(seconds);
    this.#seen = Math.max(this.#seen, this.player.frame);
    void this.#fill(seconds);
  }

  /** One frame on; back as far as frames are kept. */
  step(direction: 1 | -1): void {
    const track = this.#track;
    if (!track) return;
    this.player.step(direction);
    this.#goTo(Math.max(this.player.frame, track.first));
    void this.#fill(0);
  }

  /** Stands at a frame from now on. */
  #goTo(frame: number): void {
    this.player.frame = Math.min(frame, this.player.last);
    this.#seen = Math.max(this.#seen, this.player.frame);
    this.changed();
  }

  /**
   * The last frame that stays as it is: of a figure that stands, the one that its picture leads to as well.
   */
  get #kept(): number {
    return this.player.playing ? Math.floor(this.#seen) : Math.ceil(this.#seen);
  }

  /** When all is said that belongs together. */
  #fillSoon(): void {
    queueMicrotask(() => void this.#fill(0));
  }

  /** Asks for frames before the clock needs them; after a change, also for those that were not seen yet. */
  async #fill(seconds: number): Promise<void> {
    const track = this.#track;
    if (!track || this.#busy) return;
    const again = this.#changes.length > 0;
    const from = again ? Math.min(this.#kept, track.last) : track.last;
    const back = track.last - from;
    const piece = again ? 1 : PIECE;
    const ahead = LEAD + piece - 1 + Math.min(LONGEST_PICTURE, seconds) / track.motion.frameTime;
    // A figure that stands goes on to where the leap is over: what the visitor did is to be seen.
    const onward = this.#leaps && !this.player.playing ? TRANSITION_FRAMES : 0;
    const frames = Math.max(back, Math.ceil(ahead + onward + this.player.frame - from));
    if (frames < piece) return;
    this.#busy = true;
    const walks = this.#walks;
    const changes = this.#changesAfter(from);
    const leaps = this.#leaps;
    this.#leaps = false;
    try {
      const motion = await this.#held.ask((worker) => worker.advanceWalk(back, changes, frames));
      if (walks !== this.#walks) return;
      this.#take(track, motion, from, leaps);
      if (onward > 0 && !this.player.playing) this.#goTo(from + onward);
    } catch (problem) {
      if (walks !== this.#walks) return;
      this.#track = null;
      this.#notices.addError("The figure has stopped", messageOf(problem));
      this.changed();
    } finally {
      this.#busy = false;
      if (this.#changes.length > 0) this.#fillSoon();
    }
  }

  /** What acts after a frame: what is taken back with the frames after it, and what is new. */
  #changesAfter(frame: number): WalkChange[] {
    const again = this.#made.filter(({ after }) => after >= frame).flatMap(({ changes }) => changes);
    const changes = newest([...again, ...this.#changes]);
    this.#changes = [];
    const seen = Math.floor(this.#seen);
    const before = this.#made.filter(({ after }) => after >= seen && after < frame);
    this.#made = [...before, { after: frame, changes }];
    return changes;
  }

  /** Puts frames in the place of those after `from`. What the clock has reached meanwhile stays. */
  #take(track: LiveTrack, motion: Motion, from: number, leaps: boolean): void {
    const kept = Math.max(from, Math.min(this.#kept, track.last));
    const width = 3 * motion.nodes;
    const positions = motion.positions.subarray((kept - from) * width);
    const frames = motion.frames - (kept - from);
    const expected = leaps ? expectedAfter(track, kept) : null;
    if (expected && frames > 0) this.#transition.open(kept + 1, positions.subarray(0, width), expected);
    else this.#leaps ||= leaps;
    this.#transition.pass(positions, frames, kept + 1);
    track.cutAfter(kept);
    track.append({ ...motion, positions, frames });
    this.player.follow(track.last, track.motion.frameTime);
  }
}
