// The view of a library of primitives and their combinations.
import { html, nothing } from "lit";
import { duration, sentence } from "../ui/format";
import { download } from "../ui/download";
import { fileButton } from "../ui/file-button";
import { messageOf } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { noticeCard } from "../ui/notices-view";
import { View } from "../ui/view";
import type { ClipsStore } from "../clips/clips-store";
import "./chimera-view";
import "./walk-couplings-view";
import "./drawer-view";
import "./gallery-view";
import "./import-view";
import "./lesson-view";
import "./learning-view";
import "./morph-view";
import type { Primitives } from "./primitives";
import type { StagedModel } from "../stage/staged-model";
import "./primitives.css";
import "./recognition-view";
import "./walk-view";
import { lab } from "../words/lab";
import { DATA_SOURCE } from "../words/data-source";
import { primitivesWords } from "../words/primitives";

export class PrimitivesPage extends View {
  declare primitives: Primitives;
  declare clips: ClipsStore;
  declare notices: NoticesStore;

  get #library() {
    return this.primitives.library;
  }

  protected override stores() {
    return [this.#library, this.#library.walk, this.notices];
  }

  protected override arrived(): void {
    void this.#library.openFirst();
    void this.primitives.recorded.load();
    this.listen(this, "put-on-stage", (event) => {
      // The event that this view sends itself has a detail.
      if (event instanceof CustomEvent && event.detail === null) this.#putOnStage(event);
    });
  }

  #putOnStage(event: Event): void {
    event.stopPropagation();
    const made = !this.#library.isCombinationSaved;
    const detail: StagedModel = { text: this.#library.combinationText(), name: "combination", made };
    this.dispatchEvent(new CustomEvent("stage-model", { detail, bubbles: true }));
  }

  async #open(file: File | undefined): Promise<void> {
    if (!file) return;
    try {
      await this.primitives.imports.openFile(await file.text(), file.name);
    } catch (problem) {
      this.notices.addError(file.name, messageOf(problem));
    }
  }

  #save(): void {
    download("library.json", new Blob([this.#library.save()], { type: "application/json" }));
  }

  /** The title of the library, and the actions for the whole library. */
  #head() {
    const { current, before } = this.#library;
    if (!current) return nothing;
    const { movements, frameTime } = current.info;
    const learned = movements.filter(({ learned }) => learned);
    const frames = learned.flatMap(({ sequences }) => sequences).reduce((sum, { frames }) => sum + frames, 0);
    const { areas, library: words } = primitivesWords();
    const isGiven = current.title === "";
    const text = words.learned(
      learned.map(({ name }) => name),
      duration(frames * frameTime),
    );
    return html`
      <section class="panel library-head" aria-label=${areas.library}>
        <p><strong>${isGiven ? words.made : current.title}</strong>
          <span data-testid="library-words">${text}
          ${isGiven ? html`${words.source} <span lang="en">${DATA_SOURCE}</span>` : nothing}
          ${current.unsaved ? words.unsaved : nothing}</span></p>
        <div class="button-row">
          ${before ? html`<button class="small" data-testid="library-undo" @click=${() => void this.#library.undo()}>${words.undo}</button>` : nothing}
          <button class="small" data-testid="save-library" @click=${() => this.#save()}>${words.save}</button>
          ${fileButton({
            label: words.open,
            meaning: words.openMeaning,
            testId: "open-library",
            accept: ".json,application/json",
            multiple: false,
            disabled: false,
            chosen: ([file]) => void this.#open(file),
          })}
        </div>
      </section>`;
  }

  protected override render() {
    const { clips } = this;
    const { library, fitting, imports, locking, learning, fold, recognition } = this.primitives;
    const { playing } = library.walk.player;
    const words = primitivesWords();
    const { areas } = words;
    const here = this.notices.all.filter(({ at }) => at === null);
    if (!library.current) {
      return library.problem
        ? html`<p class="empty" role="alert">${words.notOpened(sentence(library.problem))}
          <button class="small" @click=${() => void library.openFirst()}>${words.tryAgain}</button></p>`
        : html`<p class="empty" role="status">${words.loading}</p>`;
    }
    return html`
      <div class="primitives">
        ${this.#head()}
        ${here.length > 0 ? html`<div class="library-notices">${here.map((notice) => noticeCard(this.notices, notice, lab().files.dismiss))}</div>` : nothing}
        <div class="walk-and-controls">
          <section class="panel walk-panel" aria-label=${areas.figure}><pg-walk .library=${library}></pg-walk></section>
          <div class="beside-figure">
            <section class="panel" aria-label=${words.drawer.title}><pg-drawer .library=${library} .playing=${playing} .notices=${this.notices}></pg-drawer></section>
            <section class="panel" aria-label=${words.gallery.title}><pg-gallery .library=${library} .playing=${playing}></pg-gallery></section>
            <section class="panel" aria-label=${areas.chimera}><pg-chimera .library=${library} .locking=${locking}></pg-chimera></section>
            <section class="panel" aria-label=${areas.couplings}><pg-walk-couplings .library=${library} .fitting=${fitting} .clips=${clips}></pg-walk-couplings>
              <pg-morph .library=${library}></pg-morph></section>
            <section class="panel" aria-label=${areas.imports}><pg-import .imports=${imports} .clips=${clips} .notices=${this.notices} .seed=${this.primitives.seed()}></pg-import></section>
          </div>
        </div>
        <section class="panel recognition-panel" aria-label=${words.recognition.title}><pg-recognition .recognition=${recognition} .library=${library}></pg-recognition></section>
        <section class="panel learning-panel" aria-label=${words.learning.title}><pg-learning .learning=${learning}></pg-learning></section>
        <section class="panel lesson-panel" aria-label=${areas.experiment}><pg-lesson .learning=${learning} .fold=${fold}></pg-lesson></section>
      </div>`;
  }
}
customElements.define("pg-primitives", PrimitivesPage);
