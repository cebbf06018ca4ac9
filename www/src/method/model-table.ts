// Which model has which property (table 1 of Velychko et al. 2018), with the evidence of this project.
import { html, nothing } from "lit";

const PROPERTIES = ["modular", "scalable", "compact", "canonical dynamics", "learned dynamics"] as const;

/** The properties of each model, in this order. */
const MODELS: readonly (readonly [model: string, has: readonly boolean[]])[] = [
  ["vCGPDM", [true, true, true, false, true]],
  ["CGPDM (MAP)", [false, false, false, false, true]],
  ["vGPDM", [false, true, true, false, true]],
  ["GPDM (MAP)", [false, false, false, false, true]],
  ["TMP", [true, true, true, false, false]],
  ["DMP", [true, true, true, true, false]],
];

const EVIDENCE: readonly { property: string; meaning: string; document: string; command?: string }[] = [
  {
    property: "modular",
    meaning: "its primitives can be used again in other movements",
    document: "docs/modularity.md",
    command: "npm run lab -- modularity",
  },
  {
    property: "scalable",
    meaning: "the time of an iteration grows less than with the cube of the frames",
    document: "docs/training.md",
    command: "npm run lab -- scaling",
  },
  {
    property: "compact",
    meaning: "what is stored does not grow with the frames",
    document: "docs/model-format.md",
  },
  {
    property: "canonical and learned dynamics",
    meaning: "the dynamics are given before learning, or are any smooth function",
    document: "docs/comparison.md",
    command: "vcgpdm evaluate",
  },
];

export const modelTable = () => html`
  <div class="table-box" tabindex="0" role="region" aria-label="Properties of the models">
    <table class="symbols model-properties">
      <thead><tr><th scope="col">Model</th>${PROPERTIES.map((property) => html`<th scope="col">${property}</th>`)}</tr></thead>
      <tbody>${MODELS.map(
        ([model, has]) => html`
        <tr><th scope="row">${model}</th>${has.map((yes) => html`<td data-has=${yes ? "yes" : "no"}>${yes ? "✓ yes" : "no"}</td>`)}</tr>`,
      )}</tbody>
    </table>
  </div>
  <ul class="works">${EVIDENCE.map(
    ({ property, meaning, document, command }) => html`
    <li><strong>${property}</strong>: ${meaning}. See <code>${document}</code>${command ? html`, measured by <code>${command}</code>` : nothing}.</li>`,
  )}</ul>`;
