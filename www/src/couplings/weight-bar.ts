// The weights of the sources of a part as a bar, with a divider between each two that can be moved.
import { html } from "lit";
import { partColour } from "../ui/palette";
import { View } from "../ui/view";
import type { ModelStore } from "./model-store";
import "./weight-bar.css";
import { dividers, weightText } from "./weights";
import { partStyle, styled } from "../ui/styled";
import { lab, shownPart } from "../words/lab";

/** How far a key moves a divider. */
const STEPS: Record<string, number> = {
  ArrowLeft: -0.01,
  ArrowDown: -0.01,
  ArrowRight: 0.01,
  ArrowUp: 0.01,
  PageDown: -0.1,
  PageUp: 0.1,
  Home: Number.NEGATIVE_INFINITY,
  End: Number.POSITIVE_INFINITY,
};

/** Dividers closer than this lie on one spot: the source between them is off. */
const ONE_SPOT = 0.01;

interface Drag {
  /** The dividers on the grabbed spot. The first of them moves to the left, the last to the right. */
  first: number;
  last: number;
  /** The divider that moves; null before the first movement. */
  divider: number | null;
  /** The place of the pointer at the start, as a share of the bar, and the place of the dividers. */
  from: number;
  place: number;
}

export class WeightBar extends View {
  declare model: ModelStore;
  declare target: number;
  #drag: Drag | null = null;

  protected override stores() {
    return [this.model];
  }

  #placeOf({ clientX, currentTarget }: PointerEvent): number {
    const { left, width } = (currentTarget as Element).getBoundingClientRect();
    return (clientX - left) / width;
  }

  #grab(event: PointerEvent): void {
    const places = dividers(this.model.couplings.weightsInto(this.target));
    const from = this.#placeOf(event);
    const distances = places.map((place) => Math.abs(place - from));
    const place = places[distances.indexOf(Math.min(...distances))];
    if (place === undefined) return;
    event.preventDefault();
    const bar = event.currentTarget as HTMLElement;
    bar.setPointerCapture(event.pointerId);
    const near = (other: number) => Math.abs(other - place) < ONE_SPOT;
    this.#drag = {
      first: places.findIndex(near),
      last: places.findLastIndex(near),
      divider: null,
      from,
      place,
    };
    bar.querySelectorAll<HTMLElement>(".divider")[this.#drag.first]?.focus();
  }

  #move(event: PointerEvent): void {
    const drag = this.#drag;
    if (!drag) return;
    const by = this.#placeOf(event) - drag.from;
    if (by === 0) return;
    drag.divider ??= by < 0 ? drag.first : drag.last;
    this.model.couplings.moveDivider(this.target, drag.divider, drag.place + by);
  }

  #drop(): void {
    this.#drag = null;
  }

  #keys(divider: number, place: number) {
    return (event: KeyboardEvent) => {
      const step = STEPS[event.key];
      if (step !== undefined) this.model.couplings.moveDivider(this.target, divider, place + step);
      else if (event.key === "Backspace" || event.key === "Delete")
        this.model.couplings.resetInto(this.target);
      else return;
      event.preventDefault();
    };
  }

  protected override render() {
    const { model, target } = this;
    const names = (model.model?.info.parts ?? []).map(({ name }) => shownPart(name));
    const weights = model.couplings.weightsInto(target);
    const words = lab().couplings;
    const text = (source: number) => `${names[source]} ${weightText(weights[source] ?? 0)}`;
    return html`
      <div class="weight-bar" data-testid="shares-${target}" title=${words.bar}
        @pointerdown=${this.#grab} @pointermove=${this.#move} @pointerup=${this.#drop} @pointercancel=${this.#drop}
        @dblclick=${() => model.couplings.resetInto(target)}>
        <div class="shares">${weights.map(
          (weight, source) =>
            html`<i style=${partStyle(partColour(source), { "flex-grow": weight.toFixed(5) })}></i>`,
        )}</div>
        ${dividers(weights).map(
          (place, divider) => html`
          <span class="divider" role="slider" tabindex="0" style=${styled({ "--at": place.toFixed(5) })} data-testid="divider-${target}-${divider}"
            aria-label=${words.border(names[target] ?? "", names[divider] ?? "", names[divider + 1] ?? "")}
            aria-valuemin="0" aria-valuemax="100" aria-valuenow=${(100 * place).toFixed(0)}
            aria-valuetext="${text(divider)}, ${text(divider + 1)}"
            @keydown=${this.#keys(divider, place)}></span>`,
        )}
      </div>`;
  }
}
customElements.define("pg-weight-bar", WeightBar);
