// A map of the body: a node for each part, and an arrow for each coupling, as thick as its weight. Each arrow
// has a knob, which is the slider of its coupling.
import { html, svg } from "lit";
import { ALPHA_MAX, ALPHA_MIN } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import { withTerms } from "../terms/term";
import { short } from "../ui/format";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import { type Arrow, type Body, bodyOf, bowBetween, HEIGHT, loopAt, NODE, WIDTH } from "./body-layout";
import type { ModelStore } from "./model-store";
import { alphaOf, placeOf, STRONGEST, strengthOf, WEAKEST } from "./strength";
import { weights, weightText } from "./weights";
import { lab, shownPart } from "../words/lab";

/** Pixels of drag for a factor of ten in alpha. */
const DECADE = 50;
/** An arrow is cut after this many milliseconds without movement; a move of this many pixels drags it. */
const HOLD = 180;
const STILL = 4;
/** How far a key moves a coupling, as a power of ten. */
const STEPS: Record<string, number> = {
  ArrowUp: 0.1,
  ArrowRight: 0.1,
  ArrowDown: -0.1,
  ArrowLeft: -0.1,
  PageUp: 0.5,
  PageDown: -0.5,
  Home: Number.NEGATIVE_INFINITY,
  End: Number.POSITIVE_INFINITY,
};

interface Coupling {
  source: number;
  target: number;
}

/** The detail of the event "hold-coupling": a held coupling is cut until it is released. */
export interface HoldCoupling extends Coupling {
  held: boolean;
}

const thickness = (weight: number) => 1 + 6.5 * weight;

