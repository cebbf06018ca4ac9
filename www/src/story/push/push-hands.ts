// Rings around the hands of the figure, which invite to pull them. Limbs follow the pointer.
import { html } from "lit";
import { letDragLimbs } from "../../live/drag-limbs";
import { nodeNamed } from "../../scene/joint-node";
import type { StageView } from "../../stage/stage-view";
import { eachFrame } from "../../ui/each-frame";
import { View } from "../../ui/view";
import type { PushChapter } from "./push-chapter";

const HANDS = ["LeftHand", "RightHand"];

export class PushHands extends View {
  declare chapter: PushChapter;
  #stage: StageView | null = null;
  #stopDrag: (() => void) | null = null;

  protected override stores() {
    return [this.chapter];
  }

  protected override arrived(): void {
    this.#stage = this.parentElement?.querySelector<StageView>("pg-stage") ?? null;
    this.whenLeaving(eachFrame(() => this.#follow()));
    this.whenLeaving(() => this.#stopDrag?.());
  }

  protected override updated(): void {
    const { live, isOpen } = this.chapter;
    const picture = this.#stage?.querySelector("canvas");
    if (!isOpen || !live || !picture || !this.#stage || this.#stopDrag) return;
    this.#stopDrag = letDragLimbs(this.#stage, picture, live);
  }

  /** Moves the rings onto the hands. */
  #follow(): void {
    if (!this.chapter.isOpen) return;
    const { content } = this.chapter.body.stage;
    const rings = this.querySelectorAll<HTMLElement>(".push-ring");
    HANDS.forEach((name, i) => {
      const node = nodeNamed(content, name);
      const place = node < 0 ? null : this.#stage?.scene?.placeOf(node);
      const ring = rings[i];
      if (ring && place) ring.style.transform = `translate(${place.x}px, ${place.y}px)`;
    });
  }

  protected override render() {
    return this.chapter.isOpen ? HANDS.map(() => html`<i class="push-ring" aria-hidden="true"></i>`) : [];
  }
}
customElements.define("pg-push-hands", PushHands);
