// The Lab: the figure with its clock, the picture of loops and couplings next to it, and the panels that open
// beside both. On a phone they are below each other.
import { html, nothing, type TemplateResult } from "lit";
import "../clips/clips-view";
import type { HoldCoupling } from "../couplings/coupling-view";
import "../couplings/phase-clock";
import type { LiveStore } from "../live/live-store";
import "../picture/more-view";
import "../picture/picture-view";
import { PANELS, type Settings } from "../settings/settings";
import "../stage/stage-view";
import "../stage/timeline";
import "../training/training-view";
import { icon } from "../ui/icons";
import { View } from "../ui/view";
import { lab, shownPart } from "../words/lab";
import { loadNumbers } from "../words/sections";
import type { App } from "./app";
import { clipOnStage } from "./caption";
import type { Lazy } from "../ui/lazy";

type Panel = Settings["panel"];

/** The exercise in which a model is trained, as its address counts it. */
const TRAINING_EXERCISE = 6;

/** Places of the Lab to go to: the panel, and the element that takes the focus. */
const PLACES = {
  couplings: { panel: null, focus: "pg-coupling input" },
  reading: { panel: null, focus: "[data-testid=reading]" },
  latents: { panel: null, focus: "pg-latent-plot [tabindex='0']" },
  points: { panel: "more", focus: ".marks .chip" },
  parts: { panel: "learn", focus: "[data-testid=setting-parts]" },
  "latent dimensions": { panel: "learn", focus: "[data-testid=setting-latent]" },
  "dynamics points": { panel: "learn", focus: "[data-testid=setting-dynamicsIps]" },
  "pose points": { panel: "learn", focus: "[data-testid=setting-poseIps]" },
  order: { panel: "learn", focus: "[data-testid=setting-order]" },
  train: { panel: null, focus: "[data-testid=train], [data-testid=cancel]" },
  stage: { panel: null, focus: "[data-testid=stage]" },
  length: { panel: null, focus: "[data-testid=length], [data-testid=scrub]" },
} as const satisfies Record<string, { panel: Panel | null; focus: string }>;

export class LabView extends View {
  declare app: App;
  /** Draws the live motion; null before its first use. */
  #liveView: (() => TemplateResult) | null = null;
  #keyHolds: { source: number; target: number } | null = null;
  /** In a frame of another page: the panels that an address or an explained term has opened. */
  readonly #opened = new Set<Panel>(["more"]);

  protected override stores() {
    const { engine, settings, model, stage, clips, words } = this.app;
    return [engine, settings, model, stage, clips, words];
  }

