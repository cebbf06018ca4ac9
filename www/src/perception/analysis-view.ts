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
import { withTerms } from "../terms/term";
import { View } from "../ui/view";
import type { AnalysisStore } from "./analysis-store";
import { csvFile } from "./answer-files";
import "./heat-maps";
import "./inducing-figure";
import "./pairwise-figure";
import { answered } from "./participation";
import { perceptionWords } from "./view-words";
import type { PerceptionStore } from "./perception-store";
import "./rate-figures";
import "./score-figures";

/** The text of files of answers. Fails with the name of one that is too large. */
export const readAnswers = (files: readonly File[]): Promise<AnswersFile[]> =>
  Promise.all(
    files.map(async (file) => {
      if (file.size > LARGEST_FILE) throw new Error(perceptionWords().analysis.tooLarge(file.name));
      return { name: file.name, text: await file.text() };
    }),
  );

/** The name of the answers from codes in the list of files. */
const CODES_FILE = "codes.csv";

function participantRow(participant: Participant) {
  const { name, comparisons, unanswered, attentionChecks, attentionHits, excluded, left, medianRt } =
    participant;
  const words = perceptionWords().analysis;
  return html`
    <tr class=${excluded ? "left-out" : ""} data-testid="analysed">
      <th scope="row">${name}</th>
      <td>${comparisons}${unanswered > 0 ? html` <small>${words.unanswered(unanswered)}</small>` : nothing}</td>
      <td>${attentionChecks > 0 ? words.of(attentionHits, attentionChecks) : words.noneShown}</td>
      <td>${medianRt === null ? "–" : plain(medianRt / 1000)}</td>
      <td>${left === null ? "–" : percent(left)}</td>
      <td>${excluded ? html`<strong>${words.leftOut}</strong>` : words.counts}</td>
    </tr>`;
}

/**
 * One sentence: the counted answers and participants, and how often a generated movement passed for natural.
 */
function countWords({ participants, all, options }: PerceptionResults): string {
  const out = participants.filter(({ excluded }) => excluded).length;
  const counted = participants.length - out;
  const words = perceptionWords().analysis;
  const excluded = out > 0 ? words.excluded(out, percent(options.attention)) : "";
  return `${words.count(all.trials, counted, percent(all.hits / all.trials))}${excluded}`;
}

function catchWords({ catch: caught }: PerceptionResults) {
  if (!caught) return nothing;
  const { confusion, isHalf } = caught;
  return withTerms(perceptionWords().analysis.caught(confusion.trials, confusion.hits, plain(isHalf)));
}

function neededWords({ needed: { toTell, forPrecision } }: PerceptionResults): string {
  if (toTell === null || forPrecision === null) return "";
  return perceptionWords().analysis.needed(toTell, forPrecision);
}

export class AnalysisView extends View {
  declare analysis: AnalysisStore;
  declare perception: PerceptionStore;
  declare notices: NoticesStore;

  async #open(files: readonly File[]): Promise<void> {
    const { study } = this.perception;
    try {
      if (study) await this.analysis.add(study.text, await readAnswers(files));
    } catch (problem) {
      this.notices.addError(perceptionWords().analysis.notOpened, messageOf(problem));
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
      this.notices.addError(perceptionWords().codes.notRead, sentence(messageOf(problem)));
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
      this.notices.addError(perceptionWords().analysis.notSaved, messageOf(problem));
    }
  }

  #files() {
    const { analysis, perception } = this;
    const { study } = perception;
    const here = this.#here().length;
    const { analysis: words, codes } = perceptionWords();
    return html`
      <div class="files wrap tight">
        <button class="small" data-testid="analyse-here" ?disabled=${here === 0 || analysis.busy} @click=${() => this.#analyseHere()}>${words.here}</button>
        ${fileButton({
          label: words.open,
          meaning: words.openMeaning,
          testId: "open-answers",
          accept: ".csv,.json,text/csv,application/json",
          multiple: true,
          disabled: study === null,
          chosen: (files) => void this.#open(files),
        })}
        <button class="small" data-testid="save-analysis" ?disabled=${analysis.results === null || analysis.busy} @click=${() => void this.#save()}>${icon("save")} ${words.save}</button>
      </div>
      <details class="advanced">
        <summary>${codes.title}</summary>
        <label class="field stack wide"><span>${codes.label}</span>
          <textarea rows="4" data-testid="codes" spellcheck="false" autocomplete="off"></textarea></label>
        <button class="small" data-testid="add-codes" ?disabled=${study === null || analysis.busy} @click=${() => void this.#addCodes()}>${codes.analyse}</button>
      </details>
      ${
        analysis.files.length > 0
          ? html`<ul class="answer-files wrap" aria-label=${words.files}>${analysis.files.map(
              ({ name }) => html`
              <li>${name} <button class="round" aria-label=${words.leaveOutOf(name)} title=${words.leaveOut} @click=${() => study && void analysis.remove(study.text, name)}>${icon("close")}</button></li>`,
            )}</ul>`
          : nothing
      }`;
  }

  #results(results: PerceptionResults) {
    const words = perceptionWords().analysis;
    const failed = ({ detail }: CustomEvent<SaveFailure>) =>
      this.notices.addError(words.fileNotSaved(detail.name), detail.message);
    return html`
      <p data-testid="analysis-words">${countWords(results)} ${catchWords(results)}</p>
      <p class="hint">${neededWords(results)}</p>
      <details class="advanced" ?open=${results.participants.some(({ excluded }) => excluded)}>
        <summary>${words.participants}</summary>
        <div class="table-box" tabindex="0" role="region" aria-label=${words.participantsLabel}>
          <table class="participants tabular">
            <thead class="hint"><tr>${words.heads.map((title) => html`<th scope="col">${title}</th>`)}</tr></thead>
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
    const words = perceptionWords().analysis;
    return html`
      ${this.#files()}
      ${busy ? html`<p class="hint" role="status">${words.busy}</p>` : nothing}
      ${problem ? html`<p class="bad" role="alert" data-testid="analysis-problem">${sentence(problem)}</p>` : nothing}
      ${results ? this.#results(results) : html`<p class="empty">${words.empty}</p>`}`;
  }
}
customElements.define("pg-perception-analysis", AnalysisView);
