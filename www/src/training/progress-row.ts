// The button, the status text and the progress bar of a training in its own view.
import { html } from "lit";
import { sentence, timeLeft } from "../ui/format";
import { progressBar } from "../ui/progress-bar";
import type { ProgressStore } from "./progress-store";
import { restOf } from "./runs";

type Progress = Pick<
  ProgressStore<unknown>,
  "status" | "busy" | "iteration" | "elapsed" | "fraction" | "ending" | "cancel"
>;

/** The status of a training as a list of phrases; empty when no training runs. */
export function goingWords({ status, iteration, elapsed, fraction }: Progress): string[] {
  if (status === "idle") return [];
  if (status === "cancelling") return ["Stopping"];
  if (iteration === 0) return ["Setting up"];
  return [`Iteration ${iteration}`, sentence(timeLeft(restOf([{ state: "running", elapsed, fraction }], 1)))];
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
    <div class="train-row">
      <button class="primary big" data-testid=${testIds[busy ? 1 : 0]} title=${busy ? "Stops here and keeps the best so far" : whyNot}
        ?disabled=${busy ? status === "cancelling" : whyNot !== ""} @click=${() => (busy ? progress.cancel() : start())}>${busy ? "Cancel" : now}</button>
      <p class="hint words" data-testid=${testIds[2]}>${words()}</p>
    </div>
    ${progressBar(going, busy ? fraction : null)}
    <div class="visually-hidden" role="status">${busy ? `${going}, ${Math.floor(fraction * 10) * 10} per cent done` : ""}</div>`;
}
