// Tables of the learned kernels, lengthscales and noise.
import { html } from "lit";
import "../terms/term";
import { short } from "../ui/format";
import { partColour } from "../ui/palette";
import type { Kernels } from "./kernels";
import { partStyle } from "../ui/styled";

/** The name of a part with its colour. */
export const partCell = (name: string, part: number) =>
  html`<span class="part-name" style=${partStyle(partColour(part))}><i class="swatch"></i>${name}</span>`;
const numbers = (values: readonly number[]) => values.map((value) => html`<td>${short(value)}</td>`);
const lengthscale = html`<pg-term of="lengthscale" text="Lengthscale"></pg-term>`;

/** The number of dimensions of the widest latent space; parts with fewer have empty cells. */
const widest = (rows: readonly { lengthscales: readonly number[] }[]) =>
  Math.max(1, ...rows.map(({ lengthscales }) => lengthscales.length));
const latents = (count: number, index: (q: number) => string) =>
  Array.from({ length: count }, (_, q) => html`<th scope="col">x<sub>${index(q)}</sub></th>`);

export function kernelTables({ poses, experts, order }: Kernels) {
  const across = widest(poses);
  const inputs = widest(experts);
  /** The earlier frame of an input dimension, and the dimension in that frame. */
  const history = (q: number) =>
    `${(q % (inputs / order)) + 1}, t−${order - Math.floor((q * order) / inputs)}`;
  const name = (part: number) => poses[part]?.part ?? "";
  return html`
    <section>
      <h2><pg-term of="pose-map" text="Pose maps"></pg-term>: from latent to pose</h2>
      <div class="table-scroll" tabindex="0" role="region" aria-label="Kernels of the pose maps">
        <table data-testid="pose-kernels">
          <thead>
            <tr><th rowspan="2" scope="col">part</th>
              <th rowspan="2" scope="col"><pg-term of="signal-variance" text="σ²"></pg-term></th>
              <th rowspan="2" scope="col"><pg-term of="noise-variance" text="β"></pg-term></th>
              <th colspan=${across} scope="colgroup">${lengthscale} √λ along</th></tr>
            <tr>${latents(across, (q) => String(q + 1))}</tr>
          </thead>
          <tbody>${poses.map(
            ({ part, variance, noise, lengthscales }, i) =>
              html`<tr><th scope="row">${partCell(part, i)}</th>${numbers([variance, noise, ...lengthscales])}</tr>`,
          )}</tbody>
        </table>
      </div>
    </section>
    <section>
      <h2><pg-term of="expert" text="Experts"></pg-term>: from the last ${order === 1 ? "frame" : `${order} frames`} to the next latent</h2>
      <div class="table-scroll" tabindex="0" role="region" aria-label="Kernels of the experts">
        <table data-testid="expert-kernels">
          <thead>
            <tr><th rowspan="2" scope="col">from</th><th rowspan="2" scope="col">about</th>
              <th rowspan="2" scope="col"><pg-term of="alpha" text="α"></pg-term> learned</th>
              <th colspan=${inputs} scope="colgroup">${lengthscale} √λ along</th></tr>
            <tr>${latents(inputs, history)}</tr>
          </thead>
          <tbody>${experts.map(
            ({ source, target, coupling, lengthscales }) =>
              html`<tr><th scope="row">${partCell(name(source), source)}</th><th scope="row">${partCell(name(target), target)}</th>
              ${numbers([coupling, ...lengthscales])}</tr>`,
          )}</tbody>
        </table>
      </div>
      <p class="hint">Every kernel is squared exponential, without a linear part. The signal variance of every expert is 1: otherwise its scale
        could be traded for its coupling.</p>
    </section>`;
}
