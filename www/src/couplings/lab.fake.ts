// For tests: the Lab's stores round a model, with held workers.
import { ClipsStore } from "../clips/clips-store";
import { modelText } from "../engine/documents.fake";
import { EngineStore } from "../engine/engine-store";
import { HeldWorkers } from "../engine/held.fake";
import { FakeAddressBar } from "../settings/address.fake";
import { SettingsStore } from "../settings/settings-store";
import { Playback } from "../stage/playback";
import { StageStore } from "../stage/stage-store";
import { NoticesStore } from "../ui/notices-store";
import { ModelStore } from "./model-store";

export class HeldLab {
  readonly bar: FakeAddressBar;
  readonly store = new EngineStore();
  readonly settings: SettingsStore;
  readonly playback: Playback;
  readonly stage: StageStore;
  readonly clips: ClipsStore;
  readonly notices = new NoticesStore();
  readonly model: ModelStore;

  constructor(
    fragment = "",
    readonly workers = new HeldWorkers(),
  ) {
    this.bar = new FakeAddressBar(fragment);
    this.settings = new SettingsStore(this.bar);
    this.playback = new Playback(this.settings);
    this.stage = new StageStore(this.playback);
    this.clips = new ClipsStore(this.store, this.settings, this.stage);
    this.model = new ModelStore(this.store, this.settings, this.stage, this.notices);
  }

  /** Opens a model, after the stores of a test have begun to listen. */
  async start(text = modelText(1), options?: Parameters<ModelStore["open"]>[1]): Promise<void> {
    const programs = () => Promise.resolve(this.workers.started());
    await this.store.start(programs, () => this.model.open(text, options));
  }
}
