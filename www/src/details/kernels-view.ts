// Tables of the learned kernels, lengthscales and noise.
import { html } from "lit";
import { withTerms } from "../terms/term";
import { short } from "../ui/format";
import { partColour } from "../ui/palette";
import type { Kernels } from "./kernels";
import { partStyle } from "../ui/styled";
import { numbers as words } from "../words/numbers";
import { shownPart } from "../words/lab";

/** The name of a part with its colour. */
export const partCell = (name: string, part: number) =>
  html`<span class="part-name" style=${partStyle(partColour(part))}><i class="swatch"></i>${name}</span>`;
const numbers = (values: readonly number[]) => values.map((value) => html`<td>${short(value)}</td>`);

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
  const { couplings, kernels: heads } = words();
  return html`
    <section>
      <h2>${withTerms(heads.poses)}</h2>
      <div class="table-scroll" tabindex="0" role="region" aria-label=${heads.posesLabel}>
        <table data-testid="pose-kernels">
          <thead>
            <tr><th rowspan="2" scope="col">${heads.part}</th>
              <th rowspan="2" scope="col"><pg-term of="signal-variance" text="σ²"></pg-term></th>
              <th rowspan="2" scope="col"><pg-term of="noise-variance" text="β"></pg-term></th>
              <th colspan=${across} scope="colgroup">${withTerms(heads.along)}</th></tr>
            <tr>${latents(across, (q) => String(q + 1))}</tr>
          </thead>
          <tbody>${poses.map(
            ({ part, variance, noise, lengthscales }, i) =>
              html`<tr><th scope="row">${partCell(shownPart(part), i)}</th>${numbers([variance, noise, ...lengthscales])}</tr>`,
          )}</tbody>
        </table>
      </div>
    </section>
    <section>
      <h2>${withTerms(heads.experts(order))}</h2>
      <div class="table-scroll" tabindex="0" role="region" aria-label=${heads.expertsLabel}>
        <table data-testid="expert-kernels">
          <thead>
            <tr><th rowspan="2" scope="col">${heads.from}</th><th rowspan="2" scope="col">${couplings.about}</th>
              <th rowspan="2" scope="col">${withTerms(couplings.alphaLearned)}</th>
              <th colspan=${inputs} scope="colgroup">${withTerms(heads.along)}</th></tr>
            <tr>${latents(inputs, history)}</tr>
          </thead>
          <tbody>${experts.map(
            ({ source, target, coupling, lengthscales }) =>
              html`<tr><th scope="row">${partCell(shownPart(name(source)), source)}</th><th scope="row">${partCell(shownPart(name(target)), target)}</th>
              ${numbers([coupling, ...lengthscales])}</tr>`,
          )}</tbody>
        </table>
      </div>
      <p class="hint">${heads.note}</p>
    </section>`;
}
