// The view Compare models: the choices, the progress, the models side by side, and the results.
import { html, nothing } from "lit";
import { type ClipsStore, LARGEST_FILE } from "../clips/clips-store";
import type { EngineStore } from "../engine/engine-store";
import type { SettingsStore } from "../settings/settings-store";
import { decodeFirstMotion, type FirstMotion } from "../stage/first-motion.js";
import { fileButton } from "../ui/file-button";
import { messageOf, sentence } from "../ui/format";
import { icon } from "../ui/icons";
import type { NoticesStore } from "../ui/notices-store";
import { noticeCard } from "../ui/notices-view";
import { progressBar } from "../ui/progress-bar";
import { View } from "../ui/view";
import type { Draw } from "../views/define-view";
import "../ui/two-columns.css";
import { withTerms } from "../terms/term";
import "./choices";
import type { ComparisonChoices } from "./choices";
import "./comparison.css";
import type { ComparisonStore } from "./comparison-store";
import { secondsLeft, share } from "./jobs";
import { modelStyle } from "../figures/model-style";
import "./side-by-side";
import { timeLeft } from "../training/words";
import { lab } from "../words/lab";
import { compareWords } from "./view-words";
import type { Comparison } from "../engine/whole-protocol";
import "./correlations";
import "./growth";
import "./models-table";
import { FigureElement, type SaveFailure } from "../figures/figure-element";

class ClaimsTable extends FigureElement<Comparison> {
  protected readonly words = () => compareWords().claims;
  protected readonly file = "claims-of-the-papers";

  protected missing({ claims }: Comparison): string | null {
    return claims.length === 0 ? compareWords().claims.none : null;
  }

  protected table({ claims }: Comparison) {
    return {
      header: ["the papers say", "place", "our criterion", "we find", "holds here (yes, no or undecided)"],
      rows: claims.map(({ claim, place, criterion, found, answer }) => [
        claim,
        place,
        criterion,
        found,
        answer,
      ]),
    };
  }

  protected figure({ claims }: Comparison) {
    const words = compareWords().claims;
    // A narrow page shows the rows as blocks, which then need their roles.
    return html`
      <table class="claims-table" role="table">
        <thead class="hint" role="rowgroup"><tr role="row">${words.heads.map((head) => html`<th scope="col" role="columnheader">${head}</th>`)}</tr></thead>
        <tbody role="rowgroup">${claims.map(
          ({ claim, place, criterion, found, answer }) => html`
          <tr role="row"><th scope="row" role="rowheader" lang="en">${claim} <small>(${place})</small></th>
            <td role="cell" class="found scroll column"><span lang="en">${found}</span> <small>${words.criterion} <span lang="en">${criterion}.</span></small></td>
            <td role="cell" class="holds"><span class=${answer === "no" ? "bad" : ""}>${words.answers[answer]}</span></td></tr>`,
        )}</tbody>
      </table>
      <figcaption>${words.caption}</figcaption>`;
  }
}
customElements.define("comparison-claims", ClaimsTable);

class ComparisonFigures extends View {
  static override properties = { comparison: { attribute: false } };
  comparison: Comparison | null = null;

  protected override render() {
    const { comparison } = this;
    const found = comparison && [comparison.models, comparison.growth, comparison.claims];
    if (!found?.some((list) => list.length > 0)) {
      return html`<p class="empty">${compareWords().empty}</p>`;
    }
    return html`
      <div class="figures">
        <comparison-models .data=${comparison}></comparison-models>
        <comparison-correlations .data=${comparison}></comparison-correlations>
        <comparison-growth .data=${comparison}></comparison-growth>
        <comparison-claims .data=${comparison}></comparison-claims>
      </div>`;
  }
}
customElements.define("comparison-figures", ComparisonFigures);

declare global {
  interface HTMLElementTagNameMap {
    "comparison-figures": ComparisonFigures;
  }
}

/** On narrower pages the results are below the choices. */
const NARROW = "(max-width: 759.98px)";

/** The results that come with the page: all models on ten recorded walks. */
async function recordedWalks(): Promise<string> {
  const answer = await fetch(new URL("comparison/walks.results.json", document.baseURI));
  if (!answer.ok) throw new Error(lab().files.hostAnswered(answer.status, answer.url));
  return answer.text();
}

