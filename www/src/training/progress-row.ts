// The button, the status text and the progress bar of a training in its own view.
import { html } from "lit";
import { sentence } from "../ui/format";
import { progressBar } from "../ui/progress-bar";
import type { ProgressStore } from "./progress-store";
import { lab } from "../words/lab";
import { restOf } from "./runs";
import { timeLeft } from "./words";

type Progress = Pick<
  ProgressStore<unknown>,
  "status" | "busy" | "iteration" | "elapsed" | "fraction" | "ending" | "cancel"
>;

/** The status of a training as a list of phrases; empty when no training runs. */
export function goingWords({ status, iteration, elapsed, fraction }: Progress): string[] {
  if (status === "idle") return [];
  const words = lab().learn.training;
  if (status === "cancelling") return [words.stopping];
  if (iteration === 0) return [words.settingUp];
  return [
    words.iteration(iteration),
    sentence(timeLeft(restOf([{ state: "running", elapsed, fraction }], 1))),
  ];
}

export interface ProgressRow {
  progress: Progress;
  /** "Train", "Training", "Trained". */
  verb: [now: string, going: string, done: string];
  /** Test ids: of the idle button, of the busy one, and of the status text. */
  testIds: [start: string, cancel: string, words: string];
  /** Why the training cannot begin; empty when it can. */
  whyNot: string;
  /** What the training would do. */
  hint: string;
  start(): void;
}

/** One button for both actions, so that it keeps the focus. */
export function progressRow({
  progress,
  verb: [now, going, done],
  testIds,
  whyNot,
  hint,
  start,
}: ProgressRow) {
  const { status, busy, fraction, ending } = progress;
  const words = () => {
    if (busy) return goingWords(progress).map((words) => html`<span>${words}</span>`);
    if (ending.failed) return html`<span class="bad">${sentence(ending.words)}</span>`;
    if (ending.words) return `${done}. ${sentence(ending.words)}`;
    return whyNot || hint;
  };
  return html`
    <div class="train-row row wrap">
      <button class="primary big" data-testid=${testIds[busy ? 1 : 0]} title=${busy ? lab().learn.training.stopsHere : whyNot}
        ?disabled=${busy ? status === "cancelling" : whyNot !== ""} @click=${() => (busy ? progress.cancel() : start())}>${busy ? lab().learn.training.cancel : now}</button>
      <p class="hint words" data-testid=${testIds[2]}>${words()}</p>
    </div>
    ${progressBar(going, busy ? fraction : null)}
    <div class="visually-hidden" role="status">${busy ? lab().learn.training.goingShare(going, Math.floor(fraction * 10) * 10) : ""}</div>`;
}
