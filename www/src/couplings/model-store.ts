// The model on the stage, and its two rollouts: as learned, and under the couplings now.
import type { EngineStore } from "../engine/engine-store";
import { Latest } from "../engine/latest";
import type {
  Engine,
  ModelInfo,
  ModelView,
  OpenedModel,
  RolloutRequest,
  RolloutResult,
} from "../engine/protocol";
import type { Settings } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import type { StageStore } from "../stage/stage-store";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { Store } from "../ui/store";
import { type CouplingsChange, CouplingsStore } from "./couplings-store";
import { couplingsOf, isPreset, type Preset, presetsOf, START_PRESETS } from "./presets";
import { sameTimes } from "./weights";
import { withLab } from "../words/lab";

type Link = Pick<Settings, "model" | "alpha" | "start" | "startFrame">;

class AwaitedLink {
  #link: Link | null = null;

  constructor(private readonly settings: SettingsStore) {}

  /** The first digits of the hash of the model that the link names; null without a link. */
  get model(): string | null {
    return this.#link?.model ?? null;
  }

  /** The address keeps the link, so that it is still there after a reload. */
  wait(link: Link): void {
    this.#link = link;
    this.settings.holdBack(link);
  }

  forget(): void {
    if (!this.#link) return;
    this.#link = null;
    this.settings.holdBack({});
  }

  /** The couplings and the start of the link, if it names this model. The link then waits no longer. */
  takeFor(model: string): Omit<Link, "model"> | null {
    const link = this.#link;
    if (link?.model !== model) return null;
    this.forget();
    const { alpha, start, startFrame } = link;
    return { alpha, start, startFrame };
  }
}

/** A measure in the browser's performance timeline: from the change of a coupling to the new motion. */
export const REDRAW_MEASURE = "coupling-redraw";

/** Digits of a model's hash in a link: enough to distinguish the models of a class of students. */
const ID_DIGITS = 8;

/** What another model keeps of the model before. */
export interface Keep {
  /**
   * "visitor": the couplings that the visitor has set, if they fit the model; "link": the couplings of the
   * address, if they belong to the model.
   */
  couplings: "none" | "visitor" | "link";
  /** Whether a clip stays in front of the model. */
  clip: boolean;
}

/** A clip whose first frames begin the rollouts, with the latents that the model infers in them. */
export interface ClipStart {
  /** The key of the clip in the list of clips. */
  key: string;
  title: string;
  /** `[part][frame][dimension]` */
  latents: number[][][];
}

const KEEP_NOTHING: Keep = { couplings: "none", clip: false };

export class ModelStore extends Store {
  readonly couplings: CouplingsStore;
  readonly link: AwaitedLink;
  #model: ModelView | null = null;
  /** The hash of the model that the page opens with. */
  #startModel: string | null = null;
  #text = "";
  /** Grows with each model, or address, that the visitor asks for. */
  #wanted = 0;
  /** Whether the model was made here and is in no list of trainings. */
  #madeHere = false;
  /** The hashes of the models that the visitor has saved. */
  readonly #saved = new Set<string>();
  #learned: RolloutResult | null = null;
  #rollout: RolloutResult | null = null;
  #clipStart: ClipStart | null = null;
  /** The seed of the sampled rollout that plays, or would. */
  #seed = 1;
  /** The time when the visitor changed a coupling; null once its rollout has arrived. */
  #changedAt: number | null = null;
  readonly #rollouts: Latest<RolloutRequest, RolloutResult>;
  readonly #learnedRollouts: Latest<RolloutRequest, RolloutResult>;

  constructor(
    private readonly engine: EngineStore,
    private readonly settings: SettingsStore,
    private readonly stage: StageStore,
    private readonly notices: NoticesStore,
  ) {
    super();
    this.link = new AwaitedLink(settings);
    this.couplings = new CouplingsStore((change) => this.#couplingsChanged(change), {
      get values() {
        return settings.values;
      },
      change: (change) => this.#change(change),
    });
    const queue = (done: (result: RolloutResult) => void) =>
      new Latest(
        (request: RolloutRequest) => this.#running().rollout(request),
        (result) => {
          // The worker may have opened another model whose answer has not arrived.
          if (result.revision === this.#model?.revision) done(result);
        },
        (problem) => withLab(({ files }) => this.notices.addError(files.rolloutFailed, messageOf(problem))),
      );
    this.#rollouts = queue((result) => this.#takeRollout(result));
    this.#learnedRollouts = queue((result) => this.#takeLearned(result));
  }

  get model(): ModelView | null {
    return this.#model;
  }

  /** The rollout as learned. */
  get learned(): RolloutResult | null {
    return this.#learned;
  }

  /** The rollout under the couplings now. */
  get rollout(): RolloutResult | null {
    return this.#rollout;
  }

  /** The name of the model in a link: the first digits of its document's hash. Empty without a model. */
  get id(): string {
    return this.#model?.sha256.slice(0, ID_DIGITS) ?? "";
  }

