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

async function chosenStudy(file: File): Promise<string> {
  if (file.size > LARGEST_FILE) throw new Error("This file has more than 200 MB; expected a study.");
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
    const cannot = study === null || busy || active !== null;
    return html`
      <h2>Which is natural?</h2>
      <p class="hint">Two movements side by side, one natural, one made by a model. The more often people take the model’s for the natural one, the better the model.</p>
      <label class="field"><span>Participant</span>
        <input type="text" data-testid="participant-name" maxlength="40" autocomplete="off" spellcheck="false" placeholder="a code at random" title="A code, no name" /></label>
      <div class="begin">
        <button class="primary big" data-testid="begin" ?disabled=${cannot} @click=${() => this.#begin(false)}>Begin</button>
        <button data-testid="simulate" class="small" ?disabled=${cannot} title="The program answers, to try the experiment out" @click=${() => this.#begin(true)}>Simulate</button>
      </div>
      <p class="hint">This page records no person and sends nothing. Answers stay in this browser until you save or forget them.</p>
      <h3>Study</h3>
      ${problem ? html`<p class="bad" role="alert" data-testid="study-problem">${sentence(problem)}</p>` : nothing}
      ${studyCard(perception, (id) => void this.querySelector<MovementLook>("pg-perception-look")?.open(id))}
      <div class="files">
        <button class="small" data-testid="save-study" ?disabled=${study === null} @click=${() => perception.saveStudy()}>${icon("save")} Save study</button>
        ${fileButton({
          label: "Open study",
          meaning: "Open a study (.json)",
          testId: "open-study",
          accept: ".json,application/json",
          multiple: false,
          disabled: busy || active !== null,
          chosen: ([file]) => file && void this.#open(file),
        })}
      </div>
      <details class="advanced">
        <summary>Run it elsewhere</summary>
        <p class="hint">Put the built page on any static host, with your study as <code>${STUDY_OF_THE_PAGE}</code>, and give out its address with <code>#view=perception</code>. In JATOS the built folder is the study’s assets,
          and <code>index.html</code> the component. Nothing is sent there either: participants save their file and hand it in.</p>
      </details>`;
  }

  protected override render() {
    const { perception, analysis, notices } = this;
    return html`
      <section class="card setup" aria-label="The experiment">${this.#setup()}</section>
      <section class="found" aria-label="Answers">
        ${notices.all.filter(({ at }) => at === null).map((notice) => noticeCard(notices, notice, lab().files.dismiss))}
        <div class="card"><h2>On this machine</h2>${participants(perception)}</div>
        <div class="card"><h2>What the answers say</h2>
          <pg-perception-analysis .analysis=${analysis} .perception=${perception} .notices=${notices}></pg-perception-analysis></div>
      </section>
      <pg-perception-look .perception=${perception} .notices=${notices}></pg-perception-look>
      <pg-perception-run .perception=${perception} .notices=${notices}></pg-perception-run>`;
  }
}
customElements.define("pg-perception", PerceptionPage);
