// Primitives of another file: the result, or the offer to learn them again.
import { html, nothing } from "lit";
import type { ClipsStore } from "../clips/clips-store";
import { goingWords } from "../training/progress-row";
import { fileButton } from "../ui/file-button";
import { messageOf, sentence } from "../ui/format";
import type { NoticesStore } from "../ui/notices-store";
import { progressBar } from "../ui/progress-bar";
import { View } from "../ui/view";
import "./import.css";
import type { ImportStore, Offer } from "./import-store";
import { lab } from "../words/lab";
import { primitivesWords } from "../words/primitives";

export class ImportView extends View {
  static override properties = { from: { state: true } };
  declare imports: ImportStore;
  declare clips: ClipsStore;
  declare notices: NoticesStore;
  /** The seed of learning again. */
  declare seed: number;
  /** The key of the clip to learn from; empty for the data of the file. */
  declare from: string;

  constructor() {
    super();
    this.from = "";
  }

  protected override stores() {
    return [this.imports, this.clips];
  }

  async #add(file: File | undefined): Promise<void> {
    if (!file) return;
    try {
      await this.imports.add(await file.text(), file.name);
    } catch (problem) {
      this.notices.addError(file.name, messageOf(problem));
    }
  }

  #offer({ title, misfit }: Offer) {
    const { imports, clips } = this;
    const { busy, status, fraction, ending } = imports;
    const can = misfit.canBeRelearned;
    const words = primitivesWords().imports;
    return html`
      <div class="import-offer" role="group" aria-label=${words.of(title)}>
        <p><strong>${title}</strong> <span data-testid="misfit">${words.misfit(sentence(misfit.reason))}</span></p>
        ${
          can
            ? html`
            <p class="hint">${words.about}</p>
            <div class="fit-row">
              <label>${words.from} <select data-testid="import-from" ?disabled=${busy} @change=${(
                event: Event,
              ) => {
                this.from = (event.target as HTMLSelectElement).value;
              }}><option value="">${words.kept}</option>
                ${clips.all.map((clip) => html`<option value=${clip.key} ?selected=${clip.key === this.from}>${clip.title}</option>`)}</select></label>
              <button class="small primary" data-testid=${busy ? "import-cancel" : "relearn"} ?disabled=${status === "cancelling"}
                @click=${() => (busy ? imports.cancel() : void imports.relearn(this.from, this.seed))}>${busy ? lab().learn.training.cancel : words.relearn}</button>
            </div>
            ${progressBar(words.relearning, busy ? fraction : null)}
            <p class=${ending.failed ? "bad" : "hint"} role="status">${busy ? goingWords(imports).join(". ") : ending.failed ? sentence(ending.words) : ""}</p>`
            : nothing
        }
        <button class="small" data-testid="import-dismiss" ?disabled=${busy} @click=${() => imports.dismiss()}>${words.dismiss}</button>
      </div>`;
  }

  protected override render() {
    const { imports } = this;
    const words = primitivesWords().imports;
    return html`
      <div class="button-row">
        ${fileButton({
          label: words.add,
          meaning: words.addMeaning,
          testId: "add-primitives",
          accept: ".json,application/json",
          multiple: false,
          disabled: imports.busy,
          chosen: ([file]) => void this.#add(file),
        })}
      </div>
      ${imports.offer ? this.#offer(imports.offer) : html`<p class="hint" role="status" data-testid="import-words">${imports.text}</p>`}`;
  }
}
customElements.define("pg-import", ImportView);
