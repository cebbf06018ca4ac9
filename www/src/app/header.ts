// The head of the page: what this is, its views, and the files to save and open.
import { html } from "lit";
import { guard } from "lit/directives/guard.js";
import type { ModelStore } from "../couplings/model-store";
import type { EngineStore } from "../engine/engine-store";
import { type Settings, writeSettings } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import { fileButton } from "../ui/file-button";
import { icon } from "../ui/icons";
import type { NoticesStore } from "../ui/notices-store";
import { View } from "../ui/view";
import { saveModel, saveMotion } from "./saving";

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
  declare engine: EngineStore;
  declare model: ModelStore;
  declare settings: SettingsStore;
  declare notices: NoticesStore;

  protected override stores() {
    return [this.engine, this.model, this.settings, this.settings.address];
  }

  private tell(type: string, detail?: unknown): void {
    this.dispatchEvent(new CustomEvent(type, { detail, bubbles: true }));
  }

  /** Links, so that they can be opened elsewhere and shared; written when the address is, not at each move of a slider. */
  private views() {
    const { settings } = this;
    return html`
      <nav class="segments" aria-label="Views">
        ${VIEWS.map(
          ([view, title]) => html`
          <a href=${guard([settings.address.fragment], () => `#${writeSettings({ ...settings.values, view })}`)}
            data-testid="view-${view}" aria-current=${settings.values.view === view ? "page" : "false"}
            @click=${(event: MouseEvent) => {
              if (event.ctrlKey || event.metaKey || event.shiftKey) return;
              event.preventDefault();
              settings.change({ view });
            }}>${title}</a>`,
        )}
      </nav>`;
  }

  private lead() {
    const { view } = this.settings.values;
    if (view !== "play") return LEADS[view];
    const show = (event: Event) => {
      event.preventDefault();
      this.tell("show-couplings");
    };
    return html`This walk was never recorded: a small model learned it.
      <a href="#couplings" @click=${show}>Drag a slider</a> and watch its parts fall out of step.`;
  }

  protected override render() {
    const nothingToSave = !this.model.model || !this.engine.engine;
    return html`
      <div class="title">
        <h1>Coupled movement primitives</h1>
        <p class="lead">${this.lead()}</p>
      </div>
      ${this.views()}
      <div class="actions" role="group" aria-label="Files">
        ${fileButton({
          label: "Open",
          meaning: "Open a model (.json) or clips (.bvh)",
          testId: "open-model",
          accept: ".json,.bvh,application/json",
          multiple: true,
          disabled: false,
          chosen: (files) => this.tell("open-files", files),
        })}
        <button class="small" data-testid="save-model" ?disabled=${nothingToSave} title="The trained model, as JSON" @click=${() => void saveModel(this)}>${icon("save")} Save model</button>
        <button class="small" data-testid="save-motion" ?disabled=${nothingToSave} title="The motion on the stage, as BVH" @click=${() => void saveMotion(this)}>${icon("save")} Save motion</button>
        <button class="round" aria-label="Help and keys" title="Help and keys (?)" data-testid="help" @click=${() => this.tell("show-help")}>${icon("help")}</button>
      </div>`;
  }
}
customElements.define("pg-header", HeaderView);
