// The layout of the page. The Lab is a stage with tabs next to it; on a phone the tabs are below the stage.
import { html, nothing, type TemplateResult } from "lit";
import "../clips/clips-view";
import "../couplings/couplings-view";
import "../couplings/phase-clock";
import "../latents/latents-view";
import type { StagedModel } from "../stage/staged-model";
import "../stage/stage-view";
import "../stage/timeline";
import "../training/training-view";
import "../ui/notices-view";
import type { HoldCoupling } from "../couplings/body-map";
import type { LiveStore } from "../live/live-store";
import type { SessionStore } from "../session/session-store";
import { type Settings, TABS } from "../settings/settings";
import { messageOf } from "../ui/format";
import { icon } from "../ui/icons";
import { View } from "../ui/view";
import type { App } from "./app";
import { clipOnStage } from "./caption";
import "./header";
import "./lead";
import { FrameTabs } from "./frame-tabs";
import type { HelpView } from "./help";
import { openAnyModel, openFiles } from "./open-files";
import { lab, shownPart } from "../words/lab";
import { loadNumbers } from "../words/numbers";
import { languageSwitch } from "./language-switch";

type Tab = Settings["tab"];

interface Clock {
  togglePlay(): void;
  step(direction: 1 | -1): void;
}

/** Views that are loaded at their first use. Each function returns a function that draws the view. */
const ON_DEMAND = {
  async compare({ comparison, settings, clips, engine, notices }: App) {
    const [store] = await Promise.all([comparison.get(), import("../comparison/comparison-page")]);
    return () => html`
      <pg-comparison .comparison=${store} .settings=${settings} .clips=${clips} .engine=${engine} .notices=${notices}></pg-comparison>`;
  },
  async synthetic({ experiment, settings, words }: App) {
    const [store, { loadExperiment }] = await Promise.all([
      experiment.get(),
      import("../words/experiment"),
      import("../experiment/experiment-page"),
    ]);
    await loadExperiment(words);
    return () => html`<pg-synthetic .experiment=${store} .settings=${settings}></pg-synthetic>`;
  },
  async perception({ perception, analysis, notices }: App) {
    const [store, answers] = await Promise.all([
      perception.get(),
      analysis.get(),
      import("../perception/perception-page"),
    ]);
    return () =>
      html`<pg-perception .perception=${store} .analysis=${answers} .notices=${notices}></pg-perception>`;
  },
  async primitives({ primitives, clips, notices }: App) {
    const [stores] = await Promise.all([primitives.get(), import("../primitives/primitives-page")]);
    return () =>
      html`<pg-primitives .primitives=${stores} .clips=${clips} .notices=${notices}></pg-primitives>`;
  },
  async series({ series, settings, notices }: App) {
    const [stores] = await Promise.all([series.get(), import("../series/series-page")]);
    return () => html`<pg-series .series=${stores} .settings=${settings} .notices=${notices}></pg-series>`;
  },
  async method({ words }: App) {
    const [{ loadMethod }] = await Promise.all([import("../words/method"), import("../method/method-page")]);
    await loadMethod(words);
    return () => html`<pg-method></pg-method>`;
  },
};

/** Places of the page to go to: the tab, and the element that takes the focus. */
const PLACES = {
  couplings: {
    tab: "listen",
    focus: "pg-body-map .knob, pg-couplings input",
  },
  reading: { tab: "listen", focus: ".readings button" },
  latents: { tab: "loops", focus: "pg-latent-plot [tabindex='0'], pg-latents button" },
  points: { tab: "loops", focus: ".marks .chip" },
  parts: { tab: "learn", focus: "[data-testid=setting-parts]" },
  "latent dimensions": { tab: "learn", focus: "[data-testid=setting-latent]" },
  "dynamics points": { tab: "learn", focus: "[data-testid=setting-dynamicsIps]" },
  "pose points": { tab: "learn", focus: "[data-testid=setting-poseIps]" },
  order: { tab: "learn", focus: "[data-testid=setting-order]" },
  train: { tab: "learn", focus: "[data-testid=train], [data-testid=cancel]" },
  stage: { tab: null, focus: "[data-testid=stage]" },
  length: { tab: null, focus: "[data-testid=length], [data-testid=scrub]" },
} as const satisfies Record<string, { tab: Tab | null; focus: string }>;

