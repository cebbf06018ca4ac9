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
import type { AnalysisStore } from "./analysis-store";
import "./analysis-view";
import "./movement-look";
import type { MovementLook } from "./movement-look";
import { participants } from "./participants";
import "./perception.css";
import type { PerceptionStore } from "./perception-store";
import "./run-dialog";
import { studyCard } from "./study-card";
import { STUDY_OF_THE_PAGE } from "./study-of-the-page";
import { lab } from "../words/lab";
import { perceptionWords } from "../words/perception";

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
      <label class="field"><span>${words.participant}</span>
        <input type="text" data-testid="participant-name" maxlength="40" autocomplete="off" spellcheck="false" placeholder=${words.code} title=${words.codeMeaning} /></label>
      <div class="begin">
        <button class="primary big" data-testid="begin" ?disabled=${cannot} @click=${() => this.#begin(false)}>${words.begin}</button>
        <button data-testid="simulate" class="small" ?disabled=${cannot} title=${words.simulateMeaning} @click=${() => this.#begin(true)}>${words.simulate}</button>
      </div>
      <p class="hint">${words.privacy}</p>
      <h3>${words.study.title}</h3>
      ${problem ? html`<p class="bad" role="alert" data-testid="study-problem">${sentence(problem)}</p>` : nothing}
      ${studyCard(perception, (id) => void this.querySelector<MovementLook>("pg-perception-look")?.open(id))}
      <div class="files">
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
      <section class="card setup" aria-label=${words.setup}>${this.#setup()}</section>
      <section class="found" aria-label=${words.found}>
        ${notices.all.filter(({ at }) => at === null).map((notice) => noticeCard(notices, notice, lab().files.dismiss))}
        <div class="card"><h2>${words.here}</h2>${participants(perception)}</div>
        <div class="card"><h2>${words.answersSay}</h2>
          <pg-perception-analysis .analysis=${analysis} .perception=${perception} .notices=${notices}></pg-perception-analysis></div>
      </section>
      <pg-perception-look .perception=${perception} .notices=${notices}></pg-perception-look>
      <pg-perception-run .perception=${perception} .notices=${notices}></pg-perception-run>`;
  }
}
customElements.define("pg-perception", PerceptionPage);