  #notLoaded(what: "live" | "exercise" | "panel"): void {
    const { notLoaded } = lab().files;
    this.app.notices.addError(notLoaded[what], notLoaded.why);
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
      const performed = await app.performed.get();
      this.#liveView ??= () => html`<pg-live .performed=${performed}></pg-live>`;
      this.requestUpdate();
      return performed.live;
    } catch {
      this.#notLoaded("live");
      return null;
    }
  }

  /** Opens the panel of a place, and gives its element the focus. */
  async showPlace(name: string): Promise<void> {
    if (!(name in PLACES)) return;
    const { panel, focus } = PLACES[name as keyof typeof PLACES];
    const { settings } = this.app;
    if (settings.values.view !== "play") settings.change({ view: "play" });
    if (panel) settings.change({ panel });
    // The views in the panel are drawn after the panel.
    await new Promise((drawn) => setTimeout(drawn));
    const control = this.querySelector<HTMLElement>(focus);
    const folded = control?.closest("details");
    if (folded) folded.open = true;
    control?.focus();
    control?.scrollIntoView({ block: "nearest" });
  }

  /** A frame is small: there, a panel of the training waits until it is needed. */
  get #panels(): readonly (typeof PANELS)[number][] {
    const { settings, embedded } = this.app;
    const { panel, exercise } = settings.values;
    this.#opened.add(panel);
    if (exercise === TRAINING_EXERCISE) this.#opened.add("learn");
    return embedded ? PANELS.filter((panel) => this.#opened.has(panel)) : PANELS;
  }

  #stageArea() {
    const { stage, playback, settings, clips, model, phases, words, isPlayView } = this.app;
    // The first clip on the stage loads the marks of its ends; after a failure the next clip tries again.
    if (stage.clip !== null) import("../clips/trim-view").catch(() => {});
    return html`
      <section class="stage-area" aria-label=${words.now.frame.stage}>
        <pg-stage .stage=${stage} .playback=${playback} .running=${isPlayView} .label=${lab().stage.figure}
          .legend=${{ label: lab().learn.settings.parts, nameOf: shownPart }}></pg-stage>
        <pg-caption .app=${this.app}></pg-caption>
        <pg-phase-clock .phases=${phases} .playback=${playback} .words=${lab().clock}></pg-phase-clock>
        ${stage.clip === null ? nothing : html`<pg-trim .clips=${clips} .stage=${stage} .playback=${playback}></pg-trim>`}
        <div>${this.#liveView?.() ?? nothing}</div>
        ${stage.content?.controls}
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

  /** A part of a panel that loads when it is opened for the first time. */
  #fold<T>(testId: string, summary: string, lazy: Lazy<T>, content: (store: T) => TemplateResult) {
    const open = (event: Event) => {
      if (!(event.target as HTMLDetailsElement).open) return;
      lazy
        .get()
        .then(() => this.requestUpdate())
        .catch(() => this.#notLoaded("panel"));
    };
    const store = lazy.loaded;
    return html`
      <details class="advanced" data-testid=${testId} @toggle=${open}>
        <summary>${summary}</summary>
        ${store === null ? nothing : content(store)}
      </details>`;
  }

  #panel() {
    const { engine, settings, stage, clips, model, training, recorded, completing } = this.app;
    switch (settings.values.panel) {
      case "none":
        return nothing;
      case "learn":
        return html`
          <pg-clips .clips=${clips} .stage=${stage} .engine=${engine}></pg-clips>
          ${this.#fold("real-people", lab().learn.clips.recorded, recorded, (recorded) => html`<pg-recorded .recorded=${recorded}></pg-recorded>`)}
          <pg-training class="column" .training=${training} .settings=${settings} .clips=${clips} .engine=${engine}></pg-training>`;
      case "more":
        return html`
          <pg-more .app=${this.app}></pg-more>
          ${
            (model.model?.info.parts.length ?? 0) > 1
              ? this.#fold(
                  "completing",
                  lab().couplings.completing,
                  completing,
                  (completing) =>
                    html`<pg-completing .completing=${completing} .model=${model}></pg-completing>`,
                )
              : nothing
          }`;
      case "numbers":
        return this.#numbers();
    }
  }

  /** Loaded when the panel is opened for the first time. */
  #numbers() {
    const { engine, model, playback, words, isPlayView } = this.app;
    if (isPlayView)
      loadNumbers(words)
        .then(() => import("../details/numbers-view"))
        .catch(() => this.#notLoaded("panel"));
    return html`<pg-numbers .workers=${this.app.workers} .engine=${engine} .model=${model} .playback=${playback} .clip=${clipOnStage(this.app)} .visible=${isPlayView}></pg-numbers>`;
  }

  protected override render() {
    const { app } = this;
    const { settings } = app;
    const { panel } = settings.values;
    const { page } = lab();
    return html`
      <main class="lab" ?hidden=${!app.isPlayView} data-panel=${panel}
        @hold-coupling=${({ detail }: CustomEvent<HoldCoupling>) => void this.#holdCoupling(detail)}
        @switch-live=${({ detail }: CustomEvent<boolean>) => void this.#switchLive(detail)}>
        ${this.#stageArea()}
        <div class="picture-area">
          ${this.#exercise()}
          <pg-picture .app=${app} .panels=${this.#panels}></pg-picture>
        </div>
        ${
          panel === "none"
            ? nothing
            : html`
          <aside id="panel-${panel}" class="panel" aria-label=${page.panels[panel]}>
            <button class="round close-panel" aria-label=${page.closePanel} title=${page.closePanel} data-testid="close-panel"
              @click=${() => settings.change({ panel: "none" })}>${icon("close")}</button>
            ${this.#panel()}
          </aside>`
        }
      </main>`;
  }
}
customElements.define("pg-lab", LabView);
