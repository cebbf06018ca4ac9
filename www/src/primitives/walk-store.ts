// The large figure, which goes on without an end while its primitives, couplings and tempos change.
import type { LibraryInfo, WalkChange } from "../engine/library-protocol";
import { LiveTrack } from "../scene/live-track";
import { LONGEST_PICTURE } from "../stage/playback";
import { Player } from "../stage/player";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import type { HeldLibrary } from "./held-library";
import { Seam } from "./seam";

/** Seconds that are kept. */
const KEPT_SECONDS = 4;
/** Frames that are there before the clock needs them: what the visitor does is seen so much later. */
const LEAD = 3;

/** A part takes so many frames to go all the way to another of its primitives: at once it would jump. */
const MIX_FRAMES = 30;

/** A part on its way to another of its primitives: how far it is, and how far it shall go. */
interface Mixing {
  other: number;
  share: number;
  goal: number;
}

/** Whether a later change of this kind makes an earlier one needless. */
const replaces = (later: WalkChange, earlier: WalkChange): boolean =>
  later.kind === earlier.kind &&
  (later.kind === "couplings" || (earlier.kind !== "couplings" && later.part === earlier.part));

export class WalkStore extends Store {
  readonly player = new Player();
  readonly #held: HeldLibrary;
  readonly #notices: NoticesStore;
  #track: LiveTrack | null = null;
  #seam = new Seam();
  #changes: WalkChange[] = [];
  readonly #mixing = new Map<number, Mixing>();
  /** Whether one of them would make the figure jump. */
  #leaps = false;
  #busy = false;
  /** Grows with every walk: answers for an older one are dropped. */
  #walks = 0;

  constructor(held: HeldLibrary, notices: NoticesStore) {
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
    this.#mixing.clear();
    const track = new LiveTrack({ nodes: figure.nodes.length, frameTime }, Math.round(KEPT_SECONDS / frameTime));
    const motion = await this.#held.ask(async (worker) => {
      await worker.startWalk([...uses]);
      return worker.advanceWalk([], LEAD);
    });
    if (walks !== this.#walks) return;
    this.#seam = new Seam();
    this.#seam.pass(motion.positions, motion.frames);
    track.append(motion);
    this.#track = track;
    this.player.frame = 0;
    this.player.follow(track.last, frameTime);
    this.changed();
  }

  /**
   * From the next frame on. Of changes of one thing only the newest counts. `leaps`: it is a large one, not a step of a slider that is
   * dragged.
   */
  change(change: WalkChange, leaps = change.kind === "use"): void {
    this.#leaps ||= leaps;
    if (change.kind === "mix") {
      const { part, other, share: goal } = change;
      const before = this.#mixing.get(part);
      this.#mixing.set(part, { other, share: before?.other === other ? before.share : 0, goal });
      return;
    }
    if (change.kind === "use") this.#mixing.delete(change.part);
    this.#changes = [...this.#changes.filter((earlier) => !replaces(change, earlier)), change];
  }

  togglePlay(): void {
    if (this.player.playing) this.player.pause();
    else this.player.play();
    this.changed();
  }

  /** Called once a display frame, so many seconds after the last call. */
  advance(seconds: number): void {
    this.player.advance(seconds);
    void this.#fill(seconds);
  }

  /** One frame on; back as far as frames are kept. */
  step(direction: 1 | -1): void {
    const track = this.#track;
    if (!track) return;
    this.player.step(direction);
    this.player.frame = Math.max(this.player.frame, track.first);
    void this.#fill(0);
    this.changed();
  }

  /** Moves the mixes as far as so many frames allow. */
  #mixOn(frames: number): WalkChange[] {
    const changes: WalkChange[] = [];
    for (const [part, mixing] of this.#mixing) {
      const { other, share, goal } = mixing;
      if (share === goal) continue;
      const most = frames / MIX_FRAMES;
      mixing.share = Math.abs(goal - share) <= most ? goal : share + Math.sign(goal - share) * most;
      changes.push({ kind: "mix", part, other, share: mixing.share });
    }
    return changes;
  }

  /** Asks for frames before the clock needs them. */
  async #fill(seconds: number): Promise<void> {
    const track = this.#track;
    if (!track || this.#busy) return;
    const ahead = LEAD + Math.min(LONGEST_PICTURE, seconds) / track.motion.frameTime;
    const frames = Math.ceil(ahead + this.player.frame - track.last);
    if (frames < 1) return;
    this.#busy = true;
    const walks = this.#walks;
    const changes = [...this.#changes, ...this.#mixOn(frames)];
    this.#changes = [];
    const leaps = this.#leaps;
    this.#leaps = false;
    try {
      const motion = await this.#held.ask((worker) => worker.advanceWalk(changes, frames));
      if (walks !== this.#walks) return;
      if (leaps) this.#seam.open();
      this.#seam.pass(motion.positions, motion.frames);
      track.append(motion);
      this.player.follow(track.last, track.motion.frameTime);
    } catch (problem) {
      if (walks !== this.#walks) return;
      this.#track = null;
      this.#notices.addError("The figure has stopped", messageOf(problem));
      this.changed();
    } finally {
      this.#busy = false;
    }
  }
}
