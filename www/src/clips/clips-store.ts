// The clips, made by the project or opened by the visitor: which are ticked, cut and on the stage.
import type { EngineStore } from "../engine/engine-store";
import type {
  Clash,
  ClipSource,
  JointInfo,
  LoadedClip,
  PartSpec,
  ShownClip,
  TrainingClip,
  UpAxis,
} from "../engine/protocol";
import type { SettingsStore } from "../settings/settings-store";
import type { StageStore } from "../stage/stage-store";
import { clipTitle, messageOf } from "../ui/format";
import { Store } from "../ui/store";
import { partsFor } from "./parts";
import { lab } from "../words/lab";
import { html, nothing } from "lit";
import "./clips.css";

export const fileNotices = (warnings: readonly string[]) =>
  warnings.length === 0
    ? nothing
    : html`<details class="warnings hint"><summary>${lab().learn.clips.notices(warnings.length)}</summary>
        <ul>${warnings.map((warning) => html`<li>${warning}</li>`)}</ul></details>`;

/** Bytes. A larger file is no motion clip and would fill the memory. */
export const LARGEST_FILE = 200e6;

/** The fewest frames of a cut clip. */
const FEWEST_FRAMES = 10;

export interface ClipEntry {
  key: string;
  title: string;
  /**
   * "made": by this project's program; "model": by a model that learned from recordings; "own":
   * opened by the visitor.
   */
  origin: "made" | "model" | "own";
  source: ClipSource;
  loaded: LoadedClip;
  /** The root joints of the bodies in its file, if it has several. */
  bodies: readonly string[];
  /** Whether it is chosen for training and comparisons. */
  ticked: boolean;
  /** The frames to use: first up to, not including, end. */
  first: number;
  end: number;
}

/** How a clip was made live; empty: it was not. */
export const noteOf = ({ source }: Pick<ClipEntry, "source">): string =>
  ("file" in source && source.note) || "";

/** A clip for a later visit. */
export type StoredClip = Pick<ClipEntry, "key" | "title" | "origin" | "source" | "ticked" | "first" | "end">;

export class ClipsStore extends Store {
  #clips: readonly ClipEntry[] = [];
  #samplesLoaded = false;
  #clash: Clash | null = null;
  #firstBones = false;
  #locked = false;
  #checks = 0;
  #lastId = 0;
  /** The made clips that were unticked when the visitor opened own clips. */
  #steppedBack = new Set<string>();

  constructor(
    private readonly engine: EngineStore,
    private readonly settings: SettingsStore,
    private readonly stage: StageStore,
  ) {
    super();
  }

  get all(): readonly ClipEntry[] {
    return this.#clips;
  }

  /** The clips of a body with these joints. */
  ofBody(joints: readonly JointInfo[]): readonly ClipEntry[] {
    const names = (all: readonly JointInfo[]) => all.map(({ name }) => name).join();
    return this.#clips.filter(({ loaded }) => names(loaded.info.joints) === names(joints));
  }

  get ticked(): readonly ClipEntry[] {
    return this.#clips.filter(({ ticked }) => ticked);
  }

  /** Whether all clips that come with the page are there. */
  get samplesLoaded(): boolean {
    return this.#samplesLoaded;
  }

  /** Why the ticked clips cannot be trained on together; empty when they can. */
  get clash(): string {
    return this.#clash?.words ?? "";
  }

  /** Whether only the bones of the ticked clips differ: all could take those of the first. */
  get bonesClash(): boolean {
    return this.#clash?.bones ?? false;
  }

  /** Whether all ticked clips take the bones of the first of them. */
  get firstBones(): boolean {
    return this.#firstBones;
  }

  async setFirstBones(firstBones: boolean): Promise<void> {
    this.#firstBones = firstBones;
    await this.checkClash();
  }

  /** Whether a training uses the ticked clips, so that they cannot be changed now. */
  get locked(): boolean {
    return this.#locked;
  }

  /** The parts of the settings for the ticked clips' skeleton; empty without a ticked clip. */
  get parts(): PartSpec[] {
    const [clip] = this.ticked;
    return clip ? this.#partsOf(clip) : [];
  }

