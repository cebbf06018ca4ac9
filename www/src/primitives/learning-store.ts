// Learning a library: clips in groups, one group for each movement, and parts that all movements share or
// not.
import type { ClipEntry, ClipsStore } from "../clips/clips-store";
import { partsFor } from "../clips/parts";
import type { EngineStore } from "../engine/engine-store";
import type { PartSpec } from "../engine/protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import { pointsOf } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import type { LibraryStore } from "./library-store";
import { ProgressStore } from "../training/progress-store";
import { primitivesWords } from "./view-words";

/** The default number of chosen sample clips of a movement. */
const SAMPLES_CHOSEN = 2;

export interface LearningClip {
  key: string;
  title: string;
  chosen: boolean;
  /** The name of its group. */
  movement: string;
}

export class LearningStore extends ProgressStore<string> {
  readonly #clips: Pick<ClipsStore, "all" | "samplesLoaded" | "on">;
  /** The choices of the visitor, by the keys of the clips. */
  readonly #chosen = new Map<string, boolean>();
  readonly #named = new Map<string, string>();
  /** The names of the parts that all movements share. */
  readonly #shared = new Set<string>();

  constructor(
    private readonly whole: WholeWorkers,
    private readonly engine: Pick<EngineStore, "samples">,
    private readonly settings: Pick<SettingsStore, "values" | "on">,
    clips: Pick<ClipsStore, "all" | "samplesLoaded" | "on">,
    private readonly library: LibraryStore,
  ) {
    super();
    this.#clips = clips;
    clips.on(() => this.changed());
    settings.on(() => this.changed());
  }

  /** All clips with their groups. */
  get clips(): LearningClip[] {
    const all = this.#clips.all;
    const own = all.some(({ origin }) => origin === "own");
    const counts = new Map<string, number>();
    return all.map((clip) => {
      const first = this.#movementOf(clip);
      const movement = this.#named.get(clip.key) ?? first;
      const count = (counts.get(first) ?? 0) + 1;
      counts.set(first, count);
      const byDefault = clip.origin === (own ? "own" : "made") && (own || count <= SAMPLES_CHOSEN);
      return { key: clip.key, title: clip.title, movement, chosen: this.#chosen.get(clip.key) ?? byDefault };
    });
  }

  choose(key: string, chosen: boolean): void {
    this.#chosen.set(key, chosen);
    this.changed();
  }

  /** Puts a clip into a group; an empty name brings it back into its default group. */
  rename(key: string, movement: string): void {
    if (movement.trim() === "") this.#named.delete(key);
    else this.#named.set(key, movement.trim());
    this.changed();
  }

  /** The parts of the first chosen clip's body. */
  get parts(): PartSpec[] {
    const [first] = this.#groups().flatMap(({ clips }) => clips);
    const { parts, split } = this.settings.values;
    return first ? partsFor(first.loaded.info, parts, split) : [];
  }

  isShared(part: string): boolean {
    return this.#shared.has(part);
  }

  setShared(part: string, shared: boolean): void {
    if (shared) this.#shared.add(part);
    else this.#shared.delete(part);
    this.changed();
  }

  /** The reason why learning is not possible now; empty if it is. */
  get whyNot(): string {
    const words = primitivesWords().learning;
    if (!this.#clips.samplesLoaded) return words.gettingReady;
    const groups = this.#groups();
    if (groups.length === 0) return words.two;
    return groups.length < 2 ? words.another : "";
  }

  /** Learns the library, which then becomes the open one. */
  async learn(): Promise<void> {
    if (this.busy || this.whyNot) return;
    const groups = this.#groups();
    const parts = this.parts;
    const { latent, order, framesPerSecond, seed, maxIterations } = this.settings.values;
    const { dynamicsIps, poseIps } = pointsOf(this.settings.values);
    const job = {
      clips: groups.flatMap(({ clips }) =>
        clips.map(({ loaded, source, first, end }) => ({ id: loaded.id, source, first, end })),
      ),
      settings: { parts, latent, dynamicsIps, poseIps, order, framesPerSecond, seed, maxIterations },
      movements: groups.map(({ name, clips }) => ({ name, sequences: clips.length })),
      shared: parts.map(({ name }) => this.isShared(name)),
    };
    const text = await this.run((report, signal) =>
      this.whole.pool.run((worker) => worker.learnLibrary(job, report, signal), signal),
    );
    if (text !== null) await this.library.open(text, primitivesWords().library.learnedHere, true);
  }

  #movementOf({ source, title, origin }: ClipEntry): string {
    if (!("sample" in source)) return origin === "model" ? title.replace(/ \d.*$/, "") : title;
    return this.engine.samples.find(({ id }) => id === source.sample)?.movement ?? title;
  }

  /** The chosen clips, group by group. */
  #groups(): { name: string; clips: ClipEntry[] }[] {
    const groups = new Map<string, ClipEntry[]>();
    for (const { key, chosen, movement } of this.clips) {
      const clip = this.#clips.all.find((clip) => clip.key === key);
      if (chosen && clip) groups.set(movement, [...(groups.get(movement) ?? []), clip]);
    }
    return [...groups].map(([name, clips]) => ({ name, clips }));
  }
}
