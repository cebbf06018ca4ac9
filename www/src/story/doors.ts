// The two doors of the page: the story, and the Lab with the other views, which is loaded at its first use.
import { html, nothing } from "lit";
import type { App } from "../app/app";
import type { PageView } from "../app/page";
import { View } from "../ui/view";
import "./story-view";

export class DoorsView extends View {
  static override properties = { lab: { state: true }, isTeachMissing: { state: true } };
  declare app: App;
  /** Called once, when the Lab is on the page. */
  declare startLab: (page: PageView) => void;
  lab: "closed" | "loading" | "open" | "failed" = "closed";

  isTeachMissing = false;

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
    if (this.app.isLab && this.lab === "closed") void this.#openLab();
  }

  async #openLab(): Promise<void> {
    this.lab = "loading";
    try {
      await Promise.all([
        import("../app/page"),
        import("../words/lab").then(({ loadLab }) => loadLab(this.app.words)),
      ]);
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
    if (this.lab === "open") return html`<pg-page .app=${this.app} ?hidden=${!this.app.isLab}></pg-page>`;
    if (this.lab === "failed" && this.app.isLab)
      return html`<p class="banner" role="alert">${frame.labNotLoaded}
        <button class="small" @click=${() => location.reload()}>${frame.tryAgain}</button></p>`;
    return nothing;
  }

  /** The page for teachers, loaded at its first use. */
  #teach() {
    if (!this.app.isTeaching) return nothing;
    const { frame } = this.app.words.now;
    import("../teach/teach-page").catch(() => {
      this.isTeachMissing = true;
    });
    return this.isTeachMissing
      ? html`<p class="banner" role="alert">${frame.notLoaded} <button class="small" @click=${() => location.reload()}>${frame.tryAgain}</button></p>`
      : html`<pg-teach .app=${this.app}></pg-teach>`;
  }

  protected override render() {
    return html`${this.app.isStory ? html`<pg-story .app=${this.app}></pg-story>` : nothing}${this.#teach()}${this.#labView()}`;
  }
}
customElements.define("pg-doors", DoorsView);
