// Which model has which property (table 1 of Velychko et al. 2018), with the evidence of this project.
import { html, nothing } from "lit";
import type { MethodWords } from "../words/en/method";

/** The properties of each model, in this order. */
const MODELS: readonly (readonly [model: string, has: readonly boolean[]])[] = [
  ["vCGPDM", [true, true, true, false, true]],
  ["CGPDM (MAP)", [false, false, false, false, true]],
  ["vGPDM", [false, true, true, false, true]],
  ["GPDM (MAP)", [false, false, false, false, true]],
  ["TMP", [true, true, true, false, false]],
  ["DMP", [true, true, true, true, false]],
];

type Property = keyof MethodWords["table"]["evidence"];

const EVIDENCE: readonly { property: Property; document: string; command?: string }[] = [
  { property: "modular", document: "docs/modularity.md", command: "npm run lab -- modularity" },
  { property: "scalable", document: "docs/training.md", command: "npm run lab -- scaling" },
  { property: "compact", document: "docs/model-format.md" },
  { property: "dynamics", document: "docs/comparison.md", command: "vcgpdm evaluate" },
];

export const modelTable = (words: MethodWords["table"]) => html`
  <div class="table-box" tabindex="0" role="region" aria-label=${words.label}>
    <table class="symbols model-properties">
      <thead><tr><th scope="col">${words.model}</th>${words.properties.map((property) => html`<th scope="col">${property}</th>`)}</tr></thead>
      <tbody>${MODELS.map(
        ([model, has]) => html`
        <tr><th scope="row">${model}</th>${has.map((yes) => html`<td data-has=${yes ? "yes" : "no"}>${yes ? html`✓ ${words.yes}` : words.no}</td>`)}</tr>`,
      )}</tbody>
    </table>
  </div>
  <ul class="works">${EVIDENCE.map(({ property, document, command }) => {
    const { property: name, meaning } = words.evidence[property];
    return html`
    <li><strong>${name}</strong>: ${meaning}. ${words.see} <code>${document}</code>${command ? html`${words.measuredBy} <code>${command}</code>` : nothing}.</li>`;
  })}</ul>`;
