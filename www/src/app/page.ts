// The layout of the page: header, the Lab or another view, and footer.
import { html, nothing, type TemplateResult } from "lit";
import "../ui/notices-view";
import type { SessionStore } from "../session/session-store";
import type { ViewName } from "../settings/views";
import { icon } from "../ui/icons";
import { isUsedByControl } from "../ui/keyboard";
import { View as ViewElement } from "../ui/view";
import { ALL_VIEWS } from "../views/all-views";
import type { Draw } from "../views/define-view";
import type { App } from "./app";
import "./header";
import type { HelpView } from "./help";
import type { LabView } from "./lab-view";
import "./lab-view";
import { COMMANDS, type Commanded } from "./commands";
import { lab } from "../words/lab";
import { loadHelp } from "../words/sections";
import { languageSwitch } from "./site-head";

type View = (typeof ALL_VIEWS)[number];
const PAGES = import.meta.glob<Draw<ViewName>>("../*/*-page.ts", { import: "draw" });

async function loadDraw({ folder }: View): Promise<Draw<ViewName>> {
  const [, load] = Object.entries(PAGES).find(([file]) => file.startsWith(folder)) ?? [];
  if (!load) throw new Error(`${folder}: expected a file that ends with -page.ts`);
  return load();
}

export class PageView extends ViewElement implements Commanded {
  static override properties = { session: { state: true } };
  /** The stored visits; null: the browser stores none, or the session is not loaded yet. */
  session: SessionStore | null = null;
  declare app: App;
  readonly #loaded = new Map<View, "loading" | "failed" | (() => TemplateResult)>();

  get lab(): LabView | null {
    return this.querySelector<LabView>("pg-lab");
  }

  protected override stores() {
    const { engine, settings, model, words } = this.app;
    return [engine, settings, model, words];
  }

  protected override arrived(): void {
    // A failed import may work now. Chromium repeats the failure until the page is reloaded.
    this.listen(window, "online", () => {
      for (const [view, state] of this.#loaded) if (state === "failed") this.#load(view);
    });
    for (const [name, { run }] of Object.entries(COMMANDS))
      this.listen(this, name, (event) => run(this, (event as CustomEvent).detail));
    this.listen(document, "keydown", (event) => this.#obey(event as KeyboardEvent));
    this.listen(document, "keyup", (event) => {
      const { key } = event as KeyboardEvent;
      for (const { run } of Object.values(COMMANDS).filter(
        (command) => command.isHeld && command.key === key,
      ))
        run(this, false);
    });
  }

  get clock(): Commanded["clock"] {
    return this.app.isPlayView
      ? this.app.playback
      : this.querySelector<HTMLElement & NonNullable<Commanded["clock"]>>("[data-clock]");
  }

  /** Loads the help at its first use. */
  async openHelp(): Promise<void> {
    try {
      await loadHelp(this.app.words);
      await import("./help");
      const help = this.querySelector<HelpView>("pg-help");
      await help?.updateComplete;
      help?.open();
    } catch {
      const { help, why } = lab().files.notLoaded;
      this.app.notices.addError(help, why);
    }
  }

  #obey(event: KeyboardEvent): void {
    const { settings, isLab } = this.app;
    if (!isLab || event.defaultPrevented || isUsedByControl(event)) return;
    // The key also closes the card of a term.
    if (event.key === "Escape" && settings.values.large && !document.querySelector(":popover-open")) {
      event.preventDefault();
      settings.change({ large: false });
    }
    const command = Object.values(COMMANDS).find(({ key }) => key === event.key);
    if (!command) return;
    event.preventDefault();
    if (!command.isHeld || !event.repeat) command.run(this, true);
  }

  /** Past the header, for the keyboard. */
  async #skip(): Promise<void> {
    if (this.app.isPlayView) return this.lab?.showPlace("couplings");
    this.querySelector<HTMLElement>("main.on-demand")?.focus();
  }

  #onDemand(view: View) {
    const loaded = this.#loaded.get(view);
    if (typeof loaded === "function") return loaded();
    if (loaded === "failed")
      return html`<p class="empty" role="alert">${lab().page.notLoaded}
        <button class="small" @click=${() => location.reload()}>${lab().page.reload}</button></p>`;
    if (!loaded) queueMicrotask(() => this.#load(view));
    return html`<p class="empty" role="status">${lab().page.loading}</p>`;
  }

  #load(view: View): void {
    if (this.#loaded.get(view) === "loading") return;
    const arrived = (state: "loading" | "failed" | (() => TemplateResult)) => {
      this.#loaded.set(view, state);
      this.requestUpdate();
    };
    arrived("loading");
    const { app } = this;
    Promise.all([app.view(view.name).get(), loadDraw(view)]).then(
      ([stores, draw]) => arrived(() => draw(stores, app)),
      () => arrived("failed"),
    );
  }

  protected override render() {
    const { app } = this;
    const { engine, settings, model, notices, embedded, isPlayView } = app;
    const { model: linked } = model.link;
    const view = isPlayView ? undefined : ALL_VIEWS.find(({ name }) => name === settings.values.view);
    const { page } = lab();
    return html`
      <div class="page column" data-embed=${embedded ? "1" : "0"}>
        ${
          embedded
            ? nothing
            : html`
          <button class="skip" @click=${() => void this.#skip()}>${isPlayView ? page.skipToCouplings : page.skipToContent}</button>
          <pg-header .app=${app} role="banner"></pg-header>`
        }
        ${this.session ? html`<pg-session .session=${this.session}></pg-session>` : nothing}
        ${
          linked === null
            ? nothing
            : html`<p class="banner" role="alert" data-testid="foreign-link">${page.foreignLink(linked, model.id)}
              <button class="small" @click=${() => model.forgetLink()}>${page.forgetLink}</button></p>`
        }
        ${
          engine.state === "failed"
            ? html`<p class="banner" role="alert">${page.failed(engine.problem)}</p>`
            : nothing
        }
        ${
          engine.state === "stopped"
            ? html`<p class="banner" role="alert" data-testid="stopped">${page.stopped(engine.problem)}
              <button class="small" @click=${() => void this.app.reload()}>${page.keepAndReload}</button></p>`
            : nothing
        }
        ${view ? html`<main class="on-demand column" tabindex="-1"><p class="view-lead">${view.words[app.words.language].lead}</p>${this.#onDemand(view)}</main>` : nothing}
        <pg-lab .app=${app}></pg-lab>
        ${
          embedded
            ? nothing
            : html`
          <footer class="hint">
            <span>${page.local} ${this.session ? html`<pg-forget .session=${this.session} .app=${app}></pg-forget>` : nothing}</span>
            <span><a href="#teach" data-testid="to-teach">${app.words.now.frame.teach}</a>, ${languageSwitch(app.words, "link")}</span>
          </footer>`
        }
        ${
          settings.values.large
            ? html`<button class="round leave-large" data-testid="leave-large" aria-label=${page.leaveLarge} title=${page.leaveLargeKey}
              @click=${() => settings.change({ large: false })}>${icon("close")}</button>`
            : nothing
        }
        <pg-notices .notices=${notices} .inLab=${isPlayView} .dismiss=${app.words.now.frame.dismiss}></pg-notices>
        <pg-help .model=${model} .engine=${engine}></pg-help>
        <div class="drop-hint passive" aria-hidden="true"><p>${page.drop}</p></div>
      </div>`;
  }
}
customElements.define("pg-page", PageView);
