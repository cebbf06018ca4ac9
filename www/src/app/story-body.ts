// The body of the story: the model that comes with the page, with stores and a worker of its own, so that the
// story changes nothing in the Lab, and shows the same walk whatever model the visitor has opened there.
import { fetchStartModel, fetchStartMotion } from "./start-files";
import { Lazy } from "../ui/lazy";
import { BodyStore } from "../couplings/body-store";
import { ModelStore } from "../couplings/model-store";
import { PhasesStore } from "../couplings/phases-store";
import { startEngine } from "../engine/engine";
import { EngineStore } from "../engine/engine-store";
import type { WholeWorkers } from "../engine/whole-workers";
import type { AddressBar } from "../settings/address";
import { SettingsStore } from "../settings/settings-store";
import { Playback } from "../stage/playback";
import { StageStore } from "../stage/stage-store";
import { NoticesStore } from "../ui/notices-store";
import { prefersReducedMotion } from "../ui/browser";
import { withLab } from "../words/lab";

/** The settings of the story's body are in no address. */
export const NO_ADDRESS: AddressBar = { read: () => "", write() {}, push() {} };

export class StoryBody {
  readonly engine = new EngineStore();
  readonly settings = new SettingsStore(NO_ADDRESS);
  readonly playback = new Playback(this.settings);
  readonly stage = new StageStore(this.playback);
  /** Problems of the story, which its frame shows. */
  readonly notices = new NoticesStore();
  readonly model = new ModelStore(this.engine, this.settings, this.stage, this.notices);
  /** Measures of hands and feet. */
  readonly measures = new BodyStore(this.engine, this.model);
  readonly phases = new PhasesStore(this.model, this.measures, this.stage, this.playback);
  readonly live = new Lazy(async () => {
    const { modelLive } = await import("../live/model-live");
    return modelLive(this);
  });
  #started: Promise<void> | null = null;

  constructor(private readonly workers: WholeWorkers) {}

  /** Shows the stored first seconds of the walk. The model continues them when it has arrived. */
  async showFirstMotion(): Promise<void> {
    if (this.stage.content) return;
    const motion = await fetchStartMotion();
    if (motion && !this.stage.content) this.stage.showModel(motion);
  }

  /** Shows the walk, which moves unless the system asks for less motion. The frame says why the model cannot run. */
  open(): void {
    void this.showFirstMotion();
    this.start().catch(() => {});
    if (!prefersReducedMotion()) this.playback.play();
  }

  /** The learned motion, from the place of the figure, without a live motion or changed couplings. */
  reset(): void {
    this.live.loaded?.stop();
    if (this.model.couplings.altered) this.model.couplings.resetAll();
  }

  /** Starts the engine and opens the model; a call after a failure tries again. */
  start(): Promise<void> {
    this.#started ??= this.#start().catch((problem: unknown) => {
      this.#started = null;
      throw problem;
    });
    return this.#started;
  }

  async #start(): Promise<void> {
    const text = fetchStartModel();
    // When the engine cannot start, nobody waits for the model.
    text.catch(() => {});
    const events = {
      restarted: (why: string) =>
        withLab(({ files }) => this.notices.addError(files.startedAgain, `${why}.`)),
      stopped: (problem: unknown) => this.engine.stop(problem),
    };
    await this.engine.start(
      () => startEngine(this.workers, events),
      async () => {
        const first = await text;
        if (first === null) throw new Error("the host has no model for this page");
        await this.model.openStart(first);
      },
    );
    if (this.engine.state === "failed") throw new Error(this.engine.problem);
  }
}
