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
import { lessonTables } from "./lesson-tables";
import { lab } from "../words/lab";
import { primitivesWords } from "../words/primitives";

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
    const texts = primitivesWords().fold;
    return html`
      <div class="fold-training">
        <p class="hint">${words} ${busy ? goingWords(progress).map((going) => html`<span>${sentence(going)}</span> `) : texts.over}</p>
        ${progressBar(words, busy ? fraction : 1)}
      </div>`;
  }

  /** The progress of the trainings, or the reason why there is no result. */
  #course() {
    const { library, alone, busy } = this.fold;
    const words = primitivesWords().fold;
    const begun = [library, alone].filter(({ status, ending }) => status !== "idle" || ending.words !== "");
    if (begun.length === 0) return nothing;
    if (busy) return [this.#progress(words.library, library), this.#progress(words.alone, alone)];
    const failed = begun.find(({ ending }) => ending.failed);
    return failed
      ? html`<p class="bad" role="alert">${sentence(failed.ending.words)}</p>`
      : html`<p class="hint">${words.cancelled}</p>`;
  }

  #outcome({ trial, quick, library, alone }: FoldOutcome) {
    const words = primitivesWords().fold;
    const measured = lessonTables().modular.rows.find(([movement]) => movement === library.movement) ?? [];
    const row = (title: string, outcome: ModularityOutcome, place: number) => html`
      <tr><th scope="row">${title}</th><td>${thousandths(outcome)}</td><td>${measured[place]}</td></tr>`;
    return html`
      <div class="table-box" role="region" tabindex="0" aria-label=${words.label}><table class="lesson" data-testid="fold-outcome">
        <thead><tr>${words.heads(trial.title, measured[1] ?? "").map((head) => html`<th scope="col">${head}</th>`)}</tr></thead>
        <tbody>${row(words.rows.alone, alone, ALONE)}${row(words.rows.library, library, LIBRARY)}</tbody>
      </table></div>
      <p>${words.one(this.fold.trials.length)} ${quick ? words.quickErrors : nothing}</p>`;
  }

  protected override render() {
    const { fold } = this;
    const { busy, trial, outcome } = fold;
    const words = primitivesWords().fold;
    return html`
      <h3>${words.title}</h3>
      <p class="hint">${words.about}</p>
      <div class="train-row">
        <label>${words.trial} <select data-testid="fold-trial" ?disabled=${busy} @change=${(event: Event) => fold.choose((event.target as HTMLSelectElement).value)}>
          ${fold.trials.map(({ id, title }) => html`<option value=${id} ?selected=${id === trial?.id}>${title}</option>`)}
        </select></label>
        <label><input type="checkbox" data-testid="fold-quick" .checked=${fold.quick} ?disabled=${busy}
          @change=${(event: Event) => fold.setQuick((event.target as HTMLInputElement).checked)} /> ${words.quick}</label>
        <button class="primary small" data-testid=${busy ? "fold-cancel" : "fold-start"} ?disabled=${busy ? fold.stopping : trial === null}
          @click=${() => (busy ? fold.cancel() : void fold.holdOut())}>${busy ? lab().learn.training.cancel : words.start}</button>
      </div>
      ${outcome ? this.#outcome(outcome) : this.#course()}
      <div class="visually-hidden" role="status">${busy ? words.going : outcome ? words.there : ""}</div>`;
  }
}
customElements.define("pg-fold", FoldView);
