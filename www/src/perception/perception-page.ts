// The view of the graphics Turing test: the study, the participants and the analysis.
import { html, nothing } from "lit";
import { LARGEST_FILE } from "../clips/clips-store";
import { fileButton } from "../ui/file-button";
import { sentence } from "../ui/format";
import { icon } from "../ui/icons";
import type { NoticesStore } from "../ui/notices-store";
import { noticeCard } from "../ui/notices-view";
import "../ui/two-columns.css";
import { View } from "../ui/view";
import type { Draw } from "../views/define-view";
import type { AnalysisStore } from "./analysis-store";
import "./analysis-view";
import "./movement-look";
import type { MovementLook } from "./movement-look";
import "./perception.css";
import type { PerceptionStore } from "./perception-store";
import "./riddle-view";
import "./run-dialog";
import { studyCard } from "./study-card";
import { STUDY_OF_THE_PAGE } from "./study-of-the-page";
import { lab } from "../words/lab";
import { perceptionWords } from "./view-words";
import type { AnswersFile } from "../engine/whole-protocol";
import { download } from "../ui/download";
import { csvFile, jsonFile } from "./answer-files";
import { answersOf, codeOf } from "./class-code";
import { answered, isComplete, type StoredParticipation } from "./participation";

const save = ({ name, text }: AnswersFile) =>
  download(
    name,
    new Blob([text], { type: name.endsWith(".csv") ? "text/csv;charset=utf-8" : "application/json" }),
  );

function row(store: PerceptionStore, participation: StoredParticipation) {
  const { key, participant, title, trials, simulated, seed, study, rows } = participation;
  const done = answered(participation);
  const { participants: words, run } = perceptionWords();
  const forget = () => {
    if (done === 0 || confirm(words.sureToForget(done, participant))) void store.forget(key);
  };
  const answers = isComplete(participation) ? answersOf(rows) : null;
  const code = answers && codeOf(study, { seed, simulated, answers });
  return html`
    <tr data-testid="participant" data-complete=${isComplete(participation)}>
      <th scope="row">${participant}${simulated ? html` <small>${words.simulated}</small>` : nothing}
        ${code ? html`<code class="class-code" data-testid="class-code" title=${words.classCode}>${code}</code>` : nothing}</th>
      <td>${title}</td>
      <td>${run.of(done, trials)}</td>
      <td class="row-buttons">
        ${isComplete(participation) ? nothing : html`<button class="small" data-testid="resume" ?disabled=${store.busy} @click=${() => void store.resume(key)}>${icon("play")} ${words.goOn}</button>`}
        <button class="small" data-testid="save-csv" ?disabled=${done === 0} aria-label=${words.csv(participant)} @click=${() => save(csvFile([participation]))}>CSV</button>
        <button class="small" data-testid="save-json" ?disabled=${done === 0} aria-label=${words.json(participant)} @click=${() => save(jsonFile([participation]))}>JSON</button>
        <button class="round" aria-label=${words.forgetOf(participant)} title=${words.forget} @click=${forget}>${icon("close")}</button>
      </td>
    </tr>`;
}

function participants(store: PerceptionStore) {
  const { participations, storageProblem } = store;
  const words = perceptionWords().participants;
  const all = participations.filter((participation) => answered(participation) > 0);
  const warning = storageProblem
    ? html`<p class="bad" role="alert">${words.notKept(storageProblem)}</p>`
    : nothing;
  if (participations.length === 0) return html`${warning}<p class="empty">${words.nobody}</p>`;
  return html`
    ${warning}
    <div class="table-box" tabindex="0" role="region" aria-label=${words.label}>
      <table class="participants tabular">
        <thead class="hint"><tr>${words.heads.map((column) => html`<th scope="col">${column}</th>`)}<th scope="col"><span class="visually-hidden">${words.files}</span></th></tr></thead>
        <tbody>${participations.map((participation) => row(store, participation))}</tbody>
      </table>
    </div>
    ${
      all.length > 1
        ? html`<div class="files wrap tight">
            <button class="small" data-testid="save-all-csv" @click=${() => save(csvFile(all))}>${icon("save")} ${words.allCsv}</button>
            <button class="small" data-testid="save-all-json" @click=${() => save(jsonFile(all))}>${icon("save")} ${words.allJson}</button>
          </div>`
        : nothing
    }`;
}

