// The view of a library of primitives and their combinations.
import { html, nothing } from "lit";
import { duration, sentence, messageOf, fixed } from "../ui/format";
import { download } from "../ui/download";
import { fileButton } from "../ui/file-button";
import type { NoticesStore } from "../ui/notices-store";
import { noticeCard } from "../ui/notices-view";
import { View } from "../ui/view";
import type { Draw } from "../views/define-view";
import type { ClipsStore } from "../clips/clips-store";
import "./walk-couplings-view";
import "./drawer-view";
import type { Primitives } from "./primitives";
import type { StagedModel } from "../stage/stage-store";
import "./primitives.css";
import "./recognition-view";
import "./walk-view";
import "../live/live-view";
import { lab, shownPart } from "../words/lab";
import { DATA_SOURCE } from "../words/data-source";
import { primitivesWords } from "./view-words";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import type { LibraryStore } from "./library-store";
import { isSame, recordedAs, titleOf } from "./combinations";
import "./small-figure-view";
import { progressRow } from "../training/progress-row";
import type { LearningClip, LearningStore } from "./learning-store";

class LearningView extends View {
  declare learning: LearningStore;

  #clip({ key, title, chosen, movement }: LearningClip) {
    const { learning } = this;
    const words = primitivesWords().learning;
    return html`
      <li class="learning-clip">
        <label class="row"><input type="checkbox" .checked=${chosen} ?disabled=${learning.busy} aria-label=${words.from(title)}
          @change=${(event: Event) => learning.choose(key, (event.target as HTMLInputElement).checked)} /> <span>${title}</span></label>
        <input type="text" .value=${movement} ?disabled=${learning.busy || !chosen} aria-label=${words.movement(title)}
          @change=${(event: Event) => learning.rename(key, (event.target as HTMLInputElement).value)} />
      </li>`;
  }

  #part(name: string, part: number) {
    const { learning } = this;
    const choice = (shared: boolean, words: string) => html`
      <button aria-pressed=${learning.isShared(name) === shared ? "true" : "false"} ?disabled=${learning.busy} data-testid="share-${part}-${shared ? "same" : "own"}"
        @click=${() => learning.setShared(name, shared)}>${words}</button>`;
    const { drawer, learning: texts } = primitivesWords();
    return html`
      <div class="learning-part row loose" role="group" aria-label=${drawer.of(shownPart(name))} style=${partStyle(partColour(part))}>
        <span class="part-name"><i class="swatch"></i>${shownPart(name)}</span>
        <span class="segments">${choice(true, texts.same)}${choice(false, texts.own)}</span>
      </div>`;
  }

  protected override render() {
    const { learning } = this;
    const words = primitivesWords().learning;
    return html`
      <h2>${words.title}</h2>
      <p class="hint">${words.about(words.same, words.own)}</p>
      <div class="learning">
        <ul class="learning-clips scroll">${learning.clips.map((clip) => this.#clip(clip))}</ul>
        <div>
          ${learning.parts.map(({ name }, part) => this.#part(name, part))}
          ${progressRow({
            progress: learning,
            verb: [words.learn, words.going, words.done],
            testIds: ["learn", "learn-cancel", "learn-words"],
            whyNot: learning.whyNot,
            hint: words.hint,
            start: () => void learning.learn(),
          })}
        </div>
      </div>`;
  }
}
customElements.define("pg-learning", LearningView);

class ImportView extends View {
  declare library: LibraryStore;
  declare notices: NoticesStore;

  async #add(file: File | undefined): Promise<void> {
    if (!file) return;
    try {
      await this.library.add(await file.text());
    } catch (problem) {
      this.notices.addError(file.name, messageOf(problem));
    }
  }

  protected override render() {
    const words = primitivesWords().imports;
    return html`
      <div class="row wrap">
        ${fileButton({
          label: words.add,
          meaning: words.addMeaning,
          testId: "add-primitives",
          accept: ".json,application/json",
          multiple: false,
          disabled: false,
          chosen: ([file]) => void this.#add(file),
        })}
      </div>
      <p class="hint" role="status" data-testid="import-words">${this.library.addedText}</p>`;
  }
}
customElements.define("pg-import", ImportView);

class GalleryView extends View {
  static override properties = { playing: {} };
  declare library: LibraryStore;
  declare playing: boolean;

