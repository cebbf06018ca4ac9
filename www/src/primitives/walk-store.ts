// The large figure, which walks without an end while its primitives, couplings and tempos change.
import type { LibraryInfo, WalkChange } from "../engine/library-protocol";
import type { Motion } from "../engine/protocol";
import { LiveTrack } from "../scene/live-track";
import { Player } from "../stage/player";
import { LONGEST_PICTURE } from "../ui/browser";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import type { LibraryWorker } from "./library-worker";
import { primitivesWords } from "./view-words";

/** Frames in which the jump fades. */
export const TRANSITION_FRAMES = 15;

/** From 1 to 0, smooth at both ends. */
function fade(share: number): number {
  const left = 1 - Math.min(1, Math.max(0, share));
  return left * left * (3 - 2 * left);
}

/** The next pose by linear extrapolation. */
export function extrapolated(before: Float32Array, last: Float32Array): Float32Array {
  return last.map((value, i) => 2 * value - before[i]!);
}

/** Adds the rest of the jump to each frame. */
export class Transition {
  #jump: Float32Array | null = null;
  /** The frame before the jump. */
  #start = 0;

  /** Starts a transition at a frame with this pose, where another pose was expected. */
  start(frame: number, pose: Float32Array, expected: Float32Array): void {
    this.#jump = expected.map((value, i) => value - pose[i]!);
    this.#start = frame - 1;
  }

