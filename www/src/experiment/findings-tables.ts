// Tables of the findings: the couplings, how well the model explains the data, and the findings of each seed.
import { html, nothing } from "lit";
import "../terms/term";
import { grouped, sentence, short, weight } from "../ui/format";
import { percent, ratio } from "../figures/numbers";
import { endingWords } from "../training/words";
import { type ExperimentRun, headline, inOrder, isFound, readings } from "./experiments";
import { partColour } from "../ui/palette";
import type { SyntheticFindings, SyntheticTruth } from "../engine/whole-protocol";
import { partStyle } from "../ui/styled";
import { experimentWords } from "./view-words";

const PARTS = [0, 1];

const partName = (part: number) =>
  html`<span class="part-name" style=${partStyle(partColour(part))}><i class="swatch"></i>${experimentWords().part(part + 1)}</span>`;

/** alpha and w of each source (row) and target (column). */
export function alphaTable(findings: SyntheticFindings | null) {
  const words = experimentWords().couplings;
  const cell = (source: number, target: number) => {
    const alpha = findings?.alpha[source]?.[target];
    const w = findings?.weights[source]?.[target];
    return html`
      <td style=${partStyle(partColour(source), { "--w": (w ?? 0).toFixed(4) })}>
        <span class="share" aria-hidden="true"></span>
        <div class="numbers">
          <span><i>α</i> <output data-testid="experiment-alpha-${source}-${target}">${alpha === undefined ? "–" : short(alpha)}</output></span>
          <span><i>w</i> <output data-testid="experiment-weight-${source}-${target}">${w === undefined ? "–" : weight(w)}</output></span>
        </div>
      </td>`;
  };
  return html`
    <table class="alphas tabular">
      <caption class="visually-hidden">${words.label}</caption>
      <thead><tr><td><pg-term of="alpha" text="α"></pg-term>, <pg-term of="weight" text="w"></pg-term></td>${PARTS.map((target) => html`<th scope="col"><small>${words.predicts}</small> ${partName(target)}</th>`)}</tr></thead>
      <tbody>${PARTS.map(
        (source) => html`
        <tr><th scope="row">${partName(source)}</th>${PARTS.map((target) => cell(source, target))}</tr>`,
      )}
      </tbody>
    </table>`;
}

/** Bound and error, at the start of training and now. */
export function fitTable(run: ExperimentRun | null) {
  const { start, now } = run?.findings ?? {};
  const words = experimentWords().fit;
  const end = run?.state === "done" ? words.end : words.now;
  return html`
    <table class="fits tabular">
      <caption class="visually-hidden">${words.label}</caption>
      <thead class="hint"><tr><td></td><th scope="col">${words.start}</th><th scope="col">${end}</th></tr></thead>
      <tbody>
        <tr><th scope="row" title=${words.boundMeaning}><pg-term of="bound" text=${words.bound}></pg-term></th>
          <td>${start ? grouped(start.bound) : "–"}</td><td data-testid="experiment-bound">${now ? grouped(now.bound) : "–"}</td></tr>
        <tr><th scope="row" title=${words.mseMeaning}><pg-term of="dtw" text="MSE"></pg-term></th>
          <td>${start ? short(start.mse) : "–"}</td><td data-testid="experiment-mse">${now ? short(now.mse) : "–"}</td></tr>
      </tbody>
    </table>`;
}

/** The sentences about the result. */
export function verdictWords(run: ExperimentRun | null, truth: SyntheticTruth | null) {
  const { verdict: words, failed } = experimentWords();
  if (run?.state === "failed") return html`<p class="bad">${sentence(failed(run.ending))}</p>`;
  if (!run?.findings || !truth) return html`<p class="empty">${run ? words.begins : words.press}</p>`;
  const { findings, driving, state, iteration } = run;
  const soFar =
    state === "done"
      ? nothing
      : html`<small>${(state === "cancelled" ? words.stopped : words.soFar)(grouped(iteration))}</small>`;
  return html`
    <div class="verdict">
      <p class="headline ${isFound(findings) ? "" : "bad"}" data-testid="experiment-verdict">${headline(findings, driving)} ${soFar}</p>
      <ul>${readings(findings, truth).map(({ words: said, right }) => html`<li class=${right ? "" : "bad"}>${said}</li>`)}</ul>
    </div>`;
}

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
          <td>${findings.model.explained.map(percent).join(", ")}</td>
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
