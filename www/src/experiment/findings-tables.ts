// Tables of the findings: the couplings, and how well the model explains the data.
import { html, nothing } from "lit";
import "../terms/term";
import { grouped, sentence, short, weight } from "../ui/format";
import { type ExperimentRun, headline, isFound, readings } from "./experiments";
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