  protected override render() {
    const { library } = this;
    const info = library.current?.info;
    if (!info) return html``;
    const words = primitivesWords().gallery;
    const card = (uses: number[]) => {
      const recorded = recordedAs(info, uses);
      return html`
        <button class="combination stack" data-testid="combination" aria-pressed=${isSame(uses, library.uses) ? "true" : "false"}
          @click=${() => library.take(uses)}>
          <pg-small-figure .body=${library.body} .motion=${library.motionOf(uses)} .accent=${null} .playing=${this.playing}></pg-small-figure>
          <span>${titleOf(info, uses)}</span>
          <small>${recorded === null ? words.never : words.recordedAs(recorded)}</small>
        </button>`;
    };
    return html`
      <h2>${words.title}</h2>
      <div class="gallery">${library.combinations.map(card)}</div>
      ${library.notShown > 0 ? html`<p class="hint">${words.more(library.notShown)}</p>` : nothing}`;
  }
}
customElements.define("pg-gallery", GalleryView);

class ChimeraView extends View {
  declare library: LibraryStore;

  #tempo(tempo: number, part: number) {
    const name = shownPart(this.library.current?.info.parts[part]?.name ?? "");
    const words = primitivesWords().chimera;
    return html`
      <label class="tempo row loose" style=${partStyle(partColour(part))}>
        <span class="part-name"><i class="swatch"></i>${name}</span>
        <input type="range" min="0.5" max="2" step="0.05" .value=${String(tempo)} data-testid="tempo-${part}"
          aria-label=${words.tempoOf(name)} aria-valuetext=${words.times(tempo)}
          @input=${(event: Event) => this.library.setTempo(part, (event.target as HTMLInputElement).valueAsNumber)}
          @dblclick=${() => this.library.setTempo(part, 1)} />
        <output>${fixed(tempo, 2)}</output>
      </label>`;
  }

  protected override render() {
    const { library } = this;
    if (!library.current) return nothing;
    const words = primitivesWords().chimera;
    return html`
      <h2>${words.title}</h2>
      <p class="hint">${words.about}</p>
      ${library.tempos.map((tempo, part) => this.#tempo(tempo, part))}`;
  }
}
customElements.define("pg-chimera", ChimeraView);

export class PrimitivesPage extends View {
  declare primitives: Primitives;
  declare clips: ClipsStore;
  declare notices: NoticesStore;

  get #library() {
    return this.primitives.library;
  }

  protected override stores() {
    return [this.#library, this.notices];
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
    this.tell("stage-model", detail);
  }

  async #open(file: File | undefined): Promise<void> {
    if (!file) return;
    try {
      await this.#library.openFile(await file.text(), file.name);
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
      <section class="panel library-head row wrap spread" aria-label=${areas.library}>
        <p><strong>${isGiven ? words.made : current.title}</strong>
          <span class="quiet" data-testid="library-words">${text}
          ${isGiven ? html`${words.source} <span lang="en">${DATA_SOURCE}</span>` : nothing}
          ${current.unsaved ? words.unsaved : nothing}</span></p>
        <div class="row wrap">
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
    const { library, fitting, learning, recognition, recordedParts } = this.primitives;
    const { playing } = library.playback;
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
          <section class="panel walk-panel column" aria-label=${areas.figure}><pg-walk data-clock .library=${library}></pg-walk></section>
          <div class="beside-figure stack">
            <section class="panel" aria-label=${words.drawer.title}><pg-drawer .library=${library} .playing=${playing} .notices=${this.notices}></pg-drawer></section>
            <section class="panel" aria-label=${words.gallery.title}><pg-gallery .library=${library} .playing=${playing}></pg-gallery></section>
            <section class="panel" aria-label=${areas.chimera}><pg-chimera .library=${library}></pg-chimera></section>
            <section class="panel live-panel" aria-label=${lab().live.movers}><pg-live .live=${library.walk} .playback=${library.playback} .recorded=${recordedParts}></pg-live></section>
            <section class="panel" aria-label=${areas.couplings}><pg-walk-couplings .library=${library} .fitting=${fitting} .clips=${clips}></pg-walk-couplings></section>
            <section class="panel" aria-label=${areas.imports}><pg-import .library=${library} .notices=${this.notices}></pg-import></section>
          </div>
        </div>
        <section class="panel recognition-panel" aria-label=${words.recognition.title}><pg-recognition .recognition=${recognition} .library=${library}></pg-recognition></section>
        <section class="panel learning-panel" aria-label=${words.learning.title}><pg-learning .learning=${learning}></pg-learning></section>
      </div>`;
  }
}
customElements.define("pg-primitives", PrimitivesPage);

export const draw: Draw<"primitives"> = (primitives, { clips, notices }) =>
  html`<pg-primitives .primitives=${primitives} .clips=${clips} .notices=${notices}></pg-primitives>`;