/** What the best of four kinds of models predicted of one of these walks; null: the figures cannot be shown. */
async function recordedMotions(): Promise<FirstMotion | null> {
  try {
    const answer = await fetch(new URL("comparison/walks.motions.bin", document.baseURI));
    return answer.ok ? decodeFirstMotion(await answer.arrayBuffer()) : null;
  } catch {
    return null;
  }
}

async function chosenResults(file: File): Promise<string> {
  if (file.size > LARGEST_FILE) {
    throw new Error(compareWords().tooLarge);
  }
  return file.text();
}

export class ComparisonPage extends View {
  declare comparison: ComparisonStore;
  declare settings: SettingsStore;
  declare clips: ClipsStore;
  declare engine: EngineStore;
  declare notices: NoticesStore;
  /** Why results could not be opened. */
  #problem = "";

  protected override arrived(): void {
    this.whenLeaving(this.comparison.follow());
    // The button remains when the results cannot be loaded.
    void this.comparison.showGiven(recordedWalks, recordedMotions).catch(() => {});
    this.listen(window, "online", () => {
      this.#problem = "";
      this.comparison.reconnected();
    });
  }

  /** The status next to the button: the plan, the progress or the end. */
  #status() {
    const { comparison } = this;
    const { status, ending, whyNot, outlook } = comparison;
    const words = compareWords();
    if (this.#problem) return html`<span class="bad" role="alert">${sentence(this.#problem)}</span>`;
    if (status === "cancelling") return words.cancelling;
    if (comparison.isPlanning) return words.loadingModels;
    if (status === "running") {
      const jobs = comparison.shown?.jobs ?? [];
      const over = jobs.filter(({ state }) => state === "done" || state === "failed").length;
      const left = timeLeft(secondsLeft(jobs, comparison.width), true);
      return html`<span>${words.done(over, jobs.length)}</span><span>${sentence(left)}</span>`;
    }
    const ended = ending.failed
      ? html`<span class="bad" role="alert">${words.failed(sentence(ending.words))}</span>`
      : html`<span>${sentence(ending.words)}</span>`;
    if (whyNot) return html`${ended}<span>${sentence(whyNot)}</span>`;
    if (!outlook) return ended;
    const { asked, open, goesOn, cost } = outlook;
    const plan = open > 0 ? words.plan(open, asked - open) : "";
    const apart = goesOn ? "" : words.ofItsOwn;
    const wait = html`<span class=${cost.absurd ? "bad" : ""} data-testid="comparison-cost">${cost.words}</span>`;
    return html`${ended}<span>${plan}${apart}</span>${wait}`;
  }

