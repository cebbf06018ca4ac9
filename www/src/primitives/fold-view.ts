// One fold of the experiment: the trial held out, the progress of its two trainings, and their errors
// compared
// with the measured ones.
import { html, nothing } from "lit";
import type { ModularityOutcome } from "../engine/library-protocol";
import type { ProgressStore } from "../training/progress-store";
import { goingWords } from "../training/progress-row";
import { grouped, sentence } from "../ui/format";
import { progressBar } from "../ui/progress-bar";
import { View } from "../ui/view";
import type { FoldOutcome, FoldStore } from "./fold-store";
import { LESSON_TABLES } from "./lesson-tables";

/** The columns of the stored table with the mean errors of a model alone and of a library. */
const ALONE = 2;
const LIBRARY = 3;

const thousandths = ({ score }: ModularityOutcome) => grouped(1000 * score.dtwMse, 3);

export class FoldView extends View {
  declare fold: FoldStore;

  protected override stores() {
    return [this.fold];
  }

  #progress(words: string, progress: ProgressStore<ModularityOutcome>) {
    const { busy, fraction } = progress;
    return html`
      <div class="fold-training">
        <p class="hint">${words} ${busy ? goingWords(progress).map((going) => html`<span>${sentence(going)}</span> `) : "Over."}</p>
        ${progressBar(words, busy ? fraction : 1)}
      </div>`;
  }

  /** The progress of the trainings, or the reason why there is no result. */
  #course() {
    const { library, alone, busy } = this.fold;
    const begun = [library, alone].filter(({ status, ending }) => status !== "idle" || ending.words !== "");
    if (begun.length === 0) return nothing;
    if (busy)
      return [
        this.#progress("Library of both movements.", library),
        this.#progress("Model of its movement alone.", alone),
      ];
    const failed = begun.find(({ ending }) => ending.failed);
    return failed
      ? html`<p class="bad" role="alert">${sentence(failed.ending.words)}</p>`
      : html`<p class="hint">You cancelled: there is nothing to compare.</p>`;
  }

  #outcome({ trial, quick, library, alone }: FoldOutcome) {
    const measured = LESSON_TABLES.modular.rows.find(([movement]) => movement === library.movement) ?? [];
    const row = (words: string, outcome: ModularityOutcome, place: number) => html`
      <tr><th scope="row">${words}</th><td>${thousandths(outcome)}</td><td>${measured[place]}</td></tr>`;
    return html`
      <div class="table-box" role="region" tabindex="0" aria-label="One trial held out"><table class="lesson" data-testid="fold-outcome">
        <thead><tr><th scope="col">DTW MSE × 1,000</th><th scope="col">${trial.title}, here</th>
          <th scope="col">all ${measured[1]} trials, measured</th></tr></thead>
        <tbody>${row("alone", alone, ALONE)}${row("library", library, LIBRARY)}</tbody>
      </table></div>
      <p>This is one fold of ${this.fold.trials.length}: which model is better cannot be said from it.
        ${quick ? "With a tenth of the iterations the errors are not those of the table." : nothing}</p>`;
  }

  protected override render() {
    const { fold } = this;
    const { busy, trial, outcome } = fold;
    return html`
      <h3>Hold a trial out here</h3>
      <p class="hint">A library is trained on all other trials of both movements, and a model on those of the trial’s own movement; both also see its first
        five frames, and predict the rest. Of two seeds the one of the higher bound counts.</p>
      <div class="train-row">
        <label>Trial <select data-testid="fold-trial" ?disabled=${busy} @change=${(event: Event) => fold.choose((event.target as HTMLSelectElement).value)}>
          ${fold.trials.map(({ id, title }) => html`<option value=${id} ?selected=${id === trial?.id}>${title}</option>`)}
        </select></label>
        <label><input type="checkbox" data-testid="fold-quick" .checked=${fold.quick} ?disabled=${busy}
          @change=${(event: Event) => fold.setQuick((event.target as HTMLInputElement).checked)} /> a tenth of the iterations, for a first look</label>
        <button class="primary small" data-testid=${busy ? "fold-cancel" : "fold-start"} ?disabled=${busy ? fold.stopping : trial === null}
          @click=${() => (busy ? fold.cancel() : void fold.holdOut())}>${busy ? "Cancel" : "Hold it out"}</button>
      </div>
      ${outcome ? this.#outcome(outcome) : this.#course()}
      <div class="visually-hidden" role="status">${busy ? "A trial is held out" : outcome ? "The errors are there" : ""}</div>`;
  }
}
customElements.define("pg-fold", FoldView);
