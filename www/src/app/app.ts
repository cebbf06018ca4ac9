// Makes all stores of the page and connects them.
import { ClipsStore } from "../clips/clips-store";
import { BodyStore } from "../couplings/body-store";
import { ClipStartStore } from "../couplings/clip-start-store";
import { ModelStore } from "../couplings/model-store";
import { PhasesStore } from "../couplings/phases-store";
import { ReadingsStore } from "../couplings/readings-store";
import type { StartedEngine } from "../engine/engine";
import { EngineStore } from "../engine/engine-store";
import type { SupervisedEvents } from "../engine/supervised";
import type { WholeWorkers } from "../engine/whole-workers";
import { OfflineStore } from "../offline/offline-store";
import { PointingStore } from "../latents/pointing-store";
import { LayersStore } from "../latents/layers-store";
import { PredictionsStore } from "../latents/predictions-store";
import type { AnswerCounts } from "../perception/answer-database";
import type { AddressBar } from "../settings/address";
import { type Settings, writeSettings } from "../settings/settings";
import { IN_LAB, SettingsStore } from "../settings/settings-store";
import type { ViewName, ViewStores } from "../settings/views";
import { Playback } from "../stage/playback";
import { momentOf, takeMoment } from "../stage/moment";
import { StageStore } from "../stage/stage-store";
import { TrainingStore } from "../training/training-store";
import { NoticesStore } from "../ui/notices-store";
import { stageWork } from "../couplings/model-work";
import { mayLose } from "../unsaved/unsaved";
import { WordsStore } from "../words/words";
import { Lazy } from "../ui/lazy";
import { OTHER_MODEL } from "../couplings/model-document";
import { lab } from "../words/lab";
import { loadCompleting, loadPerforming, loadSession } from "../words/sections";
import { StoryBody } from "./story-body";
import { Store } from "../ui/store";

/** Something that is on or off. */
class Switch extends Store {
  #isOn = false;

  get isOn(): boolean {
    return this.#isOn;
  }

