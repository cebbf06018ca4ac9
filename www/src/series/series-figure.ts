// The figure of points of a model of tables, under the clock of the curves.
import { html, nothing } from "lit";
import { type FigureMotion, FollowedFigure } from "../scene/followed-figure";
import { HERE, poseAt } from "../scene/motion";
import { eachFrame } from "../ui/browser";
import { View } from "../ui/view";
import { motionOf, type PointBody, pointBody } from "./point-body";
import type { SeriesStore } from "./series-store";
import type { SeriesRollout } from "../engine/series-protocol";
import { seriesWords } from "./view-words";

export class SeriesFigure extends View {
  declare model: SeriesStore;
  /** The body, and the rollout under the learned couplings that it was found in; null: no figure. */
  #body: PointBody | null = null;
  #foundIn: SeriesRollout | null = null;
  #shown: FigureMotion | null = null;
  #rollout: SeriesRollout | null = null;
  #pose = new Float32Array(0);
  #picture: FollowedFigure | null = null;
  /** Without WebGL there are the curves alone. */
  #hasGraphics = true;

  protected override arrived(): void {
    this.whenLeaving(this.model.clock.on(() => this.#picture?.viewport.changed()));
    this.whenLeaving(eachFrame((seconds) => this.#picture?.draw(seconds)));
    this.whenLeaving(() => this.#end());
  }

  #end(): void {
    this.#picture?.dispose();
    this.#picture = null;
  }

  /** The pose now, and the clock of the curves. */
  #clock() {
    const { clock } = this.model;
    const now = () => {
      const { motion } = this.#shown ?? {};
      return motion ? poseAt(motion, clock.frame, HERE, this.#pose) : null;
    };
    return {
      get pose() {
        return now();
      },
      get frame() {
        return clock.frame;
      },
      get playing() {
        return clock.playing;
      },
      get speed() {
        return clock.speed;
      },
    };
  }

  override willUpdate(): void {
    const { opened, learned, rollout, recorded } = this.model;
    if (!opened || !learned || !rollout || rollout === this.#rollout) return;
    this.#rollout = rollout;
    const { info } = opened;
    if (learned !== this.#foundIn) {
      this.#foundIn = learned;
      // A recording shows better than a model which points keep their distance.
      const isWhole = recorded?.info.columns.join() === info.columns.join();
      this.#body = pointBody(info, isWhole && recorded ? recorded.values : learned.values);
    }
    const body = this.#body;
    const motion = body && motionOf(body, rollout.values, info.columns.length, info.frameTime);
    this.#shown = body && motion && { ...body, motion };
    this.#pose = new Float32Array((motion?.nodes ?? 0) * 3);
  }

  protected override updated(): void {
    const canvas = this.querySelector("canvas");
    if (!canvas) {
      this.#end();
      return;
    }
    if (!this.#picture) {
      try {
        this.#picture = new FollowedFigure(canvas, this.#clock(), () => this.#show());
      } catch {
        this.#hasGraphics = false;
        this.requestUpdate();
        return;
      }
      this.#picture.scrollsWithPage();
    }
    this.#show();
  }

  #show(): void {
    if (this.#shown) this.#picture?.show(this.#shown);
  }

  protected override render() {
    if (!this.#shown || !this.#hasGraphics) return nothing;
    return html`<canvas tabindex="0" role="img" data-testid="series-figure" aria-label=${seriesWords().figure}></canvas>`;
  }
}
customElements.define("pg-series-figure", SeriesFigure);
