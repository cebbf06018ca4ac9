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
import "./primitives.css";
import "./walk-view";
import { lab } from "../words/lab";

/** A model for the stage. `made`: it was made here and is on no disk. */
export interface StagedModel {
  text: string;
  made: boolean;
}

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
    this.listen(this, "put-on-stage", (event) => {
      // The event that this view sends itself has a detail.
      if (event instanceof CustomEvent && event.detail === null) void this.#putOnStage(event);
    });
  }

  async #putOnStage(event: Event): Promise<void> {
    event.stopPropagation();
    try {
      const made = !this.#library.isCombinationSaved;
      const detail: StagedModel = { text: await this.#library.combinationText(), made };
      this.dispatchEvent(new CustomEvent("stage-model", { detail, bubbles: true }));
    } catch (problem) {
      this.notices.addError("This combination was not taken up", messageOf(problem));
    }
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
    const names = learned.map(({ name }) => `“${name}”`).join(" and ");
    return html`
      <section class="panel library-head" aria-label="The library">
        <p><strong>${current.title === "" ? "A library of made walks" : current.title}</strong>
          <span data-testid="library-words">It learned ${names} from ${duration(frames * frameTime)} of motion.
          ${current.title === "" ? "The clips are this project’s own, made by a program." : nothing}
          ${current.unsaved ? "It is not saved yet." : nothing}</span></p>
        <div class="button-row">
          ${before ? html`<button class="small" data-testid="library-undo" @click=${() => void this.#library.undo()}>Back to the library before</button>` : nothing}
          <button class="small" data-testid="save-library" @click=${() => this.#save()}>Save the library</button>
          ${fileButton({
            label: "Open a library",
            meaning: "Open a library of primitives (.json)",
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
    const { library, fitting, imports, locking, learning, fold } = this.primitives;
    const { playing } = library.walk.player;
    const here = this.notices.all.filter(({ at }) => at === null);
    if (!library.current) {
      return library.problem
        ? html`<p class="empty" role="alert">The library could not be opened: ${sentence(library.problem)}
          <button class="small" @click=${() => void library.openFirst()}>Try again</button></p>`
        : html`<p class="empty" role="status">Loading</p>`;
    }
    return html`
      <div class="primitives">
        ${this.#head()}
        ${here.length > 0 ? html`<div class="library-notices">${here.map((notice) => noticeCard(this.notices, notice, lab().files.dismiss))}</div>` : nothing}
        <section class="panel walk-panel" aria-label="The figure"><pg-walk .library=${library}></pg-walk></section>
        <div class="beside-figure">
          <section class="panel" aria-label="Primitives"><pg-drawer .library=${library} .playing=${playing} .notices=${this.notices}></pg-drawer></section>
          <section class="panel" aria-label="All combinations"><pg-gallery .library=${library} .playing=${playing}></pg-gallery></section>
          <section class="panel" aria-label="Chimera"><pg-chimera .library=${library} .locking=${locking}></pg-chimera></section>
          <section class="panel" aria-label="Couplings and morph"><pg-walk-couplings .library=${library} .fitting=${fitting} .clips=${clips}></pg-walk-couplings>
            <pg-morph .library=${library}></pg-morph></section>
          <section class="panel" aria-label="Primitives of other files"><pg-import .imports=${imports} .clips=${clips} .notices=${this.notices} .seed=${this.primitives.seed()}></pg-import></section>
        </div>
        <section class="panel learning-panel" aria-label="Learn a library"><pg-learning .learning=${learning}></pg-learning></section>
        <section class="panel lesson-panel" aria-label="The experiment"><pg-lesson .learning=${learning} .fold=${fold}></pg-lesson></section>
      </div>`;
  }
}
customElements.define("pg-primitives", PrimitivesPage);
