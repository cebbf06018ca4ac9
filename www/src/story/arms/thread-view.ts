// The thread between the legs and the arms, drawn over the figure. It snaps when it is cut.
import { html, svg } from "lit";
import { nodeNamed } from "../../scene/joint-node";
import type { StageView } from "../../stage/stage-view";
import { eachFrame } from "../../ui/each-frame";
import { prefersReducedMotion } from "../../ui/reduced-motion";
import { View } from "../../ui/view";
import type { ArmsChapter } from "./arms-chapter";

/** Each thread goes from a knee to the hand of the other side, which swings with it. */
const THREADS = [
  ["LeftLeg", "RightHand"],
  ["RightLeg", "LeftHand"],
] as const;

/** Seconds in which the thread snaps, and the share of it that stays at each end. */
const SNAP = 0.3;
const LOOSE = 0.1;
/** Pixels by which a thread hangs down. */
const SLACK = 14;

export class ThreadView extends View {
  declare chapter: ArmsChapter;
  /** 0: tied; 1: cut. */
  #cut = 0;

  protected override stores() {
    return [this.chapter];
  }

  protected override arrived(): void {
    const calm = prefersReducedMotion();
    this.whenLeaving(
      eachFrame((seconds) => {
        const towards = this.chapter.isCut ? 1 : 0;
        const step = calm ? 1 : seconds / SNAP;
        this.#cut += Math.max(-step, Math.min(step, towards - this.#cut));
        this.#draw();
      }),
    );
  }

  #draw(): void {
    const scene = this.parentElement?.querySelector<StageView>("pg-stage")?.scene;
    const { content } = this.chapter.body.stage;
    const paths = this.querySelectorAll<SVGPathElement>("path");
    const half = 0.5 - this.#cut * (0.5 - LOOSE);
    THREADS.forEach((ends, i) => {
      const path = paths[i];
      const [from, to] = ends.map((name) => {
        const node = nodeNamed(content, name);
        return node < 0 ? null : (scene?.placeOf(node) ?? null);
      });
      if (!path || !from || !to) return;
      const [x, y] = [(from.x + to.x) / 2, (from.y + to.y) / 2 + SLACK];
      path.setAttribute("d", `M${from.x} ${from.y}Q${x} ${y} ${to.x} ${to.y}`);
      path.setAttribute("stroke-dasharray", this.#cut === 0 ? "none" : `${half} ${1 - 2 * half} ${half} 1`);
    });
  }

  protected override render() {
    return html`<svg aria-hidden="true" data-cut=${this.chapter.isCut ? "yes" : "no"}>${THREADS.map(() => svg`<path pathLength="1"></path>`)}</svg>`;
  }
}
customElements.define("pg-thread", ThreadView);
