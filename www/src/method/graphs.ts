// The graphical models of the method: one part with its inducing points, and two coupled parts. Circles are
// latents, squares are poses, diamonds are inducing points.
import { html, svg, type SVGTemplateResult } from "lit";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import type { MethodWords } from "./en";

const R = 21;
/** Shows a place of the page. */
type Show = (place: string) => void;
type Words = MethodWords["graphs"];

const arrow = (x1: number, y1: number, x2: number, y2: number, from = R, to = R + 5) => {
  const [dx, dy] = [x2 - x1, y2 - y1];
  const length = Math.hypot(dx, dy);
  const at = (x: number, y: number, share: number) => [x + (dx / length) * share, y + (dy / length) * share];
  const [[ax, ay], [bx, by]] = [at(x1, y1, from), at(x2, y2, -to)];
  return svg`<line x1=${ax} y1=${ay} x2=${bx} y2=${by} marker-end="url(#method-tip)" />`;
};

const tip = svg`<defs><marker id="method-tip" viewBox="0 0 8 8" refX="6" refY="4" markerWidth="7" markerHeight="7" orient="auto-start-reverse">
  <path d="M0 0L8 4L0 8z" /></marker></defs>`;

const letter = (x: number, y: number, symbol: string, below: string) =>
  svg`<text x=${x} y=${y + 5}><tspan font-style="italic">${symbol}</tspan><tspan class="below" dy="4">${below}</tspan></text>`;

/** A shape that leads to the control that it concerns. */
function link(show: Show, place: string, label: string, content: SVGTemplateResult) {
  const press = (event: KeyboardEvent) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    show(place);
  };
  return svg`<g class="graph-link" role="button" tabindex="0" data-place=${place} aria-label=${label} @click=${() => show(place)} @keydown=${press}>
    <title>${label}</title>${content}</g>`;
}

const latent = (x: number, y: number) => svg`<circle cx=${x} cy=${y} r=${R} />`;
const diamond = (x: number, y: number) =>
  svg`<path d="M${x} ${y - 23}L${x + 27} ${y}L${x} ${y + 23}L${x - 27} ${y}z" />`;
/** The letters are above the shapes, and no part of the names of the buttons. */
const letters = (content: unknown) => svg`<g class="graph-letters passive" aria-hidden="true">${content}</g>`;

const FRAMES = ["t−2", "t−1", "t"];

/** One part: its latents, its poses and the inducing points of both maps. */
function onePart(show: Show, words: Words) {
  const x = (k: number) => 60 + 110 * k;
  return svg`
    ${arrow(x(0), 70, x(1), 70)}${arrow(x(1), 70, x(2), 70)}
    <path d="M${x(0) + 12} 51Q${x(1)} 2 ${x(2) - 16} 49" marker-end="url(#method-tip)" />
    ${FRAMES.map((_, k) => arrow(x(k), 70, x(k), 160))}
    ${arrow(400, 70, x(2), 70, 28)}
    <path d="M374 160H${x(2) + R + 5}" marker-end="url(#method-tip)" />
    ${link(show, "latents", words.latents, svg`${FRAMES.map((_, k) => latent(x(k), 70))}`)}
    ${link(show, "stage", words.poses, svg`${FRAMES.map((_, k) => svg`<rect x=${x(k) - 20} y="140" width="40" height="40" />`)}`)}
    ${link(show, "points", words.dynamicsPoints, diamond(400, 70))}
    ${link(show, "points", words.posePoints, diamond(400, 160))}
    ${letters([
      ...FRAMES.map((name, k) => letter(x(k), 70, "x", name)),
      ...FRAMES.map((name, k) => letter(x(k), 160, "y", name)),
      letter(400, 70, "z, u", ""),
      letter(400, 160, "r, v", ""),
    ])}`;
}

/** Two parts that predict each other. */
function twoParts(show: Show, words: Words) {
  const x = (k: number) => 60 + 150 * k;
  const [upper, lower] = [50, 180];
  const row = (y: number, part: number) =>
    svg`<g style=${partStyle(partColour(part))} class="graph-part">${FRAMES.map((_, k) => latent(x(k), y))}</g>`;
  return svg`
    ${[upper, lower].map((y) => [0, 1].map((k) => arrow(x(k), y, x(k + 1), y)))}
    ${link(
      show,
      "couplings",
      words.couplings,
      svg`<rect class="hit" x="80" y="82" width="330" height="66" /><g class="graph-couplings">${[0, 1].map((k) => svg`${arrow(x(k), upper, x(k + 1), lower)}${arrow(x(k), lower, x(k + 1), upper)}`)}
        </g>`,
    )}
    ${link(show, "latents", words.bothLatents, svg`${row(upper, 0)}${row(lower, 1)}`)}
    ${letters([
      ...[upper, lower].map((y) => FRAMES.map((name, k) => letter(x(k), y, "x", name))),
      svg`<text x="106" y="120">α</text><text x=${x(2) + 60} y=${upper + 5}>${words.part(1)}</text>
        <text x=${x(2) + 60} y=${lower + 5}>${words.part(2)}</text>`,
    ])}`;
}

export const graphs = (show: Show, words: Words) => html`
  <div class="graphs">
    <figure><svg class="graph" viewBox="0 0 450 200" role="group" aria-label=${words.one}>${tip}${onePart(show, words)}</svg>
      <figcaption class="hint">${words.oneText}</figcaption></figure>
    <figure><svg class="graph" viewBox="0 0 450 230" role="group" aria-label=${words.two}>${twoParts(show, words)}</svg>
      <figcaption class="hint">${words.twoText}</figcaption></figure>
  </div>`;
