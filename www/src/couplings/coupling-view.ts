// A coupling in the picture of the Lab: an arrow from loop to loop, as thick as its weight, and its slider.
// The arrow can be dragged too; held still, it is cut until it is released.
import { html, nothing, svg } from "lit";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import { type Coupling, couplingSlider, setWithin } from "./coupling-slider";
import type { Coupled } from "./coupled";
import "./coupling-view.css";
import { lab, shownPart } from "../words/lab";

/** Pixels of drag for a factor of ten in alpha. */
const DECADE = 50;
/** An arrow is cut after this many milliseconds without movement; a move of this many pixels drags it. */
const HOLD = 180;
const STILL = 4;

/** The detail of the event "hold-coupling": a held coupling is cut until it is released. */
export interface HoldCoupling extends Coupling {
  held: boolean;
}

/** Where an arrow leads: to the loop above or below, or back to its own loop. */
export type Way = "up" | "down" | "itself";

/** The line of each arrow in a drawing of 40 by 100. */
const PATHS: Readonly<Record<Way, string>> = {
  up: "M20 98V12",
  down: "M20 2V88",
  itself: "M0 26C48 4 48 96 9 78",
};

const thickness = (weight: number) => 1 + 6.5 * weight;

export class CouplingView extends View {
  static override properties = { source: { type: Number }, target: { type: Number }, way: {} };
  declare model: Coupled;
  declare source: number;
  declare target: number;
  declare way: Way;
  #drag: { y: number; alpha: number } | null = null;
  /** The timer that cuts the arrow under a resting pointer. */
  #timer = 0;
  #held = false;

  protected override stores() {
    return [this.model];
  }

  #grab(event: PointerEvent): void {
    const { source, target } = this;
    event.preventDefault();
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    this.querySelector("input")?.focus();
    this.#drag = { y: event.clientY, alpha: this.model.couplings.alphaOf(source, target) };
    this.#timer = window.setTimeout(() => {
      this.#drag = null;
      this.#hold(true);
    }, HOLD);
  }

  #hold(held: boolean): void {
    this.#held = held;
    const detail: HoldCoupling = { source: this.source, target: this.target, held };
    this.tell("hold-coupling", detail);
    this.requestUpdate();
  }

  #move(event: PointerEvent): void {
    const drag = this.#drag;
    if (!drag || (this.#timer && Math.abs(event.clientY - drag.y) < STILL)) return;
    this.#stopWaiting();
    setWithin(this.model.couplings, this, drag.alpha * 10 ** ((event.clientY - drag.y) / DECADE));
  }

  #drop(): void {
    this.#stopWaiting();
    this.#drag = null;
    if (this.#held) this.#hold(false);
  }

  #stopWaiting(): void {
    clearTimeout(this.#timer);
    this.#timer = 0;
  }

  #arrow() {
    const { source, target, way } = this;
    const { couplings } = this.model;
    const weight = couplings.weight(source, target);
    const width = thickness(weight);
    const learned = thickness(couplings.learnedWeight(source, target));
    const head = `head-${source}-${target}`;
    const path = PATHS[way];
    const size = (7 + 1.25 * width).toFixed(1);
    return html`
      <svg class=${this.#held ? "arrow cut" : "arrow"} viewBox="0 0 40 100" aria-hidden="true" data-way=${way} data-testid="arrow-${source}-${target}"
        @pointerdown=${this.#grab} @pointermove=${this.#move} @pointerup=${this.#drop} @pointercancel=${this.#drop}
        @dblclick=${() => couplings.reset(source, target)}>
        <title>${lab().couplings.arrow}</title>
        <marker id=${head} viewBox="0 0 10 10" refX="5" refY="5" markerUnits="userSpaceOnUse"
          markerWidth=${size} markerHeight=${size} orient="auto"><path d="M0 0.4L9 5L0 9.6z" /></marker>
        <path class="grip" d=${path} />
        ${Math.abs(learned - width) > 0.1 ? svg`<path class="learned" d=${path} stroke-width=${learned.toFixed(2)} />` : nothing}
        <path class="line" d=${path} stroke-width=${width.toFixed(2)} opacity=${(0.3 + 0.7 * Math.sqrt(weight)).toFixed(2)} marker-end="url(#${head})" />
      </svg>`;
  }

  protected override render() {
    const { couplings, model } = this.model;
    const { source, target } = this;
    const name = (part: number) => shownPart(model?.info.parts[part]?.name ?? "");
    const names = [name(source), name(target)] as const;
    return html`
      <div class="coupling-row" style=${partStyle(partColour(source))}>
        ${this.#arrow()}
        <div>
          <span class="coupling-names">${lab().couplings.toOther(...names)}</span>
          ${couplingSlider({ couplings, source, target, names })}
        </div>
      </div>`;
  }
}
customElements.define("pg-coupling", CouplingView);
