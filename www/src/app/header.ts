// The header of the page: the title, the views, and the buttons for files.
import { html, nothing } from "lit";
import { guard } from "lit/directives/guard.js";
import { lastChapter } from "../settings/door";
import { writeSettings } from "../settings/settings";
import { fileButton } from "../ui/file-button";
import { icon } from "../ui/icons";
import { View } from "../ui/view";
import type { App } from "./app";
import { loadNewVersion } from "./leaving";
import "./save-menu";
import { lab } from "../words/lab";

const VIEWS = ["play", "compare", "primitives", "synthetic", "perception", "method", "series"] as const;

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
    const { views } = lab();
    return html`
      <nav class="segments" aria-label=${words.now.frame.views}>
        <a href="#story=${lastChapter()}" data-testid="view-story">${words.now.frame.story}</a>
        ${VIEWS.filter((view) => view !== "series" || this.#hasSeries).map(
          (view) => html`
          <a href=${guard([settings.address.fragment], () => `#${writeSettings({ ...settings.written, view })}`)}
            data-testid="view-${view}" aria-current=${settings.values.view === view ? "page" : "false"}
            @click=${(event: MouseEvent) => {
              if (event.ctrlKey || event.metaKey || event.shiftKey) return;
              event.preventDefault();
              settings.change({ view });
            }}>${views[view]}</a>`,
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
    const { newVersion, newVersionMeaning } = lab().header;
    return html`<button data-testid="new-version" title=${newVersionMeaning}
      @click=${() => void loadNewVersion(this.app)}>${newVersion}</button>`;
  }

  protected override render() {
    const { title, header } = lab();
    return html`
      <div class="title">
        <h1>${title}</h1>
      </div>
      ${this.#views()}
      <div class="actions" role="group" aria-label=${header.files}>
        ${this.#newVersion()}
        ${fileButton({
          label: header.open,
          meaning: header.openMeaning,
          testId: "open-model",
          accept: ".json,.bvh,.csv,.JSON,.BVH,.CSV,application/json,text/csv",
          multiple: true,
          disabled: false,
          chosen: (files) => this.#tell("open-files", files),
        })}
        <pg-save-menu .app=${this.app}></pg-save-menu>
        <button class="round" aria-label=${header.help} title="${header.help} (?)" data-testid="help" @click=${() => this.#tell("show-help")}>${icon("help")}</button>
      </div>`;
  }
}
customElements.define("pg-header", HeaderView);