  /** Changes frames [frames x nodes x 3] in place; `first`: the number of the first frame. */
  apply(positions: Float32Array, frames: number, first: number): void {
    const jump = this.#jump;
    if (!jump) return;
    for (let k = 0; k < frames; k++) {
      const left = fade((first + k - this.#start) / TRANSITION_FRAMES);
      const pose = positions.subarray(k * jump.length, (k + 1) * jump.length);
      if (left > 0) for (let i = 0; i < pose.length; i++) pose[i]! += left * jump[i]!;
    }
  }
}

/** Stored seconds. */
const STORED_SECONDS = 4;
/** Frames computed ahead of the clock. After a change of the visitor they are computed again. */
const LEAD = 3;
/** Frames of one request: few requests leave the worker free for changes of the visitor. */
const PIECE = 6;

/** Changes that act on all frames after `after`. */
interface Made {
  after: number;
  changes: readonly WalkChange[];
}

/** Changes of the same subject replace each other. */
const subjectOf = (change: WalkChange): string =>
  "part" in change ? `${change.kind} ${change.part}` : "couplings";

/** The newest change of each subject. */
function newest(changes: readonly WalkChange[]): WalkChange[] {
  const places = new Map(changes.map((change, place) => [subjectOf(change), place]));
  return changes.filter((change, place) => places.get(subjectOf(change)) === place);
}

/** The expected pose after a frame, without changes; null if it is unknown. */
function expectedAfter(track: LiveTrack, frame: number): Float32Array | null {
  const [before, last, next] = [track.frame(frame - 1), track.frame(frame), track.frame(frame + 1)];
  if (next) return next.slice();
  return before && last && extrapolated(before, last);
}

export class WalkStore extends Store {
  readonly player = new Player();
  #track: LiveTrack | null = null;
  #transition = new Transition();
  #changes: WalkChange[] = [];
  /** Changes in frames that may be computed again. */
  #made: Made[] = [];
  /** The last frame that the clock has reached. */
  #seen = 0;
  /** Whether a change would make the figure jump. */
  #leaps = false;
  #busy = false;
  /** The number of walks. Answers for an earlier walk are dropped. */
  #walks = 0;

  constructor(
    private readonly worker: LibraryWorker,
    private readonly notices: NoticesStore,
  ) {
    super();
  }

  /** The newest frames; null without a walk. */
  get track(): LiveTrack | null {
    return this.#track;
  }

  /** Starts a new walk with a combination. */
  async start({ figure, frameTime }: LibraryInfo, uses: readonly number[]): Promise<void> {
    this.#walks += 1;
    const walks = this.#walks;
    this.#track = null;
    this.#changes = [];
    this.#made = [];
    const track = new LiveTrack(
      { nodes: figure.nodes.length, frameTime },
      Math.round(STORED_SECONDS / frameTime),
    );
    const motion = await this.worker.ask(async (worker) => {
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

  /** Acts from the next frame on that was not shown. `leaps`: the change is large, not a step of a slider. */
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

  /** Called once a display frame, `seconds` after the last call. */
  advance(seconds: number): void {
    this.player.advance(seconds);
    this.#seen = Math.max(this.#seen, this.player.frame);
    void this.#fill(seconds);
  }

  /** One frame forward or back, within the stored frames. */
  step(direction: 1 | -1): void {
    const track = this.#track;
    if (!track) return;
    this.player.step(direction);
    this.#goTo(Math.max(this.player.frame, track.first));
    void this.#fill(0);
  }

  /** Moves the clock to a frame. */
  #goTo(frame: number): void {
    this.player.frame = Math.min(frame, this.player.last);
    this.#seen = Math.max(this.#seen, this.player.frame);
    this.changed();
  }

  /** The last frame that does not change. A paused figure is between two frames, which both stay. */
  get #lastUnchanged(): number {
    return this.player.playing ? Math.floor(this.#seen) : Math.ceil(this.#seen);
  }

  /** Asks for frames after all changes of this moment. */
  #fillSoon(): void {
    queueMicrotask(() => void this.#fill(0));
  }

  /** Asks for frames ahead of the clock, and after a change again for those that were not shown. */
  async #fill(seconds: number): Promise<void> {
    const track = this.#track;
    if (!track || this.#busy) return;
    const again = this.#changes.length > 0;
    const from = again ? Math.min(this.#lastUnchanged, track.last) : track.last;
    const back = track.last - from;
    const piece = again ? 1 : PIECE;
    const ahead = LEAD + piece - 1 + Math.min(LONGEST_PICTURE, seconds) / track.motion.frameTime;
    // A paused figure moves on to the end of the transition, so that the change is visible.
    const onward = this.#leaps && !this.player.playing ? TRANSITION_FRAMES : 0;
    const frames = Math.max(back, Math.ceil(ahead + onward + this.player.frame - from));
    if (frames < piece) return;
    this.#busy = true;
    const walks = this.#walks;
    const changes = this.#changesAfter(from);
    const leaps = this.#leaps;
    this.#leaps = false;
    try {
      const motion = await this.worker.ask((worker) => worker.advanceWalk(back, changes, frames));
      if (walks !== this.#walks) return;
      this.#take(track, motion, from, leaps);
      if (onward > 0 && !this.player.playing) this.#goTo(from + onward);
    } catch (problem) {
      if (walks !== this.#walks) return;
      this.#track = null;
      this.notices.addError(primitivesWords().stopped, messageOf(problem));
      this.changed();
    } finally {
      this.#busy = false;
      if (this.#changes.length > 0) this.#fillSoon();
    }
  }

  /** The changes after a frame: those of the frames computed again, and the new ones. */
  #changesAfter(frame: number): WalkChange[] {
    const again = this.#made.filter(({ after }) => after >= frame).flatMap(({ changes }) => changes);
    const changes = newest([...again, ...this.#changes]);
    this.#changes = [];
    const seen = Math.floor(this.#seen);
    const before = this.#made.filter(({ after }) => after >= seen && after < frame);
    this.#made = [...before, { after: frame, changes }];
    return changes;
  }

  /** Replaces the frames after `from`, except those that the clock has reached meanwhile. */
  #take(track: LiveTrack, motion: Motion, from: number, leaps: boolean): void {
    const unchanged = Math.max(from, Math.min(this.#lastUnchanged, track.last));
    const width = 3 * motion.nodes;
    const positions = motion.positions.subarray((unchanged - from) * width);
    const frames = motion.frames - (unchanged - from);
    const expected = leaps ? expectedAfter(track, unchanged) : null;
    if (expected && frames > 0) this.#transition.start(unchanged + 1, positions.subarray(0, width), expected);
    else this.#leaps ||= leaps;
    this.#transition.apply(positions, frames, unchanged + 1);
    track.cutAfter(unchanged);
    track.append({ ...motion, positions, frames });
    this.player.follow(track.last, track.motion.frameTime);
  }
}
