// The phase clock: a hand for each part, which turns once in each period of the part.
import { html, nothing, svg } from "lit";
import type { Playback } from "../stage/playback";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import "./phase-clock.css";
import type { PhasesStore } from "./phases-store";
import { shownPart } from "../words/lab";

/** Half the width of the clock in its own units, and the length of a hand. */
const HALF = 50;
const HAND = 40;
/** The share of its length that a hand keeps however far its part is from the learned cycle. */
const SHORTEST = 0.25;
/** Milliseconds between two updates of the numbers of a live motion. */
const BETWEEN = 500;

/** The texts of the clock. */
export interface ClockWords {
  /** The name of the picture. */
  clock: string;
  seconds(seconds: number): string;
  /** Instead of the period of a part that does not move on. */
  still: string;
  /** For each step that the parts can keep. */
  step: Readonly<Record<"in step" | "partly in step" | "out of step", string>>;
}

/**
 * `<pg-phase-clock .phases=${app.phases} .playback=${app.playback} .words=${...}>`; the CSS variable `--clock-size` is its
 * width. The hands of parts that keep step as learned lie on each other. A hand is shorter the farther its
 * part is from the learned cycle. `names` of the parts are optional, for another language.
 */
export class PhaseClock extends View {
  static override properties = { names: {}, words: {} };
  declare phases: PhasesStore;
  declare playback: Playback;
  declare names: readonly string[] | undefined;
  declare words: ClockWords;
  #hands: SVGLineElement[] = [];
  #updatedAt = 0;

  protected override stores() {
    return [this.phases];
  }

  protected override arrived(): void {
    this.whenLeaving(this.playback.on(() => this.#turn()));
  }

  protected override updated(): void {
    this.#hands = [...this.querySelectorAll<SVGLineElement>(".clock-hand")];
    this.#turn();
  }

  /** Turns the hands. Called for each picture, so nothing is allocated. */
  #turn(): void {
    for (let part = 0; part < this.#hands.length; part++) {
      const hand = this.#hands[part]!;
      const angle = 2 * Math.PI * this.phases.turns(part);
      const away = Math.min(1, this.phases.distance(part));
      const length = HAND * (1 - (1 - SHORTEST) * away);
      hand.x2.baseVal.value = length * Math.sin(angle);
      hand.y2.baseVal.value = -length * Math.cos(angle);
    }
    if (!this.phases.isLive || performance.now() - this.#updatedAt < BETWEEN) return;
    this.#updatedAt = performance.now();
    this.requestUpdate();
  }

  protected override render() {
    const { parts, step, isCurrent } = this.phases;
    if (parts.length === 0) return nothing;
    const { words } = this;
    return html`
      <svg class="clock-face" viewBox="${-HALF} ${-HALF} ${2 * HALF} ${2 * HALF}" role="img" aria-label=${words.clock}>
        <circle class="clock-ring" r=${HALF - 3}></circle>
        <line class="clock-top" y1=${-HALF + 3} y2=${-HALF + 8}></line>
        ${parts.map((_, part) => svg`<line class="clock-hand" data-testid="hand-${part}" style=${partStyle(partColour(part))} x1="0" y1="0" x2="0" y2="0"></line>`)}
        <circle class="clock-pin" r="3"></circle>
      </svg>
      <ul class="clock-periods" data-testid="clock-periods" data-current=${isCurrent ? "yes" : "no"}>
        ${parts.map(({ name }, part) => {
          const period = this.phases.period(part);
          return html`<li data-testid="clock-period-${part}" style=${partStyle(partColour(part))}><i class="swatch"></i>${this.names?.[part] ?? shownPart(name)}
            <b>${period === "still" ? words.still : period === null ? "…" : words.seconds(period)}</b></li>`;
        })}
        ${step ? html`<li data-testid="clock-step" data-step=${step}>${words.step[step]}</li>` : nothing}
      </ul>`;
  }
}
customElements.define("pg-phase-clock", PhaseClock);
