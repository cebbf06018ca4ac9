// What the page knows, in one place: makes the stores and gives each those that it needs.
import { EngineStore } from "../engine/engine-store";
import { ClipsStore } from "../clips/clips-store";
import type { AddressBar } from "../settings/address";
import { SettingsStore } from "../settings/settings-store";
import { Playback } from "../stage/playback";
import { StageStore } from "../stage/stage-store";
import { NoticesStore } from "../ui/notices-store";

export class App {
  readonly notices = new NoticesStore();
  readonly engine = new EngineStore();
  readonly settings: SettingsStore;
  readonly playback: Playback;
  readonly stage: StageStore;
  readonly clips: ClipsStore;

  constructor(
    address: AddressBar,
    /** Whether another page shows this one in a frame: the stage, the latent plots and the couplings only. */
    readonly embedded: boolean,
  ) {
    this.settings = new SettingsStore(address);
    this.playback = new Playback(this.settings);
    this.stage = new StageStore(this.playback);
    this.clips = new ClipsStore(this.engine, this.settings, this.stage);
  }
}
