// The clips that a rollout can start with: the model infers the latents of their first frames.
import type { ClipEntry, ClipsStore } from "../clips/clips-store";
import type { EngineStore } from "../engine/engine-store";
import { Latest } from "../engine/latest";
import type { ModelView } from "../engine/protocol";
import type { WholeWorkers } from "../engine/whole-workers";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { lab, withLab } from "../words/lab";
import type { ModelStore } from "./model-store";

/** Seconds of a clip from which its latents are inferred. */
const OBSERVED = 0.5;

interface Asked {
  model: ModelView;
  clip: ClipEntry;
}

export class ClipStartStore extends Store {
  readonly #clips: ClipsStore;
  readonly #asked: Latest<Asked, number[][][]>;
  /** The key of the clip that the visitor has chosen last, until its start is there. */
  #awaited: string | null = null;

  constructor(
    private readonly engine: EngineStore,
    private readonly model: ModelStore,
    clips: ClipsStore,
    notices: NoticesStore,
    private readonly workers: Pick<WholeWorkers, "desk">,
  ) {
    super();
    this.#clips = clips;
    this.#asked = new Latest(
      (asked) => this.#infer(asked),
      (latents, asked) => this.#take(latents, asked),
      (problem) => {
        this.#await(null);
        withLab(({ couplings }) => notices.addError(couplings.startFailed, messageOf(problem)));
      },
    );
    clips.on(() => this.changed());
  }

  /** The clips of the model's body that it was not trained on. */
  get clips(): readonly Pick<ClipEntry, "key" | "title">[] {
    const info = this.model.model?.info;
    if (!info) return [];
    const trainedOn = info.sequences.map(({ sha256 }) => sha256);
    const clips = this.#clips
      .ofBody(info.joints)
      .filter(({ loaded }) => !trainedOn.includes(loaded.info.sha256));
    const { clipStart } = this.model;
    // A clip that was removed from the list can still be the start.
    return clipStart && !clips.some(({ key }) => key === clipStart.key) ? [...clips, clipStart] : clips;
  }

  /** The key of the clip that begins the rollouts, or will soon; null: a training sequence does. */
  get clip(): string | null {
    return this.#awaited ?? this.model.clipStart?.key ?? null;
  }

  /** Whether the start of a clip is being inferred. */
  get isBusy(): boolean {
    return this.#awaited !== null;
  }

  /** The seconds of the clip that are observed. */
  get observed(): number {
    const { info } = this.model.model ?? {};
    return info ? framesOf(info) * info.frameTime : OBSERVED;
  }

  chooseClip(key: string): void {
    const { model } = this.model;
    const clip = this.#clips.all.find((clip) => clip.key === key);
    if (!model || !clip) return;
    this.#await(key);
    this.#asked.request({ model, clip });
  }

  chooseSequence(sequence: number): void {
    this.#asked.drop();
    this.#await(null);
    this.model.setStart(sequence);
  }

  #await(key: string | null): void {
    this.#awaited = key;
    this.changed();
  }

  async #infer({ model: { info }, clip }: Asked): Promise<number[][][]> {
    const { engine } = this.engine;
    if (!engine) throw new Error(lab().learn.training.whyNot.cannotRun);
    const text = await engine.modelJson();
    const { source, first, end, loaded } = clip;
    const piece = { id: loaded.id, source, first, end };
    return this.workers.desk.run((worker) => worker.inferStart(text, piece, framesOf(info)));
  }

  #take(latents: number[][][], { model, clip: { key, title } }: Asked): void {
    this.#await(null);
    // Another model may have been opened meanwhile.
    if (model.revision === this.model.model?.revision) this.model.startWith({ key, title, latents });
  }
}

/** The frames from which a start is inferred, at the frame rate of the model. */
function framesOf({ order, frameTime }: ModelView["info"]): number {
  return Math.max(order, Math.round(OBSERVED / frameTime));
}