  turn(on: boolean): void {
    if (on === this.#isOn) return;
    this.#isOn = on;
    this.changed();
  }
}

/** Opens the models of links. */
const linked = () => import("./linked-model");

export class App {
  /** Whether the chapters are shown as slides of a lecture. */
  readonly lecture = new Switch();
  readonly words = new WordsStore();
  /** The stores of the story. */
  readonly story: StoryBody;
  readonly notices = new NoticesStore();
  readonly engine = new EngineStore();
  readonly offline = new OfflineStore(() => location.reload());
  readonly settings: SettingsStore;
  readonly playback: Playback;
  readonly stage: StageStore;
  readonly clips: ClipsStore;
  readonly model: ModelStore;
  readonly body: BodyStore;
  readonly phases: PhasesStore;
  readonly readings: ReadingsStore;
  readonly pointing: PointingStore;
  readonly predictions: PredictionsStore;
  readonly layers = new LayersStore(() => this.#openOutlook());
  readonly starts: ClipStartStore;
  readonly training: TrainingStore;

  readonly #views = new Map<ViewName, Lazy<unknown>>();

  readonly live = new Lazy(async () => {
    const { modelLive } = await import("../live/model-live");
    return modelLive(this);
  });

  /** The recordings that can give a part of the model, with their words. */
  readonly recordings = new Lazy(async () => {
    const [{ Recordings }] = await Promise.all([
      import("../completing/recordings"),
      loadCompleting(this.words),
    ]);
    return new Recordings(this.engine, this.model, this.clips, this.workers);
  });

  /** Recordings that move parts of the live motion. */
  readonly recordedParts = new Lazy(async () => {
    const [recordings, live, { RecordedParts }] = await Promise.all([
      this.recordings.get(),
      this.live.get(),
      import("../live/recorded-parts"),
    ]);
    return new RecordedParts(recordings, live, this.notices);
  });

  /** Recordings of what the visitor does live, with their view. */
  readonly performed = new Lazy(async () => {
    const [live, { Performance }] = await Promise.all([
      this.live.get(),
      import("../live/performance"),
      loadPerforming(this.words),
      import("../live/perform-view"),
    ]);
    return new Performance(live, this);
  });

  /** A recording that moves one part, with its view. */
  readonly completing = new Lazy(async () => {
    const [recordings, { CompletingStore }] = await Promise.all([
      this.recordings.get(),
      import("../completing/completing-store"),
      import("../completing/completing-view"),
    ]);
    return new CompletingStore(recordings, this.model, this.stage, this.notices);
  });

  /** Stores this visit in the browser from now on. */
  readonly session = new Lazy(async () => {
    const [{ openSession }, { visitOf }] = await Promise.all([
      import("../session/session"),
      import("./holdings"),
      loadSession(this.words),
    ]);
    const session = await openSession(visitOf(this));
    for (const store of [this.clips, this.training, this.model]) store.on(this.touched);
    return session;
  });

  readonly touched = () => this.session.loaded?.touched();

  /** Movements of recorded people, with their view. */
  readonly recorded = new Lazy(async () => {
    const [{ recorded }] = await Promise.all([
      this.view("primitives").get(),
      import("../primitives/recorded-view"),
    ]);
    return recorded;
  });

  readonly #answers = new Lazy(async () => (await import("../perception/answer-database")).answerDatabase());

  /** Stores this visit if the browser can, and loads the page again. */
  async reload(): Promise<void> {
    await this.session.get().then(
      (session) => session.keepNow(),
      () => {},
    );
    location.reload();
  }

  /** Shows the study of this text. `made`: it was made here and is on no disk. */
  async openStudy(text: string, made = false): Promise<void> {
    this.settings.change({ view: "perception" });
    const { perception } = await this.view("perception").get();
    await perception.openStudy(async () => text, made);
  }

  async countAnswers(): Promise<AnswerCounts> {
    return (await this.#answers.get()).countForgettable();
  }

  /** Removes the stored answers of all participants but one who answers now. The result brings them back. */
  async forgetAnswers(): Promise<() => Promise<void>> {
    const restore = await (await this.#answers.get()).forgetAll();
    const listAgain = this.view("perception").loaded?.perception.dropStored();
    return async () => {
      await restore();
      listAgain?.();
      // The view of the test may have been opened since.
      await this.view("perception").loaded?.perception.loadStored();
    };
  }

  readonly #outlook = new Lazy(async () => {
    const { OutlookStore, behindPath } = await import("../latents/outlook");
    const store = new OutlookStore(this.engine, this.model, this.stage, this.notices, this.workers);
    return { store, behindPath };
  });

  constructor(
    address: AddressBar,
    /** Whether the page is in a frame of another page: without header and footer. */
    readonly embedded: boolean,
    readonly workers: WholeWorkers,
  ) {
    this.settings = new SettingsStore(address);
    this.story = new StoryBody(workers);
    this.playback = new Playback(this.settings);
    this.stage = new StageStore(this.playback);
    this.clips = new ClipsStore(this.engine, this.settings, this.stage);
    this.model = new ModelStore(this.engine, this.settings, this.stage, this.notices);
    let laps = 0;
    this.playback.on(() => {
      if (this.playback.laps === laps) return;
      laps = this.playback.laps;
      this.model.nextSample();
    });
    this.body = new BodyStore(this.engine, this.model);
    this.phases = new PhasesStore(this.model, this.body, this.stage, this.playback);
    this.readings = new ReadingsStore(this.engine, this.model, this.stage);
    this.pointing = new PointingStore(this.engine, this.model, this.stage);
    this.predictions = new PredictionsStore(this.engine, this.model);
    this.starts = new ClipStartStore(this.engine, this.model, this.clips, this.notices, workers);
    const mayTakeStage = () => mayLose(stageWork(this.model, this.engine));
    this.training = new TrainingStore(
      this.engine,
      this.settings,
      this.clips,
      this.model,
      this.notices,
      mayTakeStage,
    );
  }

  /** The stores of a view, made at the first use. */
  view<Name extends ViewName>(name: Name): Lazy<ViewStores[Name]> {
    const made =
      this.#views.get(name) ??
      new Lazy(async () => {
        const { ALL_VIEWS } = await import("../views/all-views");
        return ALL_VIEWS.find((view) => view.name === name)?.stores(this);
      });
    this.#views.set(name, made);
    return made as Lazy<ViewStores[Name]>;
  }

  /** Whether a chapter of the story is open. */
  get isStory(): boolean {
    return this.settings.values.chapter > 0;
  }

  /** Whether the page for teachers is open. */
  get isTeaching(): boolean {
    return this.settings.values.teach;
  }

  /** Whether the Lab or one of its views is open. */
  get isLab(): boolean {
    return !this.isStory && !this.isTeaching;
  }

  /** Whether the Lab is visible, with the stage. */
  get isPlayView(): boolean {
    return this.isLab && this.settings.values.view === "play";
  }

  /**
   * Starts the engine and opens the first model, or that of the address, then the sample clips. `firstModel`:
   * null without a model.
   */
  async start(
    startEngine: (events: SupervisedEvents) => Promise<StartedEngine>,
    firstModel: () => Promise<string | null>,
  ): Promise<void> {
    const text = this.settings.bringsModel ? null : firstModel();
    // When the engine cannot start, nobody waits for the model.
    text?.catch(() => {});
    const events: SupervisedEvents = {
      restarted: (why) => this.notices.addError(lab().files.startedAgain, lab().files.startedAgainWhy(why)),
      stopped: (problem) => this.engine.stop(problem),
    };
    const started = () => startEngine(events);
    await this.engine.start(started, async () => {
      // The visitor may have followed a link since.
      if (!this.settings.bringsModel || !(await (await linked()).openFirst(this))) {
        const first = await (text ?? firstModel());
        if (first !== null) await this.model.openStart(first);
      }
      this.takeMoment();
    });
    if (this.engine.state !== "ready") return;
    try {
      await this.clips.loadSamples();
    } catch (problem) {
      this.engine.fail(problem);
    }
  }

  /**
   * Futures and uncertainty of the rollout with their drawing; null, with a notice: they cannot be loaded.
   */
  #openOutlook() {
    return this.#outlook.get().catch(() => {
      const { outlook, why } = lab().files.notLoaded;
      this.notices.addError(outlook, why);
      return null;
    });
  }

  /** The visitor has followed a link or pressed Back. */
  followAddress(): void {
    const isNewest = this.model.want();
    if (this.engine.engine !== null && this.settings.bringsOtherModel()) {
      const fragment = this.settings.address.read();
      linked()
        .then(({ follow }) => follow(this, fragment, isNewest))
        .catch(() => this.notices.addError("Link", this.words.now.frame.notLoaded));
      return;
    }
    this.settings.readAddress();
    if (!this.isLab) return;
    this.model.restart(this.#showsOtherModel && this.settings.bringsModel);
    this.takeMoment();
  }

  /** The fragment of an address with this state of the Lab; only the name of its model is in it. */
  get stateFragment(): string {
    return this.#fragment({ ...this.settings.written, packedModel: "" });
  }

  /** The fragment of an address that brings the model on the stage, in itself or in a file of the host. */
  fragmentWith(brings: Partial<Pick<Settings, "modelFile" | "packedModel">>): string {
    const none: Partial<Settings> = { model: "", modelFile: "", packedModel: "" };
    // Couplings and start are those of the model behind.
    const behind: Partial<Settings> = { alpha: {}, start: 0, startFrame: 0 };
    const other = this.#showsOtherModel ? behind : {};
    return this.#fragment({ ...this.settings.values, ...none, ...other, ...brings });
  }

  /** Whether the model on the stage is one without couplings. */
  get #showsOtherModel(): boolean {
    return this.stage.clip === OTHER_MODEL;
  }

  #fragment(settings: Settings): string {
    const { stage, playback, model } = this;
    const motion = this.#showsOtherModel ? null : (model.rollout?.motion ?? null);
    const moment = this.isPlayView ? momentOf(stage, playback, motion) : {};
    return writeSettings({ ...settings, ...IN_LAB, ...moment });
  }

  /** Takes camera and time of a link. */
  takeMoment(): void {
    if (this.isLab) takeMoment(this.settings, this.stage, this.playback);
  }
}
