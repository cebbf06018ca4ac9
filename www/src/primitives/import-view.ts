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
    return html`
      <div class="import-offer" role="group" aria-label="Primitives of ${title}">
        <p><strong>${title}</strong> <span data-testid="misfit">does not fit as it is: ${sentence(misfit.reason)}</span></p>
        ${
          can
            ? html`
            <p class="hint">Its primitives can be learned again here: their dynamics anew, while the pose maps and primitives of this library stay.
              What the file keeps of its movement shows what its own pose maps show of it; a clip shows all of it.</p>
            <div class="fit-row">
              <label>From <select data-testid="import-from" ?disabled=${busy} @change=${(event: Event) => {
                this.from = (event.target as HTMLSelectElement).value;
              }}><option value="">what the file keeps</option>
                ${clips.all.map((clip) => html`<option value=${clip.key} ?selected=${clip.key === this.from}>${clip.title}</option>`)}</select></label>
              <button class="small primary" data-testid=${busy ? "import-cancel" : "relearn"} ?disabled=${status === "cancelling"}
                @click=${() => (busy ? imports.cancel() : void imports.relearn(this.from, this.seed))}>${busy ? "Cancel" : "Learn again"}</button>
            </div>
            ${progressBar("Learning again", busy ? fraction : null)}
            <p class=${ending.failed ? "bad" : "hint"} role="status">${busy ? goingWords(imports).join(". ") : ending.failed ? sentence(ending.words) : ""}</p>`
            : nothing
        }
        <button class="small" data-testid="import-dismiss" ?disabled=${busy} @click=${() => imports.dismiss()}>Leave it</button>
      </div>`;
  }

  protected override render() {
    const { imports } = this;
    return html`
      <div class="button-row">
        ${fileButton({
          label: "Add primitives",
          meaning: "Add the primitives of another file (.json) to this library",
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
