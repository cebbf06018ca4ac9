// The analysis of answers: the files, the excluded participants with reasons, and the figures.
import { html, nothing } from "lit";
import { LARGEST_FILE } from "../clips/clips-store";
import type { AnswersFile, Participant, PerceptionResults } from "../engine/whole-protocol";
import { percent, plain } from "../figures/numbers";
import type { SaveFailure } from "../figures/figure-element";
import { download } from "../ui/download";
import { fileButton } from "../ui/file-button";
import { messageOf, sentence } from "../ui/format";
import { icon } from "../ui/icons";
import type { NoticesStore } from "../ui/notices-store";
import "../terms/term";
import { View } from "../ui/view";
import type { AnalysisStore } from "./analysis-store";
import { csvFile } from "./answer-files";
import "./heat-maps";
import "./inducing-figure";
import "./pairwise-figure";
import { answered } from "./participation";
import type { PerceptionStore } from "./perception-store";
import "./rate-figures";
import "./score-figures";

/** The text of files of answers. Fails with the name of one that is too large. */
export const readAnswers = (files: readonly File[]): Promise<AnswersFile[]> =>
  Promise.all(
    files.map(async (file) => {
      if (file.size > LARGEST_FILE) throw new Error(`${file.name} has more than 200 MB; expected answers.`);
      return { name: file.name, text: await file.text() };
    }),
  );

/** The name of the answers from codes in the list of files. */
const CODES_FILE = "codes.csv";

const COLUMNS = ["Participant", "Answers", "Attention checks passed", "Median answer, s", "Left", "Counts"];

function participantRow(participant: Participant) {
  const { name, comparisons, unanswered, attentionChecks, attentionHits, excluded, left, medianRt } =
    participant;
  return html`
    <tr class=${excluded ? "left-out" : ""} data-testid="analysed">
      <th scope="row">${name}</th>
      <td>${comparisons}${unanswered > 0 ? html` <small>${unanswered} not answered</small>` : nothing}</td>
      <td>${attentionChecks > 0 ? `${attentionHits} of ${attentionChecks}` : "none shown"}</td>
      <td>${medianRt === null ? "–" : plain(medianRt / 1000)}</td>
      <td>${left === null ? "–" : percent(left)}</td>
      <td>${excluded ? html`<strong>left out</strong>` : "yes"}</td>
    </tr>`;
}

/**
 * One sentence: the counted answers and participants, and how often a generated movement passed for natural.
 */
function countWords({ participants, all, options }: PerceptionResults): string {
  const out = participants.filter(({ excluded }) => excluded).length;
  const counted = participants.length - out;
  const people = `${counted} ${counted === 1 ? "participant" : "participants"}`;
  const excluded =
    out > 0 ? ` ${out} left out, below ${percent(options.attention)} of the attention checks.` : "";
  return `${all.trials} answers of ${people}: the model’s movement was taken for the natural one in ${percent(all.hits / all.trials)}.${excluded}`;
}

function catchWords({ catch: caught }: PerceptionResults) {
  if (!caught) return nothing;
  const { confusion, isHalf } = caught;
  return html`Of ${confusion.trials} <pg-term of="catch-trial" text="catch trials"></pg-term> the movement not seen before won ${confusion.hits}: with probability ${plain(isHalf)} nobody knew the others by heart.`;
}

function neededWords({ needed: { toTell, forPrecision } }: PerceptionResults): string {
  if (toTell === null || forPrecision === null) return "";
  return `A setting needs ${toTell} answers to tell a rate 0.1 away from one half (power 0.8), and ${forPrecision} to know that it is within 0.05 of it.`;
}

export class AnalysisView extends View {
  declare analysis: AnalysisStore;
  declare perception: PerceptionStore;
  declare notices: NoticesStore;

  protected override stores() {
    return [this.analysis, this.perception];
  }

