// What the visitor does live, recorded: the frames that the stage showed become a clip.
import type { ClipsStore } from "../clips/clips-store";
import { ModelDocument } from "../couplings/model-document";
import { modelName } from "../couplings/model-file";
import type { ModelStore } from "../couplings/model-store";
import type { EngineStore } from "../engine/engine-store";
import type { WholeWorkers } from "../engine/whole-workers";
import type { LiveTrack } from "../scene/live-track";
import type { SettingsStore } from "../settings/settings-store";
import type { Playback } from "../stage/playback";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { shownPart } from "../words/lab";
import { performingWords } from "../words/sections";
import type { LiveStore, Mark } from "./live-store";

/** A recording ends by itself after these seconds, of which the live motion stores all. */
export const LONGEST = 10;
/** A shorter recording is no clip, in seconds. */
const SHORTEST = 1;

interface Stores {
  engine: EngineStore;
  model: ModelStore;
  clips: ClipsStore;
  playback: Playback;
  notices: NoticesStore;
  workers: WholeWorkers;
  settings: SettingsStore;
  training: { start(): Promise<void> };
}

export class Performance extends Store {
  /** The live motion that is recorded, its first frame, and the last one that the stage has shown. */
  #take: { track: LiveTrack; from: number; to: number } | null = null;
  /** Whether the clip of the last recording is made now. */
  #busy = false;
  /** The newest clip. */
  #clip: { key: string; title: string } | null = null;
  readonly #document: ModelDocument;

  constructor(
    readonly live: LiveStore,
    readonly app: Stores,
  ) {
    super();
    this.#document = new ModelDocument(app.engine, app.workers);
    app.playback.on(() => this.#follow());
    live.on(() => this.#follow());
    app.clips.on(() => this.changed());
  }

  get isRecording(): boolean {
    return this.#take !== null;
  }

  get busy(): boolean {
    return this.#busy;
  }

  /** Whole seconds until the recording ends. */
  get left(): number {
    const { track, from, to } = this.#take ?? {};
    return track ? Math.ceil(LONGEST - (to! - from!) * track.motion.frameTime) : LONGEST;
  }

  /** The newest clip, until it is removed. */
  get clip(): { key: string; title: string } | null {
    return this.app.clips.all.some(({ key }) => key === this.#clip?.key) ? this.#clip : null;
  }

  async start(): Promise<void> {
    await this.live.start();
    const { track } = this.live;
    if (!track || this.#take || this.#busy) return;
    const from = Math.ceil(this.app.playback.frame);
    this.#take = { track, from, to: from };
    this.changed();
  }

  /** The recording ends with its time, and with the live motion. */
  #follow(): void {
    const take = this.#take;
    if (!take) return;
    const before = this.left;
    if (this.live.track === take.track) take.to = Math.max(take.to, Math.floor(this.app.playback.frame));
    if (this.live.track !== take.track || this.left <= 0) void this.stop();
    else if (this.left !== before) this.changed();
  }

  /** Ends the recording and adds its clip to the others. */
  async stop(): Promise<void> {
    const take = this.#take;
    if (!take) return;
    this.#take = null;
    const { track, from } = take;
    const { model, clips, notices } = this.app;
    const to = Math.min(take.to, from + Math.round(LONGEST / track.motion.frameTime));
    const columns = track.columns(from, to);
    const words = performingWords();
    if (!model.model || !columns || (to - from) * track.motion.frameTime < SHORTEST) {
      notices.addError(words.notRecorded, words.tooShort);
      this.changed();
      return;
    }
    const name = modelName({ ...model.model, id: model.id });
    const note = words.note(name, this.#actions(from, to));
    this.#busy = true;
    this.changed();
    try {
      const bvh = await this.#document.ask(model.model.revision, (worker) =>
        worker.columnsBvh(columns, to - from + 1),
      );
      let number = 1;
      while (clips.all.some(({ title }) => title === words.title(number))) number += 1;
      const title = words.title(number);
      const key = await clips.addModelled(title, bvh, { name: `${title}, ${words.live(name)}`, note });
      this.#clip = { key, title };
    } catch (problem) {
      notices.addError(words.notRecorded, messageOf(problem));
    }
    this.#busy = false;
    this.changed();
  }

  /** Trains on the newest clip alone, with the settings of the panel. */
  async train(): Promise<void> {
    const { clips, settings, training } = this.app;
    const { clip } = this;
    if (!clip) return;
    for (const { key } of clips.ticked) await clips.tick(key, false);
    await clips.tick(clip.key, true);
    settings.change({ panel: "learn" });
    await training.start();
  }

  /** Plays the newest clip. */
  show(): void {
    if (this.clip) this.app.clips.show(this.clip.key);
  }

  /** What the visitor did in these frames, each thing once. */
  #actions(from: number, to: number): string[] {
    const { did } = performingWords();
    const part = (place: number) => shownPart(this.live.body?.parts[place]?.name ?? "");
    const isThen = (mark: Mark) =>
      mark.from <= to && (mark.kind === "push" ? mark.from : (mark.to ?? to)) >= from;
    const said = (mark: Mark) => {
      if (mark.kind === "cut") return did.cut(part(mark.source), part(mark.target));
      if (mark.kind === "record") return did.record(part(mark.part), mark.title);
      if (mark.kind === "push") return did.push(part(mark.part));
      return mark.byFeet ? did.feet : did.wheel(part(mark.part));
    };
    const all = this.live.marks.filter(isThen).map(said);
    if (this.app.model.couplings.altered) all.push(did.couplings);
    return [...new Set(all)];
  }
}
