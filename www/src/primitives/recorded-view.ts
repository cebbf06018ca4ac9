// Movements of recorded people: their models, and where the recordings are had. Their clips are in the list
// of clips.
import { html } from "lit";
import type { StagedModel } from "../stage/stage-store";
import { sentence } from "../ui/format";
import { View } from "../ui/view";
import { DATA_SOURCE, RECORDINGS } from "../words/data-source";
import { primitivesWords } from "./view-words";
import type { RecordedStore } from "./recorded-store";

export class RecordedView extends View {
  declare recorded: RecordedStore;

  protected override arrived(): void {
    void this.recorded.load();
  }

  #stage(name: string, text: string): void {
    const detail: StagedModel = { text: Promise.resolve(text), name, made: false };
    this.tell("stage-model", detail);
  }

  protected override render() {
    const { movements, problem } = this.recorded;
    const { recorded: words, tryAgain, loading } = primitivesWords();
    const models = html`
      <p class="hint">${words.about}</p>
      <div class="row wrap">
        ${movements.map(
          ({ name, model }) => html`
          <button class="small" data-testid="recorded-${name}" title=${words.modelMeaning(name)}
            @click=${() => this.#stage(name, model)}>${words.name(name)}</button>`,
        )}
      </div>`;
    const waiting = problem
      ? html`<p class="bad" role="alert">${sentence(problem)}
        <button class="small" @click=${() => void this.recorded.load()}>${tryAgain}</button></p>`
      : html`<p class="empty" role="status">${loading}</p>`;
    return html`
      ${movements.length > 0 ? models : waiting}
      <p class="hint">${words.source} <span lang="en">${DATA_SOURCE}</span>
        <a href=${RECORDINGS} target="_blank" rel="noreferrer">${words.where}</a></p>`;
  }
}
customElements.define("pg-recorded", RecordedView);