  async #open(files: readonly File[]): Promise<void> {
    const { study } = this.perception;
    try {
      if (study) await this.analysis.add(study.text, await readAnswers(files));
    } catch (problem) {
      this.notices.addError("The answers were not opened", messageOf(problem));
    }
  }

  /** The participations on this machine with answers to the open study. */
  #here() {
    const { participations, study } = this.perception;
    return participations.filter(
      (participation) => participation.study === study?.info.hash && answered(participation) > 0,
    );
  }

  /** Adds the answers of the pasted codes; they replace the codes before. */
  async #addCodes(): Promise<void> {
    const { study } = this.perception;
    const text = this.querySelector<HTMLTextAreaElement>("[data-testid=codes]")?.value ?? "";
    try {
      const participations = await this.perception.fromCodes(text);
      if (!study || participations.length === 0) return;
      await this.analysis.add(study.text, [{ name: CODES_FILE, text: csvFile(participations).text }]);
    } catch (problem) {
      this.notices.addError("The codes were not read", sentence(messageOf(problem)));
    }
  }

  #analyseHere(): void {
    const { study } = this.perception;
    const files = this.#here().map((participation) => csvFile([participation]));
    if (study) void this.analysis.analyse(study.text, files);
  }

  async #save(): Promise<void> {
    const { study } = this.perception;
    try {
      if (!study) return;
      const text = await this.analysis.json(study.text);
      download("perception.results.json", new Blob([text], { type: "application/json" }));
    } catch (problem) {
      this.notices.addError("The results were not saved", messageOf(problem));
    }
  }

  #files() {
    const { analysis, perception } = this;
    const { study } = perception;
    const here = this.#here().length;
    return html`
      <div class="files">
        <button class="small" data-testid="analyse-here" ?disabled=${here === 0 || analysis.busy} @click=${() => this.#analyseHere()}>Analyse those on this machine</button>
        ${fileButton({
          label: "Open answers",
          meaning: "Open the answers (.csv or .json) of one or more participants",
          testId: "open-answers",
          accept: ".csv,.json,text/csv,application/json",
          multiple: true,
          disabled: study === null,
          chosen: (files) => void this.#open(files),
        })}
        <button class="small" data-testid="save-analysis" ?disabled=${analysis.results === null || analysis.busy} @click=${() => void this.#save()}>${icon("save")} Save results</button>
      </div>
      <details class="advanced">
        <summary>Codes of a class</summary>
        <label class="field wide"><span>One code in each line</span>
          <textarea rows="4" data-testid="codes" spellcheck="false" autocomplete="off"></textarea></label>
        <button class="small" data-testid="add-codes" ?disabled=${study === null || analysis.busy} @click=${() => void this.#addCodes()}>Analyse the codes</button>
      </details>
      ${
        analysis.files.length > 0
          ? html`<ul class="answer-files" aria-label="Files">${analysis.files.map(
              ({ name }) => html`
              <li>${name} <button class="round" aria-label="Leave out ${name}" title="Leave out" @click=${() => study && void analysis.remove(study.text, name)}>${icon("close")}</button></li>`,
            )}</ul>`
          : nothing
      }`;
  }

  #results(results: PerceptionResults) {
    const failed = ({ detail }: CustomEvent<SaveFailure>) =>
      this.notices.addError(`${detail.name} was not saved`, detail.message);
    return html`
      <p data-testid="analysis-words">${countWords(results)} ${catchWords(results)}</p>
      <p class="hint">${neededWords(results)}</p>
      <details class="advanced" ?open=${results.participants.some(({ excluded }) => excluded)}>
        <summary>Participants</summary>
        <div class="table-box" tabindex="0" role="region" aria-label="Participants of the analysis">
          <table class="participants">
            <thead><tr>${COLUMNS.map((title) => html`<th scope="col">${title}</th>`)}</tr></thead>
            <tbody>${results.participants.map(participantRow)}</tbody>
          </table>
        </div>
      </details>
      <div class="figures" @save-failed=${failed}>
        <perception-pairwise .data=${results}></perception-pairwise>
        <perception-all-models .data=${results}></perception-all-models>
        <perception-rates .data=${results}></perception-rates>
        <perception-maps .data=${results}></perception-maps>
        <perception-scores .data=${results}></perception-scores>
        <perception-inducing .data=${results}></perception-inducing>
      </div>`;
  }

  protected override render() {
    const { results, busy, problem } = this.analysis;
    return html`
      ${this.#files()}
      ${busy ? html`<p class="hint" role="status">Analysing</p>` : nothing}
      ${problem ? html`<p class="bad" role="alert" data-testid="analysis-problem">${sentence(problem)}</p>` : nothing}
      ${
        results
          ? this.#results(results)
          : html`<p class="empty">Drop the files of all participants here. The study that they answered must be open.</p>`
      }`;
  }
}
customElements.define("pg-perception-analysis", AnalysisView);
