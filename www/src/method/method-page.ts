// The view of the method: the equations of the model, its symbols, the two readings of a coupling, and the
// works to cite.
import { html, nothing } from "lit";
import { unsafeHTML } from "lit/directives/unsafe-html.js";
import { withTerms } from "../terms/term";
import { download } from "../ui/download";
import { View } from "../ui/view";
import type { Draw } from "../views/define-view";
import type { MethodWords } from "./en";
import { methodWords } from "./view-words";
import { EQUATIONS, equationsWith, SYMBOLS } from "./equations";
import { graphs } from "./graphs";
import "./method.css";
import papers from "./papers.bib?raw";
import { WORKS } from "./references";

type SymbolRow =
  | { symbol: Shown; place: string }
  /** No place shows the symbol. */
  | { symbol: Exclude<keyof typeof SYMBOLS, Shown>; place: null };
type Shown = keyof MethodWords["symbols"]["there"];

const SYMBOL_ROWS: SymbolRow[] = [
  { symbol: "parts", place: "parts" },
  { symbol: "frames", place: "length" },
  { symbol: "pose", place: "stage" },
  { symbol: "latent", place: "latents" },
  { symbol: "dimensions", place: "latent dimensions" },
  { symbol: "history", place: null },
  { symbol: "order", place: "order" },
  { symbol: "expert", place: "reading" },
  { symbol: "coupling", place: "couplings" },
  { symbol: "weight", place: "couplings" },
  { symbol: "dynamicsPoints", place: "points" },
  { symbol: "dynamicsCount", place: "dynamics points" },
  { symbol: "poseMap", place: null },
  { symbol: "posePoints", place: "points" },
  { symbol: "poseCount", place: "pose points" },
  { symbol: "noise", place: null },
  { symbol: "lengths", place: null },
  { symbol: "bound", place: "train" },
];

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
  { property: "dynamics", document: "docs/comparison.md" },
];

const modelTable = (words: MethodWords["table"]) => html`
  <div class="table-box" tabindex="0" role="region" aria-label=${words.label}>
    <table class="symbols model-properties"><caption class="hint">${words.label}</caption>
      <thead class="hint"><tr><th scope="col">${words.model}</th>${words.properties.map((property) => html`<th scope="col">${property}</th>`)}</tr></thead>
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

/** The name of a format. */
const BIBTEX = "BibTeX";

type Equation = keyof MethodWords["equations"];

function equation(name: Equation) {
  const { equation, equations, inEquations } = methodWords();
  const drawn: Record<Equation, string> = { ...EQUATIONS, ...equationsWith(inEquations) };
  return html`<div class="equation" tabindex="0" role="region" aria-label=${equation(equations[name])}>${unsafeHTML(drawn[name])}</div>`;
}

export class MethodPage extends View {
  #model() {
    const { graphs: drawn, model, training, steps, rollout, readings } = methodWords();
    return html`
      <section class="panel">
        <h2>${model.title}</h2>
        ${graphs((place) => this.tell("show-place", place), drawn)}
        <p>${withTerms(model.latents)}</p>
        ${equation("dynamics")}
        ${equation("weights")}
        ${equation("history")}
        <p>${model.weights}</p>
        ${equation("expert")}
        ${equation("kernel")}
        <p>${withTerms(model.poses)}</p>
        ${equation("pose")}
      </section>
      <section class="panel">
        <h2>${training.title}</h2>
        <p>${training.bound}</p>
        ${equation("bound")}
        <p>${training.weights}</p>
        <p>${training.terms}</p>
        ${equation("collapsed")}
        ${equation("posterior")}
        <p>${training.sums}</p>
      </section>
      <section class="panel">
        <h2>${steps.title}</h2>
        <ol class="works">${steps.list.map((step) => html`<li>${step}</li>`)}</ol>
      </section>
      <section class="panel">
        <h2>${rollout.title}</h2>
        <p>${rollout.text}</p>
        ${equation("rollout")}
        <p>${rollout.mean}</p>
      </section>
      <section class="panel">
        <h2>${readings.title}</h2>
        <p><strong>${readings.learned}</strong> ${readings.learnedText}</p>
        <p><strong>${readings.inferred}</strong> ${readings.inferredText}</p>
        <button class="small" @click=${() => this.tell("show-place", "reading")}>${readings.choose}</button>
      </section>`;
  }

  #others() {
    const { others, table } = methodWords();
    return html`
      <section class="panel">
        <h2>${others.title}</h2>
        ${modelTable(table)}
        <p>${withTerms(others.tmp)}</p>
        ${equation("tmp")}
        <p>${withTerms(others.dmp)}</p>
        ${equation("dmp")}
        <p>${withTerms(others.map)}</p>
        ${equation("map")}
        <h3>${others.score}</h3>
        <p>${others.scoreText}</p>
        ${equation("score")}
      </section>`;
  }

  #symbol(row: SymbolRow) {
    const { symbols } = methodWords();
    const { symbol, place } = row;
    return html`
      <tr><td>${unsafeHTML(SYMBOLS[symbol])}</td><th scope="row">${symbols.meaning[symbol]}</th>
        <td>${
          place === null
            ? html`<small>${symbols.notShown}</small>`
            : html`<button class="small" data-place=${place} @click=${() => this.tell("show-place", place)}>${symbols.there[row.symbol]}</button>`
        }</td></tr>`;
  }

  #symbols() {
    const { symbols } = methodWords();
    return html`
      <section class="panel">
        <h2>${symbols.title}</h2>
        <div class="table-box" tabindex="0" role="region" aria-label=${symbols.label}>
          <table class="symbols">
            <thead class="hint"><tr>${symbols.heads.map((head) => html`<th scope="col">${head}</th>`)}</tr></thead>
            <tbody>${SYMBOL_ROWS.map((row) => this.#symbol(row))}</tbody>
          </table>
        </div>
      </section>`;
  }

  #references() {
    const words = methodWords().references;
    const save = () => download("vcgpdm.bib", new Blob([papers], { type: "text/plain" }));
    return html`
      <section class="panel">
        <h2>${words.title}</h2>
        <ol class="works" lang="en">${WORKS.map(
          ({ words, doi }) =>
            html`<li>${words} ${doi ? html`<a href="https://doi.org/${doi}">${`doi:${doi}`}</a>` : nothing}</li>`,
        )}</ol>
        <h3>${words.cite}</h3>
        <pre class="bibtex note" tabindex="0" role="region" lang="en" aria-label=${BIBTEX} data-testid="bibtex">${papers}</pre>
        <button class="small" data-testid="save-bibtex" @click=${save}>${words.save}</button>
      </section>`;
  }

  protected override render() {
    return html`<div class="method">${this.#model()}${this.#others()}${this.#symbols()}${this.#references()}
      <p><button @click=${() => this.tell("show-place", "stage")}>${methodWords().back}</button></p></div>`;
  }
}
customElements.define("pg-method", MethodPage);

export const draw: Draw<"method"> = () => html`<pg-method></pg-method>`;
