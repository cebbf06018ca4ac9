// What the views of a model of columns share: its clock, which the keys control, and the space of its plots.
import type { Space } from "../latents/latent-plot";
import { LayersStore } from "../latents/layers-store";
import type { SettingsStore } from "../settings/settings-store";
import { eachFrame } from "../ui/browser";
import { View } from "../ui/view";
import type { SeriesStore } from "./series-store";

export abstract class SeriesView extends View {
  declare settings: SettingsStore;
  #space: Space | null = null;

  /** The model on show. */
  protected abstract get shown(): SeriesStore;

  protected override arrived(): void {
    this.whenLeaving(eachFrame((seconds) => this.shown.clock.advance(seconds)));
  }

  /** The clock that the keys for play and step control. */
  togglePlay(): void {
    this.shown.clock.togglePlay();
  }

  step(direction: 1 | -1): void {
    this.shown.clock.step(direction);
  }

  protected get space(): Space {
    this.#space ??= {
      layers: new LayersStore(async () => null),
      settings: this.settings,
      playback: this.shown.clock,
    };
    return this.#space;
  }
}
