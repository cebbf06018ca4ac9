// The table of the findings of each seed.
import { html, nothing } from "lit";
import { grouped, short } from "../ui/format";
import { type ExperimentRun, inOrder, isFound } from "./experiments";
import { percent, ratio } from "../figures/numbers";
import { endingOf } from "./ending";

/** Whether the truth was found, or the progress of the training. */
function answer(run: ExperimentRun) {
  const { state, findings, fraction, seed } = run;
  switch (state) {
    case "waiting":
      return "waiting";
    case "running":
      return html`<progress max="1" .value=${fraction} aria-label="Training of seed ${seed}"></progress>`;
    case "failed":
      return html`<span class="bad" title=${endingOf(run)}>failed</span>`;
    case "cancelled":
      return html`<span title=${endingOf(run)}>stopped early</span>`;
    case "done":
      return findings && isFound(findings) ? "yes" : html`<strong class="bad">no</strong>`;
  }
}

function row(run: ExperimentRun, shown: ExperimentRun | null, show: (run: ExperimentRun) => void) {
  const { seed, driving, iteration, findings } = run;
  const answered = (value: number, right: boolean) =>
    right ? ratio(value) : html`<strong class="bad">${ratio(value)}</strong>`;
  const course = (start: string, now: string) => html`${start} <span aria-label="to">→</span> ${now}`;
  return html`
    <tr data-testid="experiment-run" data-state=${run.state} class=${run === shown ? "chosen" : ""}>
      <th scope="row"><button class="seed-link" aria-pressed=${run === shown ? "true" : "false"} title="Look at this one"
        aria-label="Look at seed ${seed}${driving ? "" : " without driving"}" @click=${() => show(run)}>${seed}</button></th>
      <td>${driving ? "yes" : "no"}</td>
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
  return html`
    <div class="table-box" tabindex="0" role="region" aria-label="What each seed found">
      <table class="experiment-runs" data-testid="experiment-runs">
        <thead><tr>
          <th scope="col">Seed</th>
          <th scope="col" title="Whether part 1 drives part 2">1 drives 2</th>
          <th scope="col">Found</th>
          <th scope="col" title="α from 2 to 1, in units of α from 1 to 1">α 2→1 : 1→1</th>
          <th scope="col" title="α from 1 to 2, in units of α from 2 to 2">α 1→2 : 2→2</th>
          <th scope="col">Bound</th>
          <th scope="col" title="Mean squared error of the rollout">MSE</th>
          <th scope="col" title="Share of the true latents of part 1 and of part 2 that the learned ones explain">Latents explained</th>
          <th scope="col">Iterations</th>
        </tr></thead>
        <tbody>${inOrder(runs).map((run) => row(run, shown, show))}</tbody>
      </table>
    </div>`;
}
