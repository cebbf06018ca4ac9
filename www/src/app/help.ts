// The dialog with help, keys and facts about this page.
import { html } from "lit";
import type { ModelStore } from "../couplings/model-store";
import type { EngineStore } from "../engine/engine-store";
import { clipTitle } from "../ui/format";
import { icon } from "../ui/icons";
import "../ui/dialog.css";
import { View } from "../ui/view";
import { DATA_SOURCE } from "./data-source";
import "./help.css";

const KEYS: [string, string][] = [
  ["space", "play or pause"],
  ["← →", "one frame back or forward"],
  ["0", "reset all couplings"],
  ["delete", "on a slider: reset this coupling"],
  ["c", "held: cut a coupling, that of the slider in focus or the strongest between parts, and watch live"],
  ["p", "for a projector: only the stage and one panel, in large type; escape brings the rest back"],
  ["w a s d", "on the stage: look from another side"],
  ["+ −", "on the stage: come closer, go away"],
  ["?", "this help"],
];

export class HelpView extends View {
  declare model: ModelStore;
  declare engine: EngineStore;

  protected override stores() {
    return [this.model, this.engine];
  }

  open(): void {
    const dialog = this.querySelector("dialog");
    if (dialog && !dialog.open) dialog.showModal();
  }

  #showMethod(): void {
    this.querySelector("dialog")?.close();
    this.dispatchEvent(new CustomEvent("show-method", { bubbles: true }));
  }

  #provenance() {
    const { model } = this.model;
    const { version } = this.engine;
    if (!model) return "";
    const { provenance, sequences } = model.info;
    return html`<p>The model now: trained by ${provenance.engine} with seed ${provenance.settings.seed} on
      ${sequences.map(({ name }) => clipTitle(name)).join(", ") || "clips it does not name"}. This page runs version ${version}.</p>`;
  }

  protected override render() {
    return html`
      <dialog aria-labelledby="help-title" @click=${(event: Event) => {
        if (event.target instanceof HTMLDialogElement) event.target.close();
      }}>
        <div class="dialog-body">
          <header><h2 id="help-title">How this works</h2>
            <form method="dialog"><button class="round" aria-label="Close">${icon("close")}</button></form></header>
          <p>The model splits a body into parts. Each part’s poses are points in a small latent space, and a walk is a loop in it.
            Where a part goes next is predicted by every part, from its own last frames; the weights w say whose word counts.
            A coupling’s α is the variance of one such prediction: small α, large weight.</p>
          <p>Inducing points are the few examples that the model keeps in place of the data: poses (diamonds), and short pieces of movement (arrows).
            Point at one to see its pose, and the frames it speaks for on the time line.</p>
          <p>Training climbs the evidence lower bound: how well the model explains the clips, less what it takes to say so.</p>
          <p><button class="small" @click=${this.#showMethod}>The method: equations, symbols, references</button></p>
          <h3>Keys</h3>
          <dl class="keys">${KEYS.map(([key, does]) => html`<dt><kbd>${key}</kbd></dt><dd>${does}</dd>`)}</dl>
          <h3>About</h3>
          <p>Nothing you load leaves your machine: everything is computed in this browser.</p>
          <p>The sample clips are made by this project, with a procedural walker. The model that walks at the start was trained on recordings of CMU subject 7. ${DATA_SOURCE}</p>
          ${this.#provenance()}
        </div>
      </dialog>`;
  }
}
customElements.define("pg-help", HelpView);