export class PageView extends View {
  static override properties = { liveView: { state: true }, session: { state: true } };
  /** The stored visits; null: the browser stores none, or the session is not loaded yet. */
  declare session: SessionStore | null;
  /** Draws the live motion; null before its first use. */
  declare liveView: (() => TemplateResult) | null;
  #keyHolds: { source: number; target: number } | null = null;
  declare app: App;
  readonly #frameTabs = new FrameTabs();
  readonly #loaded = new Map<keyof typeof ON_DEMAND, "loading" | "failed" | (() => TemplateResult)>();

  constructor() {
    super();
    this.liveView = null;
    this.session = null;
  }

  /** Starts the live motion or returns to the clip. */
  async #switchLive(on: boolean): Promise<void> {
    const live = await this.#liveStore();
    if (!live) return;
    if (on) await live.start();
    else live.stop();
  }

  /** Cuts the coupling of the slider in focus, or the strongest one between parts. */
  holdByKey(held: boolean): void {
    if (held && this.app.isPlayView)
      this.#keyHolds = this.#couplingInFocus() ?? this.app.model.couplings.strongestBetween();
    if (this.#keyHolds) void this.#holdCoupling({ ...this.#keyHolds, held });
    if (!held) this.#keyHolds = null;
  }

  #couplingInFocus(): { source: number; target: number } | null {
    const { source, target } =
      document.activeElement instanceof HTMLElement ? document.activeElement.dataset : {};
    return source === undefined || target === undefined
      ? null
      : { source: Number(source), target: Number(target) };
  }

  async #holdCoupling({ source, target, held }: HoldCoupling): Promise<void> {
    const live = await this.#liveStore();
    await live?.hold(source, target, held);
  }

  /** The live motion with its view; null: it cannot be loaded. */
  async #liveStore(): Promise<LiveStore | null> {
    try {
      const { app } = this;
      const [live, recorded] = await Promise.all([
        app.live.get(),
        app.recordedParts.get(),
        import("../live/live-view"),
      ]);
      this.liveView ??= () =>
        html`<pg-live .live=${live} .model=${app.model} .playback=${app.playback} .recorded=${recorded}></pg-live>`;
      return live;
    } catch {
      this.#notLoaded("live");
      return null;
    }
  }

  protected override stores() {
    const { engine, settings, model, stage, clips, words } = this.app;
    return [engine, settings, model, stage, clips, words];
  }

  protected override arrived(): void {
    // A failed import may work now. Chromium repeats the failure until the page is reloaded.
    this.listen(window, "online", () => {
      for (const [view, state] of this.#loaded) if (state === "failed") this.#load(view);
    });
  }

  /** The clock that the keys for play and step control. */
  get clock(): Clock | null {
    return this.app.isPlayView
      ? this.app.playback
      : this.querySelector<HTMLElement & Clock>("pg-side-by-side, pg-walk, pg-series");
  }

  #notLoaded(what: "live" | "help" | "exercise" | "tab"): void {
    const { notLoaded } = lab().files;
    this.app.notices.addError(notLoaded[what], notLoaded.why);
  }

  /** Loads the help at its first use. */
  async openHelp(): Promise<void> {
    try {
      const { loadHelp } = await import("../words/help");
      await loadHelp(this.app.words);
      await import("./help");
      const help = this.querySelector<HelpView>("pg-help");
      await help?.updateComplete;
      help?.open();
    } catch {
      this.#notLoaded("help");
    }
  }

  async #showPlace(name: string): Promise<void> {
    if (!(name in PLACES)) return;
    const { tab, focus } = PLACES[name as keyof typeof PLACES];
    const { settings } = this.app;
    if (settings.values.view !== "play") settings.change({ view: "play" });
    if (tab) settings.change({ tab });
    await this.updateComplete;
    const control = this.querySelector<HTMLElement>(focus);
    const folded = control?.closest("details");
    if (folded) folded.open = true;
    control?.focus();
    control?.scrollIntoView({ block: "nearest" });
  }

  /** Past the header, for the keyboard. */
  async #skip(): Promise<void> {
    if (this.app.isPlayView) return this.#showPlace("couplings");
    this.querySelector<HTMLElement>("main.on-demand")?.focus();
  }

  /** Puts a model of another view on the stage. */
  async #stageModel({ text, name, made }: StagedModel): Promise<void> {
    const { notices, settings } = this.app;
    try {
      if (!(await openAnyModel(this.app, name, await text, made))) return;
      settings.change({ view: "play" });
    } catch (problem) {
      notices.addError(lab().files.notTakenUp, messageOf(problem));
    }
  }

  #showMethod(): void {
    this.app.settings.change({ view: "method" });
  }

  #onDemand(view: keyof typeof ON_DEMAND) {
    const loaded = this.#loaded.get(view);
    if (typeof loaded === "function") return loaded();
    if (loaded === "failed")
      return html`<p class="empty" role="alert">${lab().page.notLoaded}
        <button class="small" @click=${() => location.reload()}>${lab().page.reload}</button></p>`;
    if (!loaded) queueMicrotask(() => this.#load(view));
    return html`<p class="empty" role="status">${lab().page.loading}</p>`;
  }

  #load(view: keyof typeof ON_DEMAND): void {
    if (this.#loaded.get(view) === "loading") return;
    const arrived = (state: "loading" | "failed" | (() => TemplateResult)) => {
      this.#loaded.set(view, state);
      this.requestUpdate();
    };
    arrived("loading");
    ON_DEMAND[view](this.app).then(arrived, () => arrived("failed"));
  }

  #tabKeys(event: KeyboardEvent): void {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const tabs = this.#tabs;
    const tab = tabs.at((tabs.indexOf(this.#tab) + step) % tabs.length) ?? this.#tab;
    this.app.settings.change({ tab });
    void this.updateComplete.then(() => this.querySelector<HTMLElement>(`#tab-${tab}`)?.focus());
  }

  get #tabs(): readonly Tab[] {
    return this.app.embedded ? this.#frameTabs.shown(this.app.settings.values) : TABS;
  }

  get #tab(): Tab {
    return this.app.settings.values.tab;
  }

  #stageArea() {
    const { stage, playback, settings, clips, model, phases, words, isPlayView } = this.app;
    // The first clip on the stage loads the handles; after a failure the next clip tries again.
    if (stage.clip !== null) import("../clips/trim-view").catch(() => {});
    return html`
      <section class="stage-area" aria-label=${words.now.frame.stage}>
        <pg-stage .stage=${stage} .playback=${playback} .running=${isPlayView} .label=${lab().stage.figure}
          .legend=${{ label: lab().learn.settings.parts, nameOf: shownPart }}></pg-stage>
        <pg-caption .app=${this.app}></pg-caption>
        <pg-phase-clock .phases=${phases} .playback=${playback} .words=${lab().clock}></pg-phase-clock>
        ${stage.clip === null ? nothing : html`<pg-trim .clips=${clips} .stage=${stage} .playback=${playback}></pg-trim>`}
        <div>${this.liveView ? this.liveView() : nothing}</div>
        <pg-timeline @set-seconds=${({ detail }: CustomEvent<number>) => model.setSeconds(detail)} .stage=${stage} .playback=${playback} .settings=${settings}></pg-timeline>
      </section>`;
  }

  /** The exercise of a link, loaded at its first use. */
  #exercise() {
    const { body, model, settings, notices, words } = this.app;
    if (settings.values.exercise === 0) return nothing;
    import("../exercises/exercise-view").catch(() => this.#notLoaded("exercise"));
    return html`<pg-exercise .body=${body} .model=${model} .settings=${settings} .notices=${notices} .words=${words}></pg-exercise>`;
  }

  #panels() {
    const {
      engine,
      settings,
      playback,
      stage,
      clips,
      model,
      body,
      readings,
      pointing,
      predictions,
      starts,
      training,
    } = this.app;
    const tabs = this.#tabs;
    const panel = (id: Tab, content: TemplateResult) => html`
      <section id="panel-${id}" class="panel" role="tabpanel" aria-labelledby="tab-${id}" ?hidden=${id !== this.#tab}>${content}</section>`;
    return [
      panel(
        "listen",
        html`<pg-lead .app=${this.app}></pg-lead>
        <pg-couplings .playback=${playback} .model=${model} .settings=${settings} .engine=${engine} .body=${body} .readings=${readings} .starts=${starts}></pg-couplings>
        ${tabs.includes("learn") ? this.#completing() : nothing}`,
      ),
      panel(
        "loops",
        html`<pg-latents .openOutlook=${this.app.openOutlook} .model=${model} .pointing=${pointing} .predictions=${predictions} .settings=${settings} .engine=${engine} .stage=${stage} .playback=${playback}></pg-latents>`,
      ),
      tabs.includes("learn")
        ? panel(
            "learn",
            html`
            <pg-clips .clips=${clips} .stage=${stage} .engine=${engine}></pg-clips>
            ${this.#recorded()}
            <pg-training .training=${training} .settings=${settings} .clips=${clips} .engine=${engine}></pg-training>`,
          )
        : nothing,
      tabs.includes("numbers") ? panel("numbers", this.#numbers()) : nothing,
    ];
  }

  /** A recording, opened on the tab Learn, that moves one part; loaded when it is opened for the first time. */
  #completing() {
    const { model, completing } = this.app;
    if ((model.model?.info.parts.length ?? 0) < 2) return nothing;
    const store = completing.loaded;
    const open = (event: Event) => {
      if (!(event.target as HTMLDetailsElement).open) return;
      completing
        .get()
        .then(() => this.requestUpdate())
        .catch(() => this.#notLoaded("tab"));
    };
    return html`
      <details class="advanced" data-testid="completing" @toggle=${open}>
        <summary>${lab().couplings.completing}</summary>
        ${store ? html`<pg-completing .completing=${store} .model=${model}></pg-completing>` : nothing}
      </details>`;
  }

  /** Movements of recorded people, loaded when they are opened for the first time. */
  #recorded() {
    const { recorded } = this.app;
    const store = recorded.loaded;
    const open = (event: Event) => {
      if (!(event.target as HTMLDetailsElement).open) return;
      recorded
        .get()
        .then(() => this.requestUpdate())
        .catch(() => this.#notLoaded("tab"));
    };
    return html`
      <details class="made" data-testid="real-people" @toggle=${open}>
        <summary>${lab().learn.clips.recorded}</summary>
        ${store ? html`<pg-recorded .recorded=${store}></pg-recorded>` : nothing}
      </details>`;
  }

  /** Loaded when the tab is opened for the first time. */
  #numbers() {
    const { engine, model, playback, words } = this.app;
    const visible = this.app.isPlayView && this.#tab === "numbers";
    if (visible)
      loadNumbers(words)
        .then(() => import("../details/numbers-view"))
        .catch(() => this.#notLoaded("tab"));
    return html`<pg-numbers .engine=${engine} .model=${model} .playback=${playback} .clip=${clipOnStage(this.app)} .visible=${visible}></pg-numbers>`;
  }

  protected override render() {
    const { app } = this;
    const { engine, settings, model, notices, embedded, isPlayView } = app;
    const { model: linked } = model.link;
    const { view } = settings.values;
    const { page } = lab();
    return html`
      <div class="page" data-embed=${embedded ? "1" : "0"} @show-help=${this.openHelp} @show-method=${this.#showMethod} @show-series=${() => settings.change({ view: "series" })}
        @show-place=${({ detail }: CustomEvent<string>) => void this.#showPlace(detail)}
        @hold-coupling=${({ detail }: CustomEvent<HoldCoupling>) => void this.#holdCoupling(detail)}
        @study-made=${({ detail }: CustomEvent<string>) => void this.app.openStudy(detail, true)}
        @switch-live=${({ detail }: CustomEvent<boolean>) => void this.#switchLive(detail)}
        @stage-model=${({ detail }: CustomEvent<StagedModel>) => void this.#stageModel(detail)}
        @open-files=${({ detail }: CustomEvent<File[]>) => void openFiles(app, detail, null)}>
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
        ${isPlayView || view === "play" ? nothing : html`<main class="on-demand" tabindex="-1">${this.#onDemand(view)}</main>`}
        <main class="lab" ?hidden=${!isPlayView}>
          ${this.#stageArea()}
          <div class="tabs" role="tablist" aria-label=${page.panels} @keydown=${this.#tabKeys}>
            ${this.#tabs.map(
              (tab) => html`
              <button role="tab" id="tab-${tab}" aria-controls="panel-${tab}" aria-selected=${this.#tab === tab ? "true" : "false"}
                tabindex=${this.#tab === tab ? 0 : -1} @click=${() => settings.change({ tab })}>${page.tabs[tab]}</button>`,
            )}
          </div>
          ${this.#exercise()}
          ${this.#panels()}
        </main>
        ${
          embedded
            ? nothing
            : html`
          <footer>
            <span>${page.local} ${this.session ? html`<pg-forget .session=${this.session} .app=${app}></pg-forget>` : nothing}</span>
            <span><a href="#teach" data-testid="to-teach">${app.words.now.frame.teach}</a>, <button class="link" data-testid="about" @click=${this.openHelp}>${page.data}</button>, <a href="licences.txt">${page.licences}</a>, ${languageSwitch(app.words, "link")}</span>
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
        <div class="drop-hint" aria-hidden="true"><p>${page.drop}</p></div>
      </div>`;
  }
}
customElements.define("pg-page", PageView);