  /** The ticked clips for a worker that trains, with their titles. */
  get toTrainOn(): (TrainingClip & { title: string })[] {
    return this.ticked.map(({ loaded, title, source, first, end }, place) => ({
      id: loaded.id,
      title,
      source,
      first,
      end,
      ...(this.#firstBones && place > 0 && { firstBones: true }),
    }));
  }

  lock(locked: boolean): void {
    this.#locked = locked;
    this.changed();
  }

  /** Loads the clips that the project makes itself; the plain walks are ticked. */
  async loadSamples(): Promise<void> {
    const { engine, samples } = this.engine;
    if (!engine) return;
    for (const { id, title, movement } of samples) {
      const loaded = this.#numbered(await engine.sampleClip(id));
      const ticked = movement === "walk";
      this.#add({ key: `made-${id}`, title, origin: "made", source: { sample: id }, loaded, ticked });
    }
    this.#samplesLoaded = true;
    this.changed();
  }

  /** Loads the made clips of a movement that a first visit does not bring, ticks them alone, and shows the first. */
  async loadMade(movement: string): Promise<void> {
    const all = (await this.engine.clips?.madeClips()) ?? [];
    const made: Omit<ClipEntry, "bodies" | "first" | "end">[] = [];
    for (const { id, title } of all.filter((clip) => clip.movement === movement)) {
      const source = { sample: id };
      const loaded = await this.#read(source);
      made.push({ key: `made-${id}`, title, origin: "made", source, loaded, ticked: false });
    }
    for (const clip of made) if (!this.#find(clip.key)) this.#add(clip);
    const keys = made.map(({ key }) => key);
    this.#clips = this.#clips.map((clip) => ({ ...clip, ticked: keys.includes(clip.key) }));
    if (keys[0]) this.show(keys[0]);
    await this.checkClash();
  }

  /**
   * Adds a clip that a model made, as BVH, and returns its key. It is not ticked. `performed`: the visitor made it
   * live; the name of its file, and how it was made.
   */
  async addModelled(title: string, bvh: string, performed?: { name: string; note: string }): Promise<string> {
    const source = { name: title, ...performed, file: new Blob([bvh]) };
    const loaded = await this.#read(source);
    const origin = performed ? "own" : "model";
    const key = `${origin}-${loaded.id}`;
    this.#add({ key, title, origin, source, loaded, ticked: false });
    return key;
  }

  /** Opens a clip of the visitor. The first of several goes on the stage. */
  async open(file: File, first: boolean): Promise<void> {
    // A copy of the bytes: the visitor may change the file on disk.
    const source: ClipSource = { name: clipTitle(file.name), file: new Blob([await file.arrayBuffer()]) };
    const loaded = await this.#read(source);
    if (loaded.assumed) source.fps = loaded.assumed.fps;
    // The visitor wants to train on own clips now, so that the made ones are unticked.
    if (first) {
      for (const { key, origin, ticked } of this.#clips)
        if (origin === "made" && ticked) this.#steppedBack.add(key);
      this.#clips = this.#clips.map((clip) => (clip.origin === "made" ? { ...clip, ticked: false } : clip));
    }
    const key = `own-${loaded.id}`;
    this.#add({ key, title: source.name, origin: "own", source, loaded, ticked: true });
    if (first) this.show(key);
  }

  /** All clips for a later visit. */
  get stored(): StoredClip[] {
    return this.#clips.map(({ key, title, origin, source, ticked, first, end }) => ({
      ...{ key, title, origin, source, ticked, first, end },
    }));
  }

