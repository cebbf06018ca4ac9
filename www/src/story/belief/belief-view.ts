// Two moving points, the arrow that the model believes in, and the true arrow behind a curtain.
import { html, nothing, svg } from "lit";
import { frameOf, linePath } from "../../experiment/paths";
import { eachFrame } from "../../ui/each-frame";
import { partColour } from "../../ui/palette";
import { prefersReducedMotion } from "../../ui/reduced-motion";
import { partStyle } from "../../ui/styled";
import { View } from "../../ui/view";
import type { BeliefChapter } from "./belief-chapter";
import type { Belief } from "./rounds";

const SIDE = 200;
/** Frames a second. */
const PACE = 20;
/** The two points on the screen. */
const POINTS = ["A", "B"] as const;
/** The places of A and B in a row of arrows, and the radius of their circles. */
const [LEFT, RIGHT, RADIUS] = [26, 134, 18];

const arrow = (from: number, to: number, y: number) => {
  const tip = to - Math.sign(to - from) * (RADIUS + 3);
  const start = from + Math.sign(to - from) * (RADIUS + 3);
  const back = tip - Math.sign(to - from) * 9;
  return svg`<path class="belief-arrow" d="M${start} ${y}H${tip}M${back} ${y - 6}L${tip} ${y}L${back} ${y + 6}"></path>`;
};

export class BeliefView extends View {
  declare chapter: BeliefChapter;
  #seconds = 0;

  protected override stores() {
    return [this.chapter];
  }

  protected override arrived(): void {
    if (prefersReducedMotion()) return;
    this.whenLeaving(
      eachFrame((seconds) => {
        this.#seconds += seconds;
        this.#move();
      }),
    );
  }

  protected override updated(): void {
    this.#move();
  }

  /** The true latents of A or B. */
  #latents(point: number): readonly number[] {
    const { experiment, round } = this.chapter;
    return experiment.truth?.latents[round.isMirrored ? 1 - point : point] ?? [];
  }

  #move(): void {
    this.querySelectorAll<SVGCircleElement>(".belief-point").forEach((circle, point) => {
      const latents = this.#latents(point);
      const frames = latents.length / 2;
      if (frames === 0) return;
      const { middle, scale } = frameOf(latents, SIDE);
      const frame = Math.floor(this.#seconds * PACE) % frames;
      const [x = 0, y = 0] = latents.slice(2 * frame, 2 * frame + 2);
      circle.setAttribute("cx", String(SIDE / 2 + scale * (x - middle[0])));
      circle.setAttribute("cy", String(SIDE / 2 - scale * (y - middle[1])));
    });
  }

  /** The arrows between A and B; null: not known yet. */
  #row(title: string, answer: Belief | null, isTruth: boolean) {
    const [y, isOpen] = [26, answer !== null];
    return html`
      <div class="belief-row" data-testid=${isTruth ? "truth-row" : "belief-row"} data-answer=${answer ?? ""}>
        <svg viewBox="0 0 160 52" aria-hidden="true">
          ${answer === "ab" || answer === "both" ? arrow(LEFT, RIGHT, answer === "both" ? y - 8 : y) : nothing}
          ${answer === "ba" || answer === "both" ? arrow(RIGHT, LEFT, answer === "both" ? y + 8 : y) : nothing}
          ${[LEFT, RIGHT].map((x, point) => svg`<g style=${partStyle(partColour(point))}><circle class="belief-node" cx=${x} cy=${y} r=${RADIUS} /><text x=${x} y=${y + 5}>${POINTS[point]}</text></g>`)}
          ${isOpen || isTruth ? nothing : svg`<text class="belief-unknown" x="80" y=${y + 6}>?</text>`}
        </svg>
        ${isTruth ? html`<span class="belief-curtain" ?data-open=${isOpen} aria-hidden="true"></span>` : nothing}
        <p>${title}</p>
      </div>`;
  }

  protected override render() {
    const { belief, truth, words } = this.chapter;
    const path = (point: number) => {
      const latents = this.#latents(point);
      return svg`<path class="belief-path" d=${linePath(latents, frameOf(latents, SIDE))} />`;
    };
    return html`
      <div class="belief" role="group" aria-label=${words.figure}>
        ${POINTS.map(
          (name, point) => html`
          <figure style=${partStyle(partColour(point))}>
            <svg viewBox="0 0 ${SIDE} ${SIDE}" aria-hidden="true">${path(point)}<circle class="belief-point" r="7" cx="-20" cy="-20" /></svg>
            <figcaption>${name}</figcaption>
          </figure>`,
        )}
        <div class="belief-rows">
          ${this.#row(words.modelRow, belief, false)}
          ${this.#row(words.truthRow, truth, true)}
        </div>
      </div>`;
  }
}
customElements.define("pg-belief", BeliefView);
