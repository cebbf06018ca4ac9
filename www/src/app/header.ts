// The header of the page: the title, the views, and the buttons for files.
import { html, nothing } from "lit";
import { guard } from "lit/directives/guard.js";
import { lastChapter } from "../settings/door";
import { writeSettings } from "../settings/settings";
import type { ViewName } from "../settings/views";
import { fileButton } from "../ui/file-button";
import { icon } from "../ui/icons";
import { View as ViewElement } from "../ui/view";
import { ALL_VIEWS } from "../views/all-views";
import type { View } from "../views/define-view";
import type { App } from "./app";
import { loadNewVersion } from "./leaving";
import "./save-menu";
import { lab } from "../words/lab";

export class HeaderView extends ViewElement {
  declare app: App;

  protected override stores() {
    const { engine, settings, offline } = this.app;
    return [engine, settings, settings.address, offline, this.app.words];
  }

  /**
   * Links, which can be shared and opened in other tabs. They change with the address, not with each slider
   * event.
   */
  #views() {
    const { settings, words } = this.app;
    const link = (view: ViewName, name: string) => html`
          <a href=${guard([settings.address.fragment], () => `#${writeSettings({ ...settings.written, view })}`)}
            data-testid="view-${view}" aria-current=${settings.values.view === view ? "page" : "false"}
            @click=${(event: MouseEvent) => {
              if (event.ctrlKey || event.metaKey || event.shiftKey) return;
              event.preventDefault();
              settings.change({ view });
            }}>${name}</a>`;
    return html`
      <nav class="segments" aria-label=${words.now.frame.views}>
        <a href="#story=${lastChapter()}" data-testid="view-story">${words.now.frame.story}</a>
        ${link("play", lab().lab)}
        ${ALL_VIEWS.filter((view) => this.#isListed(view)).map((view) => link(view.name, view.words[words.language].name))}
      </nav>`;
  }

  #isListed({ name, place }: View): boolean {
    return place !== null || this.app.settings.values.view === name || this.app.view(name).loaded !== null;
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
      <div class="actions row tight" role="group" aria-label=${header.files}>
        ${this.#newVersion()}
        ${fileButton({
          label: header.open,
          meaning: header.openMeaning,
          testId: "open-model",
          accept: ".json,.bvh,.csv,.JSON,.BVH,.CSV,application/json,text/csv",
          multiple: true,
          disabled: false,
          chosen: (files) => this.tell("open-files", files),
        })}
        <pg-save-menu .app=${this.app}></pg-save-menu>
        <button class="round" aria-label=${header.help} title="${header.help} (?)" data-testid="help" @click=${() => this.tell("show-help")}>${icon("help")}</button>
      </div>`;
  }
}
customElements.define("pg-header", HeaderView);
