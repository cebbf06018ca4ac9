// A recording moves one part of the model's body, and the model infers the others.
import type { ModelStore } from "../couplings/model-store";
import { Latest } from "../engine/latest";
import type { ModelView } from "../engine/protocol";
import type { CompletedClip, CompletionRequest, PartCompletion } from "../engine/whole-protocol";
import type { StageStore } from "../stage/stage-store";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { completingWords } from "../words/sections";
import type { Recording, Recordings } from "./recordings";

interface Asked {
  model: ModelView;
  clip: Recording;
  request: Omit<CompletionRequest, "clip">;
}

export class CompletingStore extends Store {
  readonly #asked: Latest<Asked, CompletedClip>;
  #part = 0;
  #clip = "";
  /** Seconds; null: to the end. */
  #until: number | null = null;
  #shown = false;
  #scores: readonly PartCompletion[] | null = null;
  /** What the worker was last asked for. */
  #last = "";

  constructor(
    private readonly recordings: Recordings,
    private readonly model: ModelStore,
    private readonly stage: StageStore,
    private readonly notices: NoticesStore,
  ) {
    super();
    this.#asked = new Latest(
      ({ model, clip, request }) => recordings.complete(model, clip, request),
      (completed, asked) => this.#take(completed, asked),
      (problem) => {
        this.hide();
        this.notices.addError(completingWords().failed, messageOf(problem));
      },
    );
    recordings.on(() => this.#follow());
  }

  get clips(): readonly Recording[] {
    return this.recordings.all;
  }

  get clip(): Recording | undefined {
    const { clips } = this;
    return clips.find(({ key }) => key === this.#clip) ?? clips[0];
  }

  /** The part that is given, as a place in the list of the model's parts. */
  get part(): number {
    return this.#part < (this.model.model?.info.parts.length ?? 0) ? this.#part : 0;
  }

  /** The time until which the part is observed, in seconds; null: to the end. */
  get until(): number | null {
    return this.#until;
  }

  /** The first and the last time at which the observation can end, in seconds. */
  get times(): readonly [number, number] {
    const { model } = this.model;
    const { clip } = this;
    if (!model || !clip) return [0, 0];
    return [model.info.order * model.info.frameTime, (clip.end - clip.first - 1) * clip.frameTime];
  }

  /** Whether the completed recording is on the stage, or about to be. */
  get shown(): boolean {
    return this.#shown;
  }

  /** The errors of the other parts; null before they have arrived. */
  get scores(): readonly PartCompletion[] | null {
    return this.#scores;
  }

  show(): void {
    this.#shown = true;
    this.#last = "";
    this.#follow();
  }

  hide(): void {
    this.#shown = false;
    this.#scores = null;
    this.#asked.drop();
    this.stage.showCompleted(null);
    this.changed();
  }

  give(part: number): void {
    this.#part = part;
    this.#follow();
  }

  chooseClip(key: string): void {
    [this.#clip, this.#until] = [key, null];
    this.#follow();
  }

  /** Ends the observation at this time; the last time is the end of the clip. */
  observeUntil(seconds: number): void {
    this.#until = seconds < this.times[1] ? seconds : null;
    this.#follow();
  }

  /** Asks for the recording as completed under the couplings now, if that is another one. */
  #follow(): void {
    this.changed();
    const { model } = this.model;
    const { clip } = this;
    if (!this.#shown) return;
    if (!model || !clip || model.info.parts.length < 2) {
      this.hide();
      return;
    }
    const { alpha, reading } = this.model.rolloutRequest();
    const given = model.info.parts[this.part]?.name ?? "";
    const request = { given, until: this.#until, alpha, reading };
    const asked = JSON.stringify([model.revision, clip, request]);
    if (asked === this.#last) return;
    this.#last = asked;
    this.#asked.request({ model, clip, request });
  }

  #take({ motion, recorded, scores }: CompletedClip, { model, clip, request }: Asked): void {
    if (!this.#shown || model.revision !== this.model.model?.revision) return;
    this.#scores = scores;
    const { figure, joints, parts } = model.info;
    this.stage.showCompleted({
      kind: "completed",
      figure,
      joints: joints.map(({ name }) => name),
      parts,
      motion,
      ghost: recorded,
      caption: completingWords().caption(request.given, clip.title),
    });
    this.changed();
  }
}
