// A small map of the body: a node for each part, an arrow for each coupling, as thick as its weight.
import { html, svg } from "lit";
import { ALPHA_MAX, ALPHA_MIN } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import { short } from "../ui/format";
import { partColour } from "../ui/palette";
import { View } from "../ui/view";
import { type Body, bodyOf, bowPath, HEIGHT, loopPath, NODE, WIDTH } from "./body-layout";
import type { ModelStore } from "./model-store";
import { weightText } from "./weights";
import { partStyle } from "../ui/styled";

/** Pixels of drag for a factor of ten in alpha. */
const DECADE = 50;
/** An arrow is cut after this many milliseconds without movement; a move of this many pixels drags it. */
const HOLD = 180;
const STILL = 4;

/** The detail of the event "hold-coupling": a held coupling is cut until it is released. */
export interface HoldCoupling {
  source: number;
  target: number;
  held: boolean;
}

export class BodyMap extends View {
  declare model: ModelStore;
  declare settings: SettingsStore;
  #drag: { source: number; target: number; y: number; alpha: number } | null = null;
  /** The timer that cuts the arrow under a resting pointer. */
  #timer = 0;
  #held: { source: number; target: number } | null = null;
  #body: Body = { spots: [], bones: [] };
  /** The sequence and the parts that `#body` belongs to. */
  #laidOut = "";

  protected override stores() {
    return [this.model, this.settings];
  }

  override willUpdate(): void {
    const { model, learned } = this.model;
    if (!model || !learned) return;
    const { sequences, parts } = model.info;
    const key = JSON.stringify([sequences[0]?.sha256, parts]);
    if (this.#laidOut === key) return;
    this.#laidOut = key;
    this.#body = bodyOf(model.info, learned.motion);
  }

  #grab(source: number, target: number) {
    return (event: PointerEvent) => {
      event.preventDefault();
      (event.currentTarget as Element).setPointerCapture(event.pointerId);
      this.#drag = { source, target, y: event.clientY, alpha: this.model.couplings.alphaOf(source, target) };
      this.#timer = window.setTimeout(() => {
        this.#drag = null;
        this.#hold({ source, target }, true);
      }, HOLD);
    };
  }

  #hold(coupling: { source: number; target: number }, held: boolean): void {
    this.#held = held ? coupling : null;
    const detail: HoldCoupling = { ...coupling, held };
    this.dispatchEvent(new CustomEvent("hold-coupling", { detail, bubbles: true }));
    this.requestUpdate();
  }

  #move(event: PointerEvent): void {
    const drag = this.#drag;
    if (!drag || (this.#timer && Math.abs(event.clientY - drag.y) < STILL)) return;
    this.#stopWaiting();
    const alpha = drag.alpha * 10 ** ((event.clientY - drag.y) / DECADE);
    this.model.couplings.set(drag.source, drag.target, Math.min(ALPHA_MAX, Math.max(ALPHA_MIN, alpha)));
  }

  #drop(): void {
    this.#stopWaiting();
    this.#drag = null;
    if (this.#held) this.#hold(this.#held, false);
  }

  #stopWaiting(): void {
    clearTimeout(this.#timer);
    this.#timer = 0;
  }

  #arrow(source: number, target: number) {
    const { model } = this;
    const w = model.couplings.weight(source, target);
    const [a, b] = [this.#body.spots[source], this.#body.spots[target]];
    if (!a || !b) return svg``;
    const width = 1 + 6.5 * w;
    const path = source === target ? loopPath(a) : bowPath(a, b);
    const name = (part: number) => model.model?.info.parts[part]?.name ?? "";
    const alpha = model.couplings.alphaOf(source, target);
    const head = `head-${source}-${target}`;
    return svg`
      <g class=${this.#held?.source === source && this.#held.target === target ? "arrow cut" : "arrow"} data-testid="arrow-${source}-${target}" style=${partStyle(partColour(source))} @pointerdown=${this.#grab(source, target)} @pointermove=${this.#move}
        @pointerup=${this.#drop} @pointercancel=${this.#drop}
        @dblclick=${() => model.couplings.reset(source, target)}>
        <title>${name(source)} to ${name(target)}: weight ${weightText(w)}, alpha ${short(alpha)}. Drag up for stronger, down for weaker; hold to cut it.</title>
        <marker id=${head} viewBox="0 0 10 10" refX="5" refY="5" markerUnits="userSpaceOnUse"
          markerWidth=${(6 + 1.25 * width).toFixed(1)} markerHeight=${(6 + 1.25 * width).toFixed(1)} orient="auto"><path d="M0 0.4L9 5L0 9.6z" /></marker>
        <path class="grip" d=${path} />
        <path class="line" d=${path} stroke-width=${width.toFixed(2)} opacity=${(0.3 + 0.7 * Math.sqrt(w)).toFixed(2)} marker-end="url(#${head})" />
      </g>`;
  }

  protected override render() {
    const { spots, bones } = this.#body;
    const parts = this.model.model?.info.parts ?? [];
    return html`
      <svg class="body-map" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" data-testid="body-map"
        aria-label="Body map: an arrow for each coupling, as thick as its weight. The sliders in the table change the same couplings.">
        ${bones.map(({ a, b, part }) => svg`<line class="map-bone" style=${partStyle(partColour(part))} x1=${a.x} y1=${a.y} x2=${b.x} y2=${b.y} />`)}
        ${parts.flatMap((_, source) => parts.map((__, target) => this.#arrow(source, target)))}
        ${parts.map(({ name }, part) =>
          spots[part]
            ? svg`
          <g style=${partStyle(partColour(part))}>
            <circle class="map-node" cx=${spots[part].x} cy=${spots[part].y} r=${NODE} />
            <title>${name}</title>
          </g>`
            : "",
        )}
      </svg>`;
  }
}
customElements.define("pg-body-map", BodyMap);