/** What a link to the view ends with, and the component of a JATOS study. */
const [ADDRESS, COMPONENT] = ["#view=perception", "index.html"];

async function chosenStudy(file: File): Promise<string> {
  if (file.size > LARGEST_FILE) throw new Error(perceptionWords().study.tooLarge);
  return file.text();
}

export class PerceptionPage extends View {
  declare perception: PerceptionStore;
  declare analysis: AnalysisStore;
  declare notices: NoticesStore;

  protected override stores() {
    return [this.perception, this.notices];
  }

  protected override arrived(): void {
    const { perception } = this;
    void perception.loadStored();
    void perception.ready();
  }

  async #open(file: File): Promise<void> {
    await this.perception.openStudy(() => chosenStudy(file));
    await this.updateComplete;
    // The button was disabled during the experiment.
    if (document.activeElement === document.body)
      this.querySelector<HTMLElement>("[data-testid=open-study]")?.focus();
  }

  #begin(simulated: boolean): void {
    const field = this.querySelector<HTMLInputElement>("[data-testid=participant-name]");
    // The typed name stays until the experiment has begun.
    void this.perception.begin(field?.value ?? "", simulated).then(() => {
      if (field && this.perception.active) field.value = "";
    });
  }

  #setup() {
    const { perception } = this;
    const { study, busy, problem, active } = perception;
    const words = perceptionWords();
    const [where, address, jatos, component] = words.elsewhereText;
    const cannot = study === null || busy || active !== null;
    return html`
      <h2>${words.title}</h2>
      <p class="hint">${words.about}</p>
      <label class="field stack"><span>${words.participant}</span>
        <input type="text" data-testid="participant-name" maxlength="40" autocomplete="off" spellcheck="false" placeholder=${words.code} title=${words.codeMeaning} /></label>
      <div class="begin">
        <button class="primary big" data-testid="begin" ?disabled=${cannot} @click=${() => this.#begin(false)}>${words.begin}</button>
        <button data-testid="simulate" class="small" ?disabled=${cannot} title=${words.simulateMeaning} @click=${() => this.#begin(true)}>${words.simulate}</button>
      </div>
      <p class="hint">${words.privacy}</p>
      <h3>${words.study.title}</h3>
      ${problem ? html`<p class="bad" role="alert" data-testid="study-problem">${sentence(problem)}</p>` : nothing}
      ${studyCard(perception, (id) => void this.querySelector<MovementLook>("pg-perception-look")?.open(id))}
      <div class="files wrap tight">
        <button class="small" data-testid="save-study" ?disabled=${study === null} @click=${() => perception.saveStudy()}>${icon("save")} ${words.study.save}</button>
        ${fileButton({
          label: words.study.open,
          meaning: words.study.openMeaning,
          testId: "open-study",
          accept: ".json,application/json",
          multiple: false,
          disabled: busy || active !== null,
          chosen: ([file]) => file && void this.#open(file),
        })}
      </div>
      <details class="advanced">
        <summary>${words.elsewhere}</summary>
        <p class="hint">${where} <code>${STUDY_OF_THE_PAGE}</code>${address} <code>${ADDRESS}</code>${jatos} <code>${COMPONENT}</code> ${component}</p>
      </details>`;
  }

  protected override render() {
    const { perception, analysis, notices } = this;
    const words = perceptionWords();
    return html`
      <section class="card setup scroll column" aria-label=${words.setup}>${this.#setup()}</section>
      <section class="found scroll column" aria-label=${words.found}>
        ${notices.all.filter(({ at }) => at === null).map((notice) => noticeCard(notices, notice, lab().files.dismiss))}
        <pg-perception-riddle .perception=${perception}></pg-perception-riddle>
        <div class="card"><h2>${words.here}</h2>${participants(perception)}</div>
        <div class="card"><h2>${words.answersSay}</h2>
          <pg-perception-analysis .analysis=${analysis} .perception=${perception} .notices=${notices}></pg-perception-analysis></div>
      </section>
      <pg-perception-look .perception=${perception} .notices=${notices}></pg-perception-look>
      <pg-perception-run .perception=${perception} .notices=${notices}></pg-perception-run>`;
  }
}
customElements.define("pg-perception", PerceptionPage);

export const draw: Draw<"perception"> = ({ perception, analysis }, { notices }) =>
  html`<pg-perception .perception=${perception} .analysis=${analysis} .notices=${notices}></pg-perception>`;
