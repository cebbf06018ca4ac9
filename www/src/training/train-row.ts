// The button that trains, or cancels, with a progress bar and words: the plan, the progress or the end.
import { html, nothing } from "lit";
import type { ClipsStore } from "../clips/clips-store";
import { sentence } from "../ui/format";
import { progressBar } from "../ui/progress-bar";
import { View } from "../ui/view";
import { isOver, secondsLeft, share } from "./runs";
import type { TrainingStore } from "./training-store";
import { lab } from "../words/lab";
import { timeLeft } from "./words";

export class TrainRow extends View {
  declare training: TrainingStore;
  declare clips: ClipsStore;

  /** The status next to the button: the plan, the progress or the end. */
  #words(why: string) {
    const { training } = this;
    const { asked, busy, ending } = training;
    const words = lab().learn.training;
    const last = asked.length === 1 ? asked[0]?.steps.at(-1) : undefined;
    const iteration = last
      ? html`<span>${words.iterationOf(last.iteration, last.maxIterations)}${busy ? "" : "."}</span>`
      : nothing;
    if (busy) {
      if (asked.every(({ steps }) => steps.length === 0)) return html`<span>${words.settingUp}</span>`;
      if (asked.some(({ catchingUp }) => catchingUp)) return html`<span>${words.catchingUp}</span>`;
      const done =
        asked.length > 1
          ? html`<span>${words.done(asked.filter(isOver).length, asked.length)}</span>`
          : iteration;
      const left = asked.filter((run) => !isOver(run));
      const watches = left.length > 0 && left.every(({ steps }) => steps.at(-1)?.phase === "own-rollouts");
      return html`${watches ? html`<span>${sentence(lab().learn.phases["own-rollouts"])}</span>` : done}<span>${sentence(timeLeft(secondsLeft(asked, training.workers)))}</span>`;
    }
    if (why) return sentence(why);
    if (ending.failed) return html`<span class="bad">${sentence(words.failed(ending.words))}</span>`;
    if (ending.words) return html`${iteration}<span>${sentence(ending.words)}</span>`;
    const { ticked } = this.clips;
    const made = ticked.every(({ origin }) => origin === "made");
    const of = words.newModels(training.count, ticked.length, made);
    const { cost } = training;
    return cost.words
      ? html`${of} <span class=${cost.absurd ? "bad" : ""} data-testid="cost">${cost.words}</span>`
      : of;
  }

  /** For a run on the stage that stopped before its bound had settled. */
  #continueButton() {
    const { training } = this;
    const run = training.charted;
    if (!run || !training.canContinue(run)) return nothing;
    const more = training.moreIterations(run);
    const words = lab().learn.training;
    return html`<button data-testid="continue" title=${words.continueMeaning(run.settings.seed, more)}
      @click=${() => void training.continue(run)}>${words.continue(more)}</button>`;
  }

  /** Screen readers read the state, not each iteration. */
  #announcement(): string {
    const { status, asked, ending } = this.training;
    const words = lab().learn.training;
    if (status === "running") {
      const done = Math.floor(share(asked) * 10) * 10;
      return asked.some(({ steps }) => steps.length > 0) ? words.share(done) : words.started;
    }
    if (status === "cancelling") return words.cancelling;
    return ending.words ? words.ended(sentence(ending.words)) : "";
  }

  protected override render() {
    const { training } = this;
    const { busy } = training;
    const cancelling = training.status === "cancelling";
    const why = training.whyNot();
    const { training: words } = lab().learn;
    return html`
      <div class="train-row row wrap">
        ${
          busy
            ? html`<button class="primary" data-testid="cancel" ?disabled=${cancelling}
              title=${words.cancelMeaning} @click=${() => training.cancel()}>${words.cancel}</button>
              <button data-testid="add" ?disabled=${cancelling}
              title=${words.addMeaning} @click=${() => void training.start()}>${words.add}</button>`
            : html`<button class="primary" data-testid="train" ?disabled=${why !== ""} aria-describedby="train-why"
              @click=${() => void training.start()}>${words.train}</button>
              ${this.#continueButton()}`
        }
        <p id="train-why" class="hint words" data-testid="progress">${this.#words(why)}</p>
      </div>
      ${progressBar(words.title, busy ? share(training.asked) : null)}
      <div class="visually-hidden" role="status" aria-live="polite">${this.#announcement()}</div>`;
  }
}
customElements.define("pg-train", TrainRow);
