// The experiment on shared primitives as a lesson: the question, the measured results, and one fold to try.
import { html } from "lit";
import { View } from "../ui/view";
import "./lesson.css";
import "../terms/term";
import type { FoldStore } from "./fold-store";
import "./fold-view";
import type { LearningStore } from "./learning-store";
import paths from "../../../docs/modularity.svg";
import { lessonTables, type Table } from "./lesson-tables";
import { primitivesWords } from "../words/primitives";

/** Makes the tables. */
const COMMAND = "npm run lab -- modularity";

/** The columns of the first table with errors, and with costs. */
const ERRORS = [0, 1, 2, 3, 4];
const COSTS = [0, 6, 7, 8, 9];

function table(
  { head, rows }: Table,
  label: string,
  columns: readonly number[] = head.map((_, column) => column),
) {
  return html`
    <div class="table-box" role="region" tabindex="0" aria-label=${label}><table class="lesson">
      <thead><tr>${columns.map((column) => html`<th scope="col">${head[column]}</th>`)}</tr></thead>
      <tbody>${rows.map(
        (row) =>
          html`<tr>${columns.map((column, place) => (place === 0 ? html`<th scope="row">${row[column]}</th>` : html`<td>${row[column]}</td>`))}</tr>`,
      )}</tbody>
    </table></div>`;
}

export class LessonView extends View {
  declare learning: LearningStore;
  declare fold: FoldStore;

  protected override stores() {
    return [this.learning];
  }

  protected override render() {
    const { learning } = this;
    const { lesson: words, learning: buttons } = primitivesWords();
    const [before, after] = words.method;
    const { modular, imports, combination } = lessonTables();
    return html`
      <h2>${words.title}</h2>
      <p>${words.question}</p>
      <p class="hint">${before} <code>${COMMAND}</code>${after}</p>
      ${table(modular, words.errors, ERRORS)}
      <p>${words.open}</p>
      ${table(modular, words.costs, COSTS)}
      <pg-fold .fold=${this.fold}></pg-fold>
      <figure class="lesson-paths">
        <img src=${paths} width="840" height="444" loading="lazy" alt=${words.paths} />
        <figcaption class="hint">${words.caption}</figcaption>
      </figure>
      <h3>${words.importTitle}</h3>
      <p>${words.importText}</p>
      ${table(imports, words.imports)}
      <p>${words.importFinding}</p>
      <h3>${words.combinationTitle}</h3>
      <p>${words.combinationText}</p>
      ${table(combination, words.combinations)}
      <p>${words.combinationFinding}</p>
      <div class="train-row">
        <button class="small" data-testid="lesson-try" ?disabled=${learning.busy} @click=${() => learning.chooseSamples(["lower"])}>${words.setUp}</button>
        <p class="hint">${words.setUpMeaning(buttons.learn)}</p>
      </div>`;
  }
}
customElements.define("pg-lesson", LessonView);