  /** Takes up a clip of an earlier visit and returns its id in this one. */
  async takeUp({ key, title, origin, source, ticked, first, end }: StoredClip): Promise<number> {
    const isMade = origin === "made";
    const here = isMade && this.#find(key)?.loaded;
    const loaded = here || (await this.#read(source));
    const now = isMade ? key : `${origin}-${loaded.id}`;
    if (here) this.#update(now, { ticked });
    else this.#add({ key: now, title, origin, source, loaded, ticked });
    if (first !== 0 || end !== loaded.info.frames) this.cut(now, first, end);
    return loaded.id;
  }

  /** Of the clips that come with the page, only those of one body stay ticked. */
  async tick(key: string, ticked: boolean): Promise<void> {
    const clip = this.#find(key);
    if (ticked && clip && clip.origin !== "own") {
      const same = this.ofBody(clip.loaded.info.joints);
      for (const other of this.ticked)
        if (other.origin !== "own" && !same.includes(other)) this.#update(other.key, { ticked: false });
    }
    this.#update(key, { ticked });
    await this.checkClash();
  }

  /** Keeps the frames from first (counted from 0) up to, not including, end; ten at least. */
  cut(key: string, first: number, end: number): void {
    const clip = this.#find(key);
    if (!clip || !Number.isFinite(first) || !Number.isFinite(end)) {
      // The fields show the present values again.
      this.changed();
      return;
    }
    const { frames } = clip.loaded.info;
    const fewest = Math.min(FEWEST_FRAMES, frames);
    const from = Math.min(Math.max(0, Math.round(first)), frames - fewest);
    const to = Math.min(Math.max(from + fewest, Math.round(end)), frames);
    this.#update(key, { first: from, end: to });
    if (this.stage.clip === key) this.show(key);
  }

  /**
   * States the axis that points up in an own clip, its frames a second, or which of several bodies it is; its place
   * in the list stays, and its cut if its length does.
   */
  async state(key: string, stated: { up: UpAxis } | { fps: number } | { root: string }): Promise<void> {
    const clip = this.#find(key);
    if (!clip || !("file" in clip.source)) return;
    if ("fps" in stated && !(stated.fps >= 1 && stated.fps <= 10_000)) {
      // The field shows the present rate again.
      this.changed();
      return;
    }
    const source = { ...clip.source, ...stated };
    // A new number: a worker may still have the clip as it was.
    const loaded = await this.#read(source);
    this.#update(key, { source, loaded });
    if (this.stage.clip === key) this.show(key);
    await this.checkClash();
  }

  /** Plays a clip on the stage as it was recorded. */
  show(key: string): void {
    const clip = this.#find(key);
    if (!clip) return;
    const { info, motion } = clip.loaded;
    const width = motion.nodes * 3;
    this.stage.showClip({
      kind: "clip",
      clip: key,
      figure: info.figure,
      joints: info.joints.map(({ name }) => name),
      parts: this.#partsOf(clip),
      motion: {
        ...motion,
        frames: clip.end - clip.first,
        positions: motion.positions.subarray(clip.first * width, clip.end * width),
      },
    });
  }

  /** Changes the parts to a preset or to `split` by hand. The clip on the stage shows them. */
  setParts(change: { parts?: string; split?: PartSpec[] }): void {
    this.settings.change(change);
    if (this.stage.clip !== null) this.show(this.stage.clip);
    this.changed();
  }

  async remove(key: string): Promise<void> {
    const clip = this.#find(key);
    if (!clip) return;
    this.#clips = this.#clips.filter((other) => other !== clip);
    this.#bringBack();
    if (this.stage.clip === key) this.stage.endClip();
    this.changed();
    await this.checkClash();
  }

  /** Finds out whether the ticked clips can be trained on together. */
  async checkClash(): Promise<void> {
    this.#checks += 1;
    const check = this.#checks;
    const clips = this.toTrainOn;
    let clash: Clash | null = null;
    try {
      if (clips.length > 1) clash = (await this.engine.clips?.checkTogether(clips)) ?? null;
    } catch (problem) {
      clash = { words: messageOf(problem), bones: false };
    }
    // Other clips may have been ticked meanwhile.
    if (check !== this.#checks) return;
    this.#clash = clash;
    this.changed();
  }

  /**
   * When the last own clip is gone and no clip is ticked, ticks the made clips that own clips had unticked.
   */
  #bringBack(): void {
    if (this.#clips.some(({ origin, ticked }) => origin === "own" || ticked)) return;
    this.#clips = this.#clips.map((clip) => ({ ...clip, ticked: this.#steppedBack.has(clip.key) }));
    this.#steppedBack.clear();
  }

  async #read(source: ClipSource): Promise<LoadedClip> {
    const { clips } = this.engine;
    if (!clips) throw new Error(lab().files.gettingReady);
    return this.#numbered(await clips.readClip(source));
  }

  #numbered(clip: ShownClip): LoadedClip {
    this.#lastId += 1;
    return { ...clip, id: this.#lastId };
  }

  #find(key: string): ClipEntry | undefined {
    return this.#clips.find((clip) => clip.key === key);
  }

  #add(clip: Omit<ClipEntry, "bodies" | "first" | "end">): void {
    // The samples come from the program that shows models, and have one body each.
    const { bodies = [], frames } = clip.loaded.info;
    this.#clips = [...this.#clips, { ...clip, bodies, first: 0, end: frames }];
    this.changed();
  }

  #update(key: string, change: Partial<ClipEntry>): void {
    this.#clips = this.#clips.map((clip) => (clip.key === key ? { ...clip, ...change } : clip));
    this.changed();
  }

  #partsOf({ loaded }: ClipEntry): PartSpec[] {
    const { parts, split } = this.settings.values;
    return partsFor(loaded.info, parts, split);
  }
}
