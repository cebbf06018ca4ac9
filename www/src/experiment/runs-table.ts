// The table of the findings of each seed.
import { html, nothing } from "lit";
import { grouped, short } from "../ui/format";
import { type ExperimentRun, inOrder, isFound } from "./experiments";
import { percent, ratio } from "../figures/numbers";
import { experimentWords } from "./view-words";
import { endingWords } from "../training/words";

/** Empty before the end. */
export const endingOf = ({ outcome, ending }: ExperimentRun): string =>
  outcome ? endingWords(outcome) : ending;

/** Whether the truth was found, or the progress of the training. */
function answer(run: ExperimentRun) {
  const { state, findings, fraction, seed } = run;
  const words = experimentWords().runs;
  switch (state) {
    case "waiting":
      return words.waiting;
    case "running":
      return html`<progress max="1" .value=${fraction} aria-label=${words.progress(seed)}></progress>`;
    case "failed":
      return html`<span class="bad" title=${endingOf(run)}>${words.failed}</span>`;
    case "cancelled":
      return html`<span title=${endingOf(run)}>${words.stopped}</span>`;
    case "done":
      return findings && isFound(findings) ? words.yes : html`<strong class="bad">${words.no}</strong>`;
  }
}

function row(run: ExperimentRun, shown: ExperimentRun | null, show: (run: ExperimentRun) => void) {
  const { seed, driving, iteration, findings } = run;
  const words = experimentWords().runs;
  const answered = (value: number, right: boolean) =>
    right ? ratio(value) : html`<strong class="bad">${ratio(value)}</strong>`;
  const course = (start: string, now: string) => html`${start} <span aria-label=${words.to}>→</span> ${now}`;
  return html`
    <tr data-testid="experiment-run" data-state=${run.state} class=${run === shown ? "chosen" : ""}>
      <th scope="row"><button class="seed-link" aria-pressed=${run === shown ? "true" : "false"} title=${words.look}
        aria-label=${words.lookAt(seed, driving)} @click=${() => show(run)}>${seed}</button></th>
      <td>${driving ? words.yes : words.no}</td>
      <td class="answer">${answer(run)}</td>
      ${
        findings
          ? html`
          <td>${answered(findings.verdict.back, findings.verdict.backIsRight)}</td>
          <td>${answered(findings.verdict.forth, findings.verdict.forthIsRight)}</td>
          <td>${course(grouped(findings.start.bound), grouped(findings.now.bound))}</td>
          <td>${course(short(findings.start.mse), short(findings.now.mse))}</td>
          <td>${findings.explained.map(percent).join(", ")}</td>
          <td>${grouped(iteration)}</td>`
          : html`<td colspan="6"></td>`
      }
    </tr>`;
}

export function runsTable(
  runs: readonly ExperimentRun[],
  shown: ExperimentRun | null,
  show: (run: ExperimentRun) => void,
) {
  if (runs.length === 0) return nothing;
  const { label, heads } = experimentWords().runs;
  return html`
    <div class="table-box" tabindex="0" role="region" aria-label=${label}>
      <table class="experiment-runs tabular note" data-testid="experiment-runs">
        <thead class="quiet"><tr>
          <th scope="col">${heads.seed}</th>
          <th scope="col" title=${heads.drivingMeaning}>${heads.driving}</th>
          <th scope="col">${heads.found}</th>
          <th scope="col" title=${heads.back}>α 2→1 : 1→1</th>
          <th scope="col" title=${heads.forth}>α 1→2 : 2→2</th>
          <th scope="col">${heads.bound}</th>
          <th scope="col" title=${heads.mse}>MSE</th>
          <th scope="col" title=${heads.explainedMeaning}>${heads.explained}</th>
          <th scope="col">${heads.iterations}</th>
        </tr></thead>
        <tbody>${inOrder(runs).map((run) => row(run, shown, show))}</tbody>
      </table>
    </div>`;
}