  /** Screen readers read the state, not each training. */
  #announcement(): string {
    const { status, shown, ending, isPlanning } = this.comparison;
    const words = compareWords();
    if (isPlanning && status === "running") return "";
    if (status === "running") return words.share(Math.floor(share(shown?.jobs ?? []) * 10) * 10);
    if (status === "cancelling") return words.cancelling;
    return status === "idle" && !ending.failed ? ending.words : "";
  }

  #begin(): void {
    this.#problem = "";
    if (matchMedia(NARROW).matches) this.querySelector<ComparisonChoices>("pg-comparison-choices")?.fold();
    void this.comparison.begin();
  }

  /** Opens results. The shown ones stay when that fails. */
  async #open(name: string, text: () => Promise<string>): Promise<void> {
    this.#problem = "";
    try {
      await this.comparison.open(await text());
    } catch (problem) {
      this.#problem = `${name}: ${messageOf(problem)}`;
      this.requestUpdate();
    }
  }

  async #makeStudy(): Promise<void> {
    this.#problem = "";
    try {
      this.tell("study-made", await this.comparison.makeStudy());
    } catch (problem) {
      this.#problem = compareWords().noStudy(messageOf(problem));
      this.requestUpdate();
    }
  }

  #button() {
    const { comparison } = this;
    const words = compareWords();
    return comparison.busy
      ? html`<button class="primary big" data-testid="compare-cancel" ?disabled=${comparison.status === "cancelling"}
          title=${words.cancelMeaning} @click=${() => comparison.cancel()}>${words.cancel}</button>`
      : html`<button class="primary big" data-testid="compare" ?disabled=${comparison.whyNot !== ""} @click=${() => this.#begin()}>${words.compare}</button>`;
  }

  #files() {
    const { busy, shown } = this.comparison;
    const words = compareWords();
    const canSave = shown !== null && shown.results.finished.length > 0;
    return html`
      <div class="files wrap tight">
        ${fileButton({
          label: words.openResults,
          meaning: words.openResultsMeaning,
          testId: "open-results",
          accept: ".json,application/json",
          multiple: false,
          disabled: busy,
          chosen: ([file]) => file && void this.#open(file.name, () => chosenResults(file)),
        })}
        <button class="small" data-testid="save-results" ?disabled=${!canSave} @click=${() => this.comparison.save()}>${icon("save")} ${words.saveResults}</button>
        <button class="small" data-testid="open-walks" ?disabled=${busy || !this.engine.engine} title=${words.walksMeaning}
          @click=${() => void this.#open(words.walks, recordedWalks)}>${icon("eye")} ${words.walks}</button>
        <button class="small" data-testid="make-study" ?disabled=${busy || !this.comparison.canMakeStudy} title=${words.makeStudyMeaning}
          @click=${() => void this.#makeStudy()}>${icon("play")} ${words.makeStudy}</button>
      </div>`;
  }

  #setup() {
    const { comparison, settings, clips, notices } = this;
    const { busy } = comparison;
    const words = compareWords();
    return html`
      <div class="begin">
        ${this.#button()}
        <p class="hint words" data-testid="compare-progress">${this.#status()}</p>
      </div>
      ${progressBar(words.comparing, busy ? share(comparison.shown?.jobs ?? []) : null)}
      <div class="visually-hidden" role="status" aria-live="polite">${this.#announcement()}</div>
      <p class="hint">${withTerms(words.about)}</p>
      <pg-comparison-choices .comparison=${comparison} .settings=${settings} .clips=${clips} .notices=${notices}></pg-comparison-choices>
      ${this.#files()}`;
  }

  #failures() {
    const { shown } = this.comparison;
    const known = shown?.results.finished.map(({ job, failure }) => ({ job, why: failure })) ?? [];
    const now =
      shown?.jobs.map(({ job, state, why }) => ({ job, why: state === "failed" ? why : null })) ?? [];
    const failed = [...known, ...now].filter(({ why }) => why !== null);
    if (failed.length === 0) return nothing;
    return html`<ul class="failures card">${failed.map(
      ({ job, why }) => html`
      <li class="bad">${compareWords().failure(modelStyle(job.candidate.model).name, job.heldOut + 1, sentence(why ?? ""))}</li>`,
    )}</ul>`;
  }

  protected override render() {
    const { comparison, notices } = this;
    const words = compareWords();
    const saveFailed = ({ detail }: CustomEvent<SaveFailure>) =>
      notices.addError(lab().files.notSaved(detail.name), detail.message);
    return html`
      <section class="card setup scroll column" aria-label=${words.setup}><h2>${words.title}</h2>${this.#setup()}</section>
      <section class="found scroll column" aria-label=${words.found}>
        <div class="card stage-card"><pg-side-by-side data-clock .comparison=${comparison}></pg-side-by-side></div>
        ${notices.all.filter(({ at }) => at === null).map((notice) => noticeCard(notices, notice, lab().files.dismiss))}
        ${this.#failures()}
        ${comparison.shown?.given ? html`<p class="hint" data-testid="given">${words.given}</p><p>${words.lesson}</p>` : nothing}
        <div class="card"><comparison-figures .comparison=${comparison.shown?.results.comparison ?? null} @save-failed=${saveFailed}></comparison-figures></div>
      </section>`;
  }
}
customElements.define("pg-comparison", ComparisonPage);

export const draw: Draw<"compare"> = (comparison, { settings, clips, engine, notices }) => html`
  <pg-comparison .comparison=${comparison} .settings=${settings} .clips=${clips} .engine=${engine} .notices=${notices}></pg-comparison>`;