export class BodyMap extends View {
  declare model: ModelStore;
  declare settings: SettingsStore;
  #drag: (Coupling & { y: number; alpha: number }) | null = null;
  /** The timer that cuts the arrow under a resting pointer. */
  #timer = 0;
  #held: Coupling | null = null;
  /** The coupling that the line below the map describes. */
  #described: Coupling | null = null;
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
    this.#described = null;
    this.#body = bodyOf(model.info, learned.motion);
  }

  #describe(coupling: Coupling) {
    return ({ type }: Event) => {
      // The pointer often rests on another arrow after a drag.
      if (type === "pointerenter" && this.querySelector(".knob:focus")) return;
      this.#described = coupling;
      this.requestUpdate();
    };
  }

  #grab({ source, target }: Coupling) {
    return (event: PointerEvent) => {
      event.preventDefault();
      (event.currentTarget as Element).setPointerCapture(event.pointerId);
      this.querySelector<HTMLElement>(`[data-testid=knob-${source}-${target}]`)?.focus();
      this.#drag = { source, target, y: event.clientY, alpha: this.model.couplings.alphaOf(source, target) };
      this.#timer = window.setTimeout(() => {
        this.#drag = null;
        this.#hold({ source, target }, true);
      }, HOLD);
    };
  }

  #hold(coupling: Coupling, held: boolean): void {
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

  #keys({ source, target }: Coupling) {
    return (event: KeyboardEvent) => {
      const { couplings } = this.model;
      const step = STEPS[event.key];
      if (step !== undefined) {
        const strength = strengthOf(couplings.alphaOf(source, target)) + step;
        couplings.set(source, target, alphaOf(Math.min(STRONGEST, Math.max(WEAKEST, strength))));
      } else if (event.key === "Backspace" || event.key === "Delete") couplings.reset(source, target);
      else return;
      event.preventDefault();
    };
  }

  #names({ source, target }: Coupling): string {
    const name = (part: number) => shownPart(this.model.model?.info.parts[part]?.name ?? "");
    const { drives, itself } = lab().couplings;
    return drives(name(source), source === target ? itself : name(target));
  }

  #isHeld({ source, target }: Coupling): boolean {
    return this.#held?.source === source && this.#held.target === target;
  }

  /** The weight of a coupling as learned. */
  #learnedWeight({ source, target }: Coupling): number {
    const { couplings } = this.model;
    return weights(couplings.learned.map((_, other) => couplings.learnedAlpha(other, target)))[source] ?? 0;
  }

  #line(coupling: Coupling, { path }: Arrow) {
    const { source, target } = coupling;
    const { couplings } = this.model;
    const weight = couplings.weight(source, target);
    const width = thickness(weight);
    const head = `head-${source}-${target}`;
    const size = (6 + 1.25 * width).toFixed(1);
    const learned = thickness(this.#learnedWeight(coupling));
    return svg`
      <g class=${this.#isHeld(coupling) ? "arrow cut" : "arrow"} data-testid="arrow-${source}-${target}" style=${partStyle(partColour(source))}
        @pointerdown=${this.#grab(coupling)} @pointermove=${this.#move} @pointerup=${this.#drop} @pointercancel=${this.#drop}
        @pointerenter=${this.#describe(coupling)} @dblclick=${() => couplings.reset(source, target)}>
        <marker id=${head} viewBox="0 0 10 10" refX="5" refY="5" markerUnits="userSpaceOnUse"
          markerWidth=${size} markerHeight=${size} orient="auto"><path d="M0 0.4L9 5L0 9.6z" /></marker>
        <path class="grip" d=${path} />
        ${Math.abs(learned - width) > 0.1 ? svg`<path class="learned" d=${path} stroke-width=${learned.toFixed(2)} />` : ""}
        <path class="line" d=${path} stroke-width=${width.toFixed(2)} opacity=${(0.3 + 0.7 * Math.sqrt(weight)).toFixed(2)} marker-end="url(#${head})" />
      </g>`;
  }

  #knob(coupling: Coupling, { middle }: Arrow) {
    const { source, target } = coupling;
    const { couplings } = this.model;
    const alpha = couplings.alphaOf(source, target);
    const place = {
      left: `${((100 * middle.x) / WIDTH).toFixed(2)}%`,
      top: `${((100 * middle.y) / HEIGHT).toFixed(2)}%`,
    };
    return html`
      <span class="knob" role="slider" tabindex="0" style=${partStyle(partColour(source), place)} data-testid="knob-${source}-${target}"
        data-source=${source} data-target=${target} aria-orientation="vertical" aria-label=${this.#names(coupling)}
        aria-valuemin="0" aria-valuemax="100" aria-valuenow=${(100 * placeOf(alpha)).toFixed(0)}
        aria-valuetext=${lab().couplings.knob(weightText(couplings.weight(source, target)), short(alpha), short(couplings.learnedAlpha(source, target)))}
        @pointerdown=${this.#grab(coupling)} @pointermove=${this.#move} @pointerup=${this.#drop} @pointercancel=${this.#drop}
        @pointerenter=${this.#describe(coupling)} @focus=${this.#describe(coupling)} @keydown=${this.#keys(coupling)}
        @dblclick=${() => couplings.reset(source, target)}></span>`;
  }

  /** The weight of the coupling that was last pointed at, at first what an arrow is. */
  #description() {
    const coupling = this.#described;
    if (!coupling) return withTerms(lab().couplings.arrows);
    const { couplings } = this.model;
    const { source, target } = coupling;
    const now = weightText(couplings.weight(source, target));
    const learned = couplings.isChanged(source, target) ? weightText(this.#learnedWeight(coupling)) : null;
    return lab().couplings.weight(this.#names(coupling), now, learned);
  }

  protected override render() {
    const { spots, bones } = this.#body;
    const parts = this.model.model?.info.parts ?? [];
    const arrows = spots.flatMap((a, source) =>
      spots.map((b, target) => ({
        coupling: { source, target },
        arrow: source === target ? loopAt(a) : bowBetween(a, b),
      })),
    );
    return html`
      <div class="body-map" data-testid="body-map" data-parts=${parts.length} role="group" aria-label=${lab().couplings.map}>
        <svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="presentation">
          ${bones.map(({ a, b, part }) => svg`<line class="map-bone" style=${partStyle(partColour(part))} x1=${a.x} y1=${a.y} x2=${b.x} y2=${b.y} />`)}
          ${arrows.map(({ coupling, arrow }) => this.#line(coupling, arrow))}
          ${spots.map(
            ({ x, y }, part) =>
              svg`<circle class="map-node" style=${partStyle(partColour(part))} cx=${x} cy=${y} r=${NODE} />`,
          )}
        </svg>
        ${arrows.map(({ coupling, arrow }) => this.#knob(coupling, arrow))}
      </div>
      <p class="described" data-testid="described">${this.#description()}</p>`;
  }
}
customElements.define("pg-body-map", BodyMap);
