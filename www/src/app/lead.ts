// The first sentences of the Lab: what moves on the stage, and what to try next.
import { html, nothing } from "lit";
import { INVITATION, presetWords } from "../couplings/presets";
import { View } from "../ui/view";
import type { App } from "./app";
import { wordStores, wordsNow } from "./caption";
import { lab } from "../words/lab";

export class LeadView extends View {
  declare app: App;

  protected override stores() {
    return wordStores(this.app);
  }

  #next() {
    const { model, stage, training } = this.app;
    const { content } = stage;
    const { lead } = lab().stage;
    if (content?.kind !== "model" || training.learning || !model.model) return nothing;
    if (model.couplings.altered)
      return html`<button class="link" data-testid="lead-back" @click=${() => model.couplings.resetAll()}>${lead.back}</button>`;
    const preset = model.presets.find(({ id }) => id === INVITATION.preset);
    return html`${model.preset ? presetWords(model.preset).meaning : ""}
      ${
        preset
          ? html`<button class="link" data-testid="lead-try" @click=${() => model.takePreset(preset)}>${presetWords(preset).name}</button>: ${lead.question}`
          : nothing
      }`;
  }

  protected override render() {
    return html`
      <div class="lead" data-testid="lead" role="status">
        <p class="lead-first">${wordsNow(this.app).lead}</p>
        <p>${this.#next()}</p>
      </div>`;
  }
}
customElements.define("pg-lead", LeadView);
