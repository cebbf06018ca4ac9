// The head of the page: what this is, and the files to save and open.
import { html } from "lit";
import { openFiles } from "../clips/clips";
import { saveModel, saveMotion } from "./saving";
import { changeSettings } from "../settings/change";
import { type Settings, writeSettings } from "../settings/settings";
import { icon } from "../ui/icons";
import { View } from "../ui/view";

const VIEWS: [Settings["view"], string][] = [
  ["play", "Play"],
  ["compare", "Compare models"],
  ["synthetic", "Who drives whom?"],
];

const LEADS = {
  compare: "Which model foresees a walk best, and what does it cost?",
  synthetic: "Two made-up systems of which the truth is known: does training find it?",
};

export class HeaderView extends View {
  static override topics = ["model", "engine", "settings"] as const;

  /** Links, so that they can be opened elsewhere and shared. */
  private views() {
    const { app } = this;
    return html`
      <nav class="segments" aria-label="Views">
        ${VIEWS.map(
          ([view, title]) => html`
          <a href="#${writeSettings({ ...app.settings, view })}" data-testid="view-${view}" aria-current=${app.settings.view === view ? "page" : "false"}
            @click=${(event: MouseEvent) => {
              if (event.ctrlKey || event.metaKey || event.shiftKey) return;
              event.preventDefault();
              changeSettings(app, { view });
            }}>${title}</a>`,
        )}
      </nav>`;
  }

  protected override render() {
    const { app } = this;
    const none = !app.model || !app.engine;
    const open = (event: Event) => {
      const input = event.target as HTMLInputElement;
      const files = [...(input.files ?? [])];
      input.value = "";
      void openFiles(app, files, null);
    };
    return html`
      <div class="title">
        <h1>Coupled movement primitives</h1>
        ${
          app.settings.view !== "play"
            ? html`<p class="lead">${LEADS[app.settings.view]}</p>`
            : html`<p class="lead">This walk was never recorded: a small model learned it. <a href="#couplings" @click=${(
                event: Event,
              ) => {
                event.preventDefault();
                this.dispatchEvent(new CustomEvent("show-couplings", { bubbles: true }));
              }}>Drag a slider</a> and watch its parts fall out of step.</p>`
        }
      </div>
      ${this.views()}
      <div class="actions" role="group" aria-label="Files">
        <label class="small file-button">${icon("open")} Open
          <input type="file" class="visually-hidden" data-testid="open-model" multiple accept=".json,.bvh,application/json" aria-label="Open a model (.json) or clips (.bvh)" @change=${open} /></label>
        <button class="small" data-testid="save-model" ?disabled=${none} title="The trained model, as JSON" @click=${() => void saveModel(app)}>${icon("save")} Save model</button>
        <button class="small" data-testid="save-motion" ?disabled=${none} title="The motion on the stage, as BVH" @click=${() => void saveMotion(app)}>${icon("save")} Save motion</button>
        <button class="round" aria-label="Help and keys" title="Help and keys (?)" data-testid="help" @click=${() =>
          this.dispatchEvent(new CustomEvent("show-help", { bubbles: true }))}>${icon("help")}</button>
      </div>`;
  }
}
customElements.define("pg-header", HeaderView);
