// The header of the page: the title, the views, and the buttons for files.
import { html, nothing } from "lit";
import { guard } from "lit/directives/guard.js";
import { lastChapter } from "../settings/door";
import { type Settings, writeSettings } from "../settings/settings";
import "../terms/term";
import { fileButton } from "../ui/file-button";
import { icon } from "../ui/icons";
import { View } from "../ui/view";
import type { App } from "./app";
import { loadNewVersion } from "./leaving";
import "./save-menu";

const VIEWS: [Settings["view"], string][] = [
  ["play", "Lab"],
  ["compare", "Compare models"],
  ["primitives", "Primitives"],
  ["synthetic", "Who drives whom?"],
  ["perception", "Which is natural?"],
  ["method", "Method"],
  ["series", "Time series"],
];

const LEADS = {
  compare: "Which model foresees a walk best, and what does it cost?",
  primitives: "Parts learned once, put together in new ways: legs of one movement, arms of another.",
  synthetic: "Two made-up systems of which the truth is known: does training find it?",
  series: "Curves that are no body: which parts they have, and which part drives which.",
  perception: "The graphics Turing test: can people tell a model’s movement from a natural one?",
  method: "The model in equations, and where each symbol is to be seen.",
};

export class HeaderView extends View {
  declare app: App;

  protected override stores() {
    const { engine, settings, offline } = this.app;
    return [engine, settings, settings.address, offline, this.app.words];
  }

  #tell(type: string, detail?: unknown): void {
    this.dispatchEvent(new CustomEvent(type, { detail, bubbles: true }));
  }

  /**
   * Links, which can be shared and opened in other tabs. They change with the address, not with each slider
   * event.
   */
  #views() {
    const { settings, words } = this.app;
    return html`
      <nav class="segments" aria-label="Views">
        <a href="#story=${lastChapter()}" data-testid="view-story">${words.now.frame.story}</a>
        ${VIEWS.filter(([view]) => view !== "series" || this.#hasSeries).map(
          ([view, title]) => html`
          <a href=${guard([settings.address.fragment], () => `#${writeSettings({ ...settings.written, view })}`)}
            data-testid="view-${view}" aria-current=${settings.values.view === view ? "page" : "false"}
            @click=${(event: MouseEvent) => {
              if (event.ctrlKey || event.metaKey || event.shiftKey) return;
              event.preventDefault();
              settings.change({ view });
            }}>${title}</a>`,
        )}
      </nav>`;
  }

  /** Few visitors have time series, so that this view is in the list only after its first use. */
  get #hasSeries(): boolean {
    return this.app.settings.values.view === "series" || this.app.series.loaded !== null;
  }

  /** The new version waits until the visitor asks for it. */
  #newVersion() {
    const { offline } = this.app;
    if (!offline.hasNewVersion) return nothing;
    return html`<button data-testid="new-version" title="A new version of this page is there. Loading it begins anew: save first what you want to keep."
      @click=${() => void loadNewVersion(this.app)}>Load new version</button>`;
  }

  protected override render() {
    const { view } = this.app.settings.values;
    return html`
      <div class="title">
        <h1>Coupled <pg-term of="movement-primitive" text="movement primitives"></pg-term></h1>
        ${view === "play" ? nothing : html`<p>${LEADS[view]}</p>`}
      </div>
      ${this.#views()}
      <div class="actions" role="group" aria-label="Files">
        ${this.#newVersion()}
        ${fileButton({
          label: "Open",
          meaning: "Open a model (.json), clips (.bvh) or tables (.csv)",
          testId: "open-model",
          accept: ".json,.bvh,.csv,.JSON,.BVH,.CSV,application/json,text/csv",
          multiple: true,
          disabled: false,
          chosen: (files) => this.#tell("open-files", files),
        })}
        <pg-save-menu .app=${this.app}></pg-save-menu>
        <button class="round" aria-label="Help and keys" title="Help and keys (?)" data-testid="help" @click=${() => this.#tell("show-help")}>${icon("help")}</button>
      </div>`;
  }
}
customElements.define("pg-header", HeaderView);
