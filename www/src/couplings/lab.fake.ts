// For tests: the Lab's stores round a model, which a fake engine computes.
import { ClipsStore } from "../clips/clips-store";
import { FakeEngine, FakeTrainers, modelText, started } from "../engine/engine.fake";
import { EngineStore } from "../engine/engine-store";
import { FakeAddressBar } from "../settings/address.fake";
import { SettingsStore } from "../settings/settings-store";
import { Playback } from "../stage/playback";
import { StageStore } from "../stage/stage-store";
import { NoticesStore } from "../ui/notices-store";
import { ModelStore } from "./model-store";

export class FakeLab {
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
    readonly engine = new FakeEngine(),
  ) {
    this.bar = new FakeAddressBar(fragment);
    this.settings = new SettingsStore(this.bar);
    this.playback = new Playback(this.settings);
    this.stage = new StageStore(this.playback);
    this.clips = new ClipsStore(this.store, this.settings, this.stage);
    this.model = new ModelStore(this.store, this.settings, this.stage, this.notices);
  }

  /** Opens a model, after the stores of a test have begun to listen. */
  async start(
    text = modelText(1),
    options?: Parameters<ModelStore["open"]>[1],
    trainers = new FakeTrainers(1),
  ): Promise<void> {
    const programs = () => Promise.resolve(started(this.engine, trainers));
    await this.store.start(programs, () => this.model.open(text, options));
  }
}
