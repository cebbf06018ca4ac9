// The experiment on shared primitives as a lesson: the question, the measured results, and one fold to try.
import { html } from "lit";
import { View } from "../ui/view";
import "./lesson.css";
import "../terms/term";
import type { FoldStore } from "./fold-store";
import "./fold-view";
import type { LearningStore } from "./learning-store";
import paths from "../../../docs/modularity.svg";
import { LESSON_TABLES, type Table } from "./lesson-tables";

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
    return html`
      <h2>Is a shared primitive as good as one of its own?</h2>
      <p>Velychko et al. (2018, figure 7) let walking and walking with waving share one primitive of the lower body, and ask whether each movement is
        predicted as well as by a model of its own. Their answer: equal within the standard errors.</p>
      <p class="hint">The same with the ten made trials of this project: one is held out, all others are trained on. Errors after time warping, times 1,000, with
        standard errors. Measured once, by <code>npm run lab -- modularity</code>; below, one trial can be held out in your browser.</p>
      ${table(LESSON_TABLES.modular, "A library compared with models of one movement", ERRORS)}
      <p>The intervals of the differences hold 0: which is better stays open on ten made trials.</p>
      ${table(LESSON_TABLES.modular, "The cost of a library compared with models of one movement", COSTS)}
      <pg-fold .fold=${this.fold}></pg-fold>
      <figure class="lesson-paths">
        <img src=${paths} width="840" height="444" loading="lazy" alt="Latent paths of the lower and the upper body, of walking and of walking with waving" />
        <figcaption class="hint">The latent paths of a library: generated (solid) and as trained (dashed).</figcaption>
      </figure>
      <h3>Primitives in another library</h3>
      <p>A primitive means nothing under the pose maps of another training: it is learned again there, from clips, from the latents that its file keeps, or
        from its own rollouts. Here walking moves into a library of walking with waving that has never seen a walk without it.</p>
      ${table(LESSON_TABLES.imports, "Walking learned again in another library")}
      <p>The legs lose nothing: the other library knows legs that walk. Most of how the arms of a walk are held is not among its poses, and what its
        pose maps do not show cannot come back, whatever the dynamics learn.</p>
      <div class="train-row">
        <button class="small" data-testid="lesson-try" ?disabled=${learning.busy} @click=${() => learning.chooseSamples(["lower"])}>Set the experiment up above</button>
        <p class="hint">All ten clips in two groups, the lower body the same: press <em>Learn</em>, and watch which combinations walk.</p>
      </div>`;
  }
}
customElements.define("pg-lesson", LessonView);
