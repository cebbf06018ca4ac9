// The content of the stage: the motion of the model or a clip in front of it, and a ghost, sampled futures or
// marked poses.
import type { Figure, Motion, PartSpec } from "../engine/protocol";
import { Store } from "../ui/store";
import type { LiveTrack } from "../scene/live-track";
import type { Playback } from "./playback";

/** A model of another view for the stage: the detail of the event stage-model. */
export interface StagedModel {
  /** The document of the model. */
  text: Promise<string>;
  /** The name of its file, without an ending. */
  name: string;
  /** Whether it was made here and is on no disk. */
  made: boolean;
}

/** A motion on the stage. */
export interface StageContent {
  /**
   * "first": the stored first seconds; "model": a rollout; "clip": a recording; "completed": a recording whose
   * other parts the model has inferred.
   */
  kind: "first" | "model" | "clip" | "completed";
  figure: Figure;
  /** Names, in the order of the skeleton. */
  joints: string[];
  parts: PartSpec[];
  motion: Motion;
  /** The key of a clip. */
  clip?: string;
  /** Whether frames of the model's motion go on arriving. */
  live?: boolean;
  /** A motion that is drawn as an outline with this one. */
  ghost?: Motion;
  /** The text over the figure. */
  caption?: { title: string; text: string };
  /** What changes the motion, under the stage of the Lab. */
  controls?: HTMLElement;
}

/** The poses of an inducing point, and its weights. */
export interface Marks {
  poses: { part: number; opacity: number; positions: Float32Array }[];
  /** The part of the point, and its weight in each frame, 0 to 1 [frames]. */
  part: number;
  frames: Float64Array;
}

/** How strongly a part of the figure is drawn, 0 to 1. */
export interface Fade {
  part: number;
  opacity: number;
}

/** One of several motions of the model's body side by side. */
export interface StageColumn {
  title: string;
  motion: Motion;
}

export class StageStore extends Store {
  /** The clip in front of the model. */
  #clip: StageContent | null = null;
  #model: StageContent | null = null;
  /** The live motion in front of the model's motion. */
  #live: StageContent | null = null;
  #track: LiveTrack | null = null;
  /** The recording that moves a part of the live motion. */
  #recording: Motion | null = null;
  /** The completed recording in front of the model's motion. */
  #completed: StageContent | null = null;
  #ghost: Motion | null = null;
  #marks: Marks | null = null;
  #columns: readonly StageColumn[] | null = null;
  #futures: readonly Motion[] = [];
  #fade: Fade | null = null;

  #look: readonly number[] | null = null;
  /** From where the camera looks (`Framing.look`); null while no stage draws. The stage that draws sets it. */
  camera: () => readonly number[] | null = () => null;

  /** Turns the camera of the stage that draws, or of the next one. */
  lookFrom(look: readonly number[]): void {
    this.#look = look;
    this.changed();
  }

  /** The wanted look of the camera, once; null: none. */
  takeLook(): readonly number[] | null {
    const look = this.#look;
    this.#look = null;
    return look;
  }

  constructor(private readonly playback: Playback) {
    super();
  }

  get content(): StageContent | null {
    return this.#clip ?? this.#live ?? this.#completed ?? this.#model;
  }

  /** The key of the visible clip; null if the model is visible. */
  get clip(): string | null {
    return this.#clip?.clip ?? null;
  }

  /** The visible live motion; null without one. */
  get live(): LiveTrack | null {
    return this.content?.live ? this.#track : null;
  }

  /** The outline with the figure: the motion as learned under other couplings, or the recording. */
  get ghost(): Motion | null {
    const { content } = this;
    if (content?.live) return this.#recording;
    if (content?.ghost) return content.ghost;
    return content?.kind === "model" ? this.#ghost : null;
  }

  /** The frame of the outline now; null while it has none. */
  get ghostFrame(): number | null {
    const { live } = this;
    const { frame } = this.playback;
    return live ? live.recordedAt(frame) : frame;
  }

  get marks(): Marks | null {
    return this.#marks;
  }

  /**
   * Motions side by side instead of the model's; null: one figure. A clip, a live motion or marks hide them.
   */
  get columns(): readonly StageColumn[] | null {
    return this.#clip || this.#live || this.#completed || this.#marks ? null : this.#columns;
  }

  /** Other motions that the model could make, drawn faintly with its own. */
  get futures(): readonly Motion[] {
    return this.#futures;
  }

  /** Shows a motion of the model, behind the clip if there is one, from the place of the motion before. */
  showModel(content: StageContent): void {
    const before = this.#model;
    this.#model = content;
    if (this.content === content) this.#play(content, before !== null);
    this.changed();
  }

  /** Shows a live motion in front of the model's motion. */
  showLive(track: LiveTrack): void {
    if (!this.#model) return;
    this.#clip = null;
    this.#track = track;
    this.#live = { ...this.#model, motion: track.motion, live: true };
    this.playback.follow(track);
    this.changed();
  }

  /** Removes the live motion. The model's motion plays from the place of the figure. */
  endLive(): void {
    if (!this.#live) return;
    this.#live = null;
    this.#recording = null;
    if (!this.#clip && this.content) this.#play(this.content, true);
    this.changed();
  }

  /** The recording that moves a part of the live motion, as an outline; null: none. */
  setRecording(recording: Motion | null): void {
    if (recording === this.#recording) return;
    this.#recording = recording;
    this.changed();
  }

  /** Shows a completed recording in front of the model's motion, and ends a clip; null: the model again. */
  showCompleted(content: StageContent | null): void {
    const before = this.#completed;
    if (content === before) return;
    this.#completed = content;
    if (content) this.#clip = null;
    const { content: now } = this;
    if (now && !now.live) this.#play(now, before !== null && content !== null);
    this.changed();
  }

  /** Shows a clip in front of the model. The same clip goes on, with other frames or parts. */
  showClip(content: StageContent): void {
    const before = this.#clip;
    this.#clip = content;
    this.#play(content, before?.clip === content.clip);
    this.changed();
  }

  /** Removes the clip in front of the model. */
  endClip(): void {
    if (!this.#clip || !this.#model) return;
    this.#clip = null;
    if (this.content) this.#play(this.content, false);
    this.changed();
  }

  setGhost(ghost: Motion | null): void {
    if (ghost === this.#ghost) return;
    this.#ghost = ghost;
    this.changed();
  }

  setColumns(columns: readonly StageColumn[] | null): void {
    if (columns === this.#columns) return;
    this.#columns = columns;
    this.changed();
  }

  setFutures(futures: readonly Motion[]): void {
    this.#futures = futures;
    this.changed();
  }

  /** The part of the figure that is drawn faintly; null: none. */
  get fade(): Fade | null {
    return this.#fade;
  }

  setFade(fade: Fade | null): void {
    this.#fade = fade;
    this.changed();
  }

  mark(marks: Marks | null): void {
    if (marks === this.#marks) return;
    this.#marks = marks;
    this.changed();
  }

  #play(content: StageContent, goesOn: boolean): void {
    this.playback.load(content.motion, {
      whole: content.kind === "clip" || content.kind === "completed",
      goesOn,
    });
  }
}
