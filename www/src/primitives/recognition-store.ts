// Which primitive of the library each part uses in a recording, moment by moment. The recording is up to three
// clips, one after the other.
import type { ClipEntry, ClipsStore } from "../clips/clips-store";
import type { LibraryInfo, Recognised, RecognisedSegment } from "../engine/library-protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import { Player } from "../stage/player";
import { messageOf } from "../ui/format";
import { Store } from "../ui/store";
import { shownPart } from "../words/lab";
import type { LibraryStore } from "./library-store";

/** The places of the clips. */
export const PLACES = 3;

/** A time in which a part uses one primitive, in frames. */
export interface Band {
  primitive: number;
  first: number;
  end: number;
}

/** The bands of a part: neighbouring segments in which the part uses the same primitive are one band. */
export function bandsOf(segments: readonly RecognisedSegment[], part: number): Band[] {
  const bands: Band[] = [];
  for (const { uses, first, end } of segments) {
    const primitive = uses[part] ?? -1;
    const last = bands.at(-1);
    if (last?.primitive === primitive) last.end = end;
    else bands.push({ primitive, first, end });
  }
  return bands;
}

/** The movement of a segment; where the parts use primitives of several movements, the primitive of each part. */
export function nameOf(
  { movement, uses }: RecognisedSegment,
  { movements, parts, primitives }: Pick<LibraryInfo, "movements" | "parts" | "primitives">,
): string {
  if (movement !== null) return movements[movement]?.name ?? "";
  const ofPart = ({ name }: { name: string }, part: number) =>
    `${shownPart(name)}: ${primitives[uses[part] ?? -1]?.name ?? ""}`;
  return parts.map(ofPart).join("; ");
}

export class RecognitionStore extends Store {
  readonly player = new Player();
  readonly #clips: ClipsStore;
  /** The keys of the clips; empty for none, null where the visitor has not chosen. */
  readonly #keys: (string | null)[] = Array.from({ length: PLACES }, () => null);
  #found: Recognised | null = null;
  /** The share that is done; null while nothing is under way. */
  #fraction: number | null = null;
  #problem = "";
  #stop = new AbortController();

  constructor(
    private readonly whole: WholeWorkers,
    clips: ClipsStore,
    private readonly library: LibraryStore,
  ) {
    super();
    this.#clips = clips;
    let text = library.current?.text;
    library.on(() => {
      if (library.current?.text === text) return;
      text = library.current?.text;
      this.cancel();
    });
    clips.on(() => {
      if (this.#keys.some((key) => key && !clips.all.some((clip) => clip.key === key))) this.cancel();
      this.changed();
    });
  }

  /** The clips of the body of the library. */
  get clips(): readonly ClipEntry[] {
    const { current } = this.library;
    return current ? this.#clips.ofBody(current.info.joints) : [];
  }

  /** The clip of each place; null for none. */
  get chosen(): readonly (ClipEntry | null)[] {
    const example = this.#example;
    return this.#keys.map((key, place) => {
      const wanted = key ?? example[place]?.key;
      return this.clips.find((clip) => clip.key === wanted) ?? null;
    });
  }

  /** The recording with its primitives; null before. */
  get found(): Recognised | null {
    return this.#found;
  }

  /** The share that is done; null while nothing is under way. */
  get fraction(): number | null {
    return this.#fraction;
  }

  /** The reason why it failed; else empty. */
  get problem(): string {
    return this.#problem;
  }

  /** Chooses the clip of a place; empty: none. */
  choose(place: number, key: string): void {
    this.#keys[place] = key;
    this.cancel();
  }

  async recognise(): Promise<void> {
    const { current } = this.library;
    const clips = this.chosen.flatMap((clip) =>
      clip ? [{ id: clip.loaded.id, source: clip.source, first: clip.first, end: clip.end }] : [],
    );
    if (!current || clips.length === 0) return;
    this.cancel();
    const stop = new AbortController();
    this.#stop = stop;
    this.#fraction = 0;
    this.changed();
    const report = (fraction: number) => {
      if (stop.signal.aborted) return;
      this.#fraction = fraction;
      this.changedSoon();
    };
    let found: Recognised | null = null;
    let problem = "";
    try {
      const job = { library: current.text, clips };
      found = await this.whole.pool.run((worker) => worker.recognise(job, report, stop.signal), stop.signal);
    } catch (reason) {
      problem = messageOf(reason);
    }
    if (stop.signal.aborted) return;
    [this.#found, this.#problem, this.#fraction] = [found, problem, null];
    if (found) {
      const { frames, frameTime } = found.motion;
      this.player.load(frames, frameTime, frames - 1);
      this.player.frame = 0;
    }
    this.changed();
  }

  /** Cancels the work and forgets what was found. */
  cancel(): void {
    this.#stop.abort();
    [this.#found, this.#problem, this.#fraction] = [null, "", null];
    this.changed();
  }

  togglePlay(): void {
    if (this.player.playing) this.player.pause();
    else this.player.play();
    this.changed();
  }

  /** Shows a frame. */
  goTo(frame: number): void {
    this.player.pause();
    this.player.scrub(frame);
    this.changed();
  }

  /**
   * The last clips of the visitor, or else a clip of one movement, one of another and one of the first.
   */
  get #example(): readonly ClipEntry[] {
    const own = this.clips.filter(({ origin }) => origin === "own");
    if (own.length > 0) return own.slice(-PLACES);
    const movement = ({ source, title }: ClipEntry) =>
      "sample" in source ? source.sample.replace(/-\d+$/, "") : title.replace(/ \d.*$/, "");
    const [first] = this.clips;
    if (!first) return [];
    const others = this.clips.filter((clip) => movement(clip) !== movement(first));
    const again = this.clips.filter((clip) => clip !== first && movement(clip) === movement(first));
    return [first, others[0], again[0]].filter((clip) => clip !== undefined);
  }
}
