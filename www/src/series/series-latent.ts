// The latent path of one part, drawn as on the page of the stage.
import { html } from "lit";
import { drawLatents } from "../latents/latent-drawing";
import { StepBand } from "../latents/prediction-drawing";
import { type Projection, principalAxes } from "../latents/projection";
import { onThemeChange, partColour, partColourNow } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { clearCanvas } from "../ui/canvas";
import { View } from "../ui/view";
import type { SeriesRollout } from "../engine/series-protocol";
import type { SeriesStore } from "./series-store";
import { seriesWords } from "../words/series";

const FLAT = { about: 0, tilt: 0 };

export class SeriesLatent extends View {
  static override properties = { bodyPart: { type: Number } };
  declare model: SeriesStore;
  /** The index of the part. */
  declare bodyPart: number;
  #projection: Projection | null = null;
  /** The rollout under the learned couplings, which determines the axes. */
  #projected: SeriesRollout | null = null;
  readonly #band = new StepBand();

  protected override stores() {
    return [this.model];
  }

  protected override arrived(): void {
    this.whenLeaving(onThemeChange(() => this.requestUpdate()));
    this.whenLeaving(this.model.clock.on(() => this.#paint()));
    this.watchSize(this, () => this.#paint());
  }

  override willUpdate(): void {
    const { learned, opened } = this.model;
    const path = learned?.latents[this.bodyPart];
    if (!path || !opened || this.#projected === learned) return;
    const training = opened.training?.[this.bodyPart] ?? new Float64Array(0);
    const cloud = Float64Array.of(...path, ...training);
    this.#projection = principalAxes(cloud, this.#dimensions(path), this.#projection);
    this.#projected = learned;
  }

  #dimensions(path: Float64Array): number {
    const frames = this.model.clock.lastFrame + 1;
    return Math.round(path.length / frames);
  }

  protected override updated(): void {
    this.#paint();
  }

  #paint(): void {
    const { learned, rollout, opened, couplings, clock } = this.model;
    const path = rollout?.latents[this.bodyPart];
    const canvas = this.querySelector("canvas");
    const surface = canvas && canvas.clientWidth > 0 ? clearCanvas(canvas) : null;
    if (!path || !opened || !surface || !this.#projection) return;
    const { draw, width, height } = surface;
    drawLatents(draw, {
      width,
      height,
      ratio: Math.min(2, devicePixelRatio),
      projection: this.#projection,
      turn: FLAT,
      part: this.bodyPart,
      colour: partColourNow(this.bodyPart),
      rollout: path,
      learned: couplings.altered ? (learned?.latents[this.bodyPart] ?? null) : null,
      training: opened.training?.[this.bodyPart] ?? null,
      poses: null,
      dynamics: null,
      outgoing: [],
      incoming: [],
      order: opened.info.order ?? 1,
      frame: clock.frame,
      live: true,
      report: null,
      lit: false,
      predicted: null,
      band: this.#band,
      behind: null,
    });
  }

  protected override render() {
    const name = this.model.opened?.info.parts[this.bodyPart]?.name ?? "";
    return html`
      <figure class="latent" style=${partStyle(partColour(this.bodyPart))}>
        <figcaption><i class="swatch"></i>${name}</figcaption>
        <canvas role="img" aria-label=${seriesWords().path(name)} data-testid="series-latent-${this.bodyPart}"></canvas>
      </figure>`;
  }
}
customElements.define("pg-series-latent", SeriesLatent);