  /** The document of the model; null for the model that the page opens with. */
  get openedText(): string | null {
    return this.#model === null || this.#model.sha256 === this.#startModel ? null : this.#text;
  }

  /** Whether the model would be lost if another one replaced it. */
  get unsaved(): boolean {
    return this.#madeHere && this.#model !== null && !this.#saved.has(this.#model.sha256);
  }

  /**
   * The visitor asks for another model or address. The result tells whether this is still the newest wish, so
   * that a slow answer does not replace what the visitor opened since.
   */
  want(): () => boolean {
    this.#wanted += 1;
    const wish = this.#wanted;
    return () => wish === this.#wanted;
  }

  /** The model was made here, and is in no list of trainings. */
  markMadeHere(): void {
    this.#madeHere = true;
    this.changed();
  }

  /** The model was saved to the visitor's disk. */
  markSaved(): void {
    if (this.#model) this.#saved.add(this.#model.sha256);
  }

  /** The presets of the model. */
  get presets(): readonly Preset[] {
    const model = this.#model;
    if (!model) return [];
    return model.sha256 === this.#startModel
      ? START_PRESETS
      : presetsOf(model.info.parts.map(({ name }) => name));
  }

  /** The preset that matches the couplings now. */
  get preset(): Preset | null {
    const info = this.#model?.info;
    return (info && this.presets.find((preset) => isPreset(preset, info, this.settings.values))) ?? null;
  }

  /** The clip that begins the rollouts; null: a training sequence does. */
  get clipStart(): ClipStart | null {
    return this.#clipStart;
  }

  /** The request for the rollout on the stage. */
  rolloutRequest(): RolloutRequest {
    const { reading, samples } = this.settings.values;
    const begins = { ...this.#beginning(), ...(samples && { sample: this.#seed }) };
    const { alpha, altered } = this.couplings;
    return altered ? { ...begins, alpha, reading } : { ...begins, alpha: null, reading: "as-learned" };
  }

  /** Plays sampled rollouts, another one in each loop, or the mean. */
  playSamples(samples: boolean): void {
    this.settings.change({ samples });
    this.#rollOutBoth();
  }

  /** A loop of the stage has ended: the next sample plays. */
  nextSample(): void {
    const { content } = this.stage;
    if (!this.settings.values.samples || content?.kind !== "model" || content.live) return;
    this.#seed += 1;
    this.#rollOut();
  }

  /**
   * Opens a model from its JSON document. `trainingLatents`: the latents of its training frames, if known.
   */
  async open(
    text: string,
    keep = KEEP_NOTHING,
    trainingLatents: Float64Array[] | null = null,
  ): Promise<void> {
    this.want();
    const opened = await this.#running().openModel(text, this.settings.values.frames);
    if (this.settings.bringsModel) this.settings.change({ modelFile: "", packedModel: "" });
    this.#text = text;
    this.#madeHere = false;
    this.#takeUp({ ...opened, model: { ...opened.model, trainingLatents } }, keep);
  }

  /**
   * Opens the model of a link. `take` takes the settings of the link, once the document has proved to be a
   * model.
   */
  async openLinked(text: string, take: () => void): Promise<void> {
    const opened = await this.#running().openModel(text, this.settings.values.frames);
    take();
    this.#text = text;
    this.#madeHere = false;
    this.#takeUp(opened, { couplings: "link", clip: false });
  }

  /** Opens the model that comes with the page, under the couplings of the address. */
  async openStart(text: string): Promise<void> {
    await this.open(text, { couplings: "link", clip: false });
    this.#startModel = this.#model?.sha256 ?? null;
    this.changed();
  }

  /**
   * Takes the couplings and the start from the address, after the address has changed. `clip`: whether the motion
   * in front of the model stays.
   */
  restart(clip = false): void {
    if (!this.#model || !this.#learned) return;
    this.#takeUp({ model: this.#model, rollout: this.#learned }, { couplings: "link", clip });
  }

  takePreset(preset: Preset): void {
    const alpha = this.#model && couplingsOf(preset, this.#model.info);
    if (!alpha) return;
    this.link.forget();
    this.stage.endClip();
    this.couplings.takeAll(alpha, preset.reading);
  }

  /** The number of frames of a training sequence whose latents the file has: rollouts can start there. */
  startFrames(sequence: number): number {
    return this.#model?.info.startFrames[sequence] ?? 1;
  }

  /** Starts the rollouts with the first frames of a clip. The address does not keep this start. */
  startWith(clip: ClipStart): void {
    this.#clipStart = clip;
    this.#change({ start: 0, startFrame: 0 });
    this.#rollOutBoth();
  }

  /** Starts the rollouts from a frame of a training sequence; the ghost starts there too. */
  setStart(start: number, startFrame = 0): void {
    this.#clipStart = null;
    this.#change({ start, startFrame });
    this.#rollOutBoth();
  }

  /** Sets the length of the rollouts, within its limits. */
  setSeconds(seconds: number): void {
    if (!this.#model) return;
    this.#change({ frames: Math.round(seconds / this.#model.info.frameTime) });
    this.#rollOutBoth();
  }

  /** Forgets the couplings of a link that belong to another model. */
  forgetLink(): void {
    this.link.forget();
    this.changed();
  }

  #running(): Engine {
    const { engine } = this.engine;
    if (!engine) throw new Error("The model cannot run in this browser.");
    return engine;
  }

  /** Changes settings. An address with couplings or a start also names their model. */
  #change(change: Partial<Settings>, turnsPage = false): void {
    const { alpha, start, startFrame } = { ...this.settings.values, ...change };
    const aboutModel = start + startFrame > 0 || Object.keys(alpha).length > 0;
    this.settings.change({ ...change, model: aboutModel ? this.id : "" }, turnsPage);
  }

  /** The length of the rollouts, and what begins them. */
  #beginning(): Omit<RolloutRequest, "alpha" | "reading"> {
    const { frames, start, startFrame } = this.settings.values;
    if (this.#clipStart) return { frames, sequence: 0, start: this.#clipStart.latents };
    const sequences = this.#model?.info.sequences.length ?? 1;
    const sequence = Math.min(start, Math.max(0, sequences - 1));
    const frame = Math.min(startFrame, this.startFrames(sequence) - 1);
    return frame > 0 ? { frames, sequence, frame } : { frames, sequence };
  }

  #couplingsChanged(change: CouplingsChange): void {
    if (change === "set") {
      this.#changedAt = performance.now();
      this.link.forget();
      this.stage.endClip();
    }
    this.#rollOut();
  }

  /** Asks for the rollout as learned, and then for the one under the couplings now. */
  #rollOutBoth(): void {
    if (this.#model)
      this.#learnedRollouts.request({ ...this.#beginning(), alpha: null, reading: "as-learned" });
    this.changed();
  }

  /** Asks for the rollout under the settings now. */
  #rollOut(): void {
    if (this.#model) this.#rollouts.request(this.rolloutRequest());
    this.#showGhost();
    this.changed();
  }

  #takeRollout(rollout: RolloutResult): void {
    this.#rollout = rollout;
    if (!rollout.request.alpha && rollout.request.sample === undefined) this.#learned = rollout;
    this.#show();
    this.changed();
    if (this.#changedAt === null) return;
    performance.measure(REDRAW_MEASURE, { start: this.#changedAt });
    this.#changedAt = null;
  }

  #takeLearned(rollout: RolloutResult): void {
    if (!this.couplings.altered && !this.settings.values.samples) {
      this.#takeRollout(rollout);
      return;
    }
    this.#learned = rollout;
    this.#rollOut();
  }

  #takeUp({ model, rollout }: OpenedModel, keep: Keep): void {
    this.#rollouts.drop();
    this.#learnedRollouts.drop();
    this.#model = model;
    this.#clipStart = null;
    this.couplings.setLearned(model.info.alpha);
    this.#learned = rollout;
    this.#rollout = rollout;
    this.#settleCouplings(model, keep);
    // Other stores drop the model before, and then the stage shows the new one.
    this.changed();
    this.#show();
    if (!keep.clip) this.stage.endClip();
    const { request } = rollout;
    const asked = this.rolloutRequest();
    if (this.couplings.altered || asked.sample || !sameTimes(request, asked)) this.#rollOutBoth();
  }

  /** Sets the couplings and the start of the new model. */
  #settleCouplings({ info }: ModelView, keep: Keep): void {
    const { alpha, start, startFrame, model } = this.settings.values;
    const ofOtherModel = keep.couplings === "link" && model !== "" && model !== this.id;
    if (ofOtherModel) this.link.wait({ model, alpha, start, startFrame });
    else if (keep.couplings === "link") this.link.forget();
    // The browser's Back button brings back the couplings of the model before.
    const drops = keep.couplings === "none" || !this.#couplingsFit(info);
    if (ofOtherModel || drops)
      this.#change({ alpha: {} }, keep.couplings !== "link" && this.couplings.altered);
    if (ofOtherModel || start >= info.sequences.length) this.#change({ start: 0, startFrame: 0 });
    this.#change(this.link.takeFor(this.id) ?? {});
  }

  #couplingsFit(info: ModelInfo): boolean {
    const parts = Object.keys(this.settings.values.alpha).flatMap((key) => key.split(".").map(Number));
    return parts.every((part) => part < info.parts.length);
  }

  #show(): void {
    if (!this.#model || !this.#rollout) return;
    const { figure, joints, parts } = this.#model.info;
    const names = joints.map(({ name }) => name);
    this.stage.showModel({ kind: "model", figure, joints: names, parts, motion: this.#rollout.motion });
    this.#showGhost();
  }

  #showGhost(): void {
    this.stage.setGhost(this.couplings.altered ? (this.#learned?.motion ?? null) : null);
  }
}
