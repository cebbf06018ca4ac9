// The dialog with help, keys and facts about this page.
import { html } from "lit";
import type { ModelStore } from "../couplings/model-store";
import type { EngineStore } from "../engine/engine-store";
import { clipTitle } from "../ui/format";
import { icon } from "../ui/icons";
import "../ui/dialog.css";
import { View } from "../ui/view";
import { DATA_SOURCE } from "../words/data-source";
import { helpWords } from "../words/sections";

export class HelpView extends View {
  declare model: ModelStore;
  declare engine: EngineStore;

  open(): void {
    const dialog = this.querySelector("dialog");
    if (dialog && !dialog.open) dialog.showModal();
  }

  #showMethod(): void {
    this.querySelector("dialog")?.close();
    this.tell("show-method");
  }

  #provenance() {
    const { model } = this.model;
    const { version } = this.engine;
    if (!model) return "";
    const { provenance, sequences } = model.info;
    const clips = sequences.map(({ name }) => clipTitle(name)).join(", ");
    return html`<p>${helpWords().provenance(provenance.engine, provenance.settings.seed, clips, version)}</p>`;
  }

  protected override render() {
    const words = helpWords();
    return html`
      <dialog aria-labelledby="help-title" @click=${(event: Event) => {
        if (event.target instanceof HTMLDialogElement) event.target.close();
      }}>
        <div class="dialog-body stack">
          <header><h2 id="help-title">${words.title}</h2>
            <form method="dialog"><button class="round" aria-label=${words.close}>${icon("close")}</button></form></header>
          <p>${words.model}</p>
          <p>${words.points}</p>
          <p>${words.training}</p>
          <p><button class="small" @click=${this.#showMethod}>${words.method}</button></p>
          <h3>${words.keysTitle}</h3>
          <dl class="keys">${words.keys.map(([key, does]) => html`<dt><kbd>${key}</kbd></dt><dd>${does}</dd>`)}</dl>
          <h3>${words.about}</h3>
          <p>${words.local}</p>
          <p>${words.samples} <span lang="en">${DATA_SOURCE}</span> <a href="licences.txt">${words.licences}</a></p>
          ${this.#provenance()}
        </div>
      </dialog>`;
  }
}
customElements.define("pg-help", HelpView);
