// The two doors of the page: the story, and the Lab with the other views, which is loaded at its first use.
import { html, nothing } from "lit";
import type { App } from "../app/app";
import type { PageView } from "../app/page";
import { View } from "../ui/view";
import "./story-view";

export class DoorsView extends View {
  static override properties = { lab: { state: true } };
  declare app: App;
  /** Called once, when the Lab is on the page. */
  declare startLab: (page: PageView) => void;
  declare lab: "closed" | "loading" | "open" | "failed";

  constructor() {
    super();
    this.lab = "closed";
  }

  protected override stores() {
    return [this.app.settings, this.app.words];
  }

  protected override arrived(): void {
    this.#follow();
    this.whenLeaving(this.app.settings.on(() => this.#follow()));
    // A failed download may work now.
    this.listen(window, "online", () => this.lab === "failed" && location.reload());
  }

  #follow(): void {
    if (!this.app.isStory && this.lab === "closed") void this.#openLab();
  }

  async #openLab(): Promise<void> {
    this.lab = "loading";
    try {
      await import("../app/page");
      this.lab = "open";
      await this.updateComplete;
      const page = this.querySelector<PageView>("pg-page");
      if (page) this.startLab(page);
    } catch {
      this.lab = "failed";
    }
  }

  #labView() {
    const { frame } = this.app.words.now;
    if (this.lab === "open") return html`<pg-page .app=${this.app} ?hidden=${this.app.isStory}></pg-page>`;
    if (this.lab === "failed" && !this.app.isStory)
      return html`<p class="banner" role="alert">${frame.labNotLoaded}
        <button class="small" @click=${() => location.reload()}>${frame.tryAgain}</button></p>`;
    return nothing;
  }

  protected override render() {
    return html`${this.app.isStory ? html`<pg-story .app=${this.app}></pg-story>` : nothing}${this.#labView()}`;
  }
}
customElements.define("pg-doors", DoorsView);
