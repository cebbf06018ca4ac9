// The page: where each view goes. On narrow screens the panels beside the stage become tabs.
import { html, nothing } from "lit";
import type { App } from "./app";
import "../clips/clips-view";
import "../couplings/couplings-view";
import "./header";
import { ACKNOWLEDGEMENT, type HelpView } from "./help";
import "../latents/latents";
import "../ui/notices";
import type { StageView } from "../stage/stage-view";
import "../stage/stage-view";
import type { TimelineView } from "../stage/timeline";
import "../stage/timeline";
import "../training/training-view";
import { View } from "../ui/view";

const TABS = [
  ["latents", "Latents"],
  ["couplings", "Couplings"],
  ["clips", "Clips"],
  ["training", "Training"],
] as const;
type Tab = (typeof TABS)[number][0];

interface Clock {
  togglePlay(): void;
  step(direction: 1 | -1): void;
}

/** What is loaded only when it is asked for. */
const ON_DEMAND = {
  compare: {
    load: () => import("../comparison/comparison-page"),
    draw: (app: App) => html`<pg-comparison .app=${app}></pg-comparison>`,
  },
  synthetic: {
    load: () => import("../experiment/experiment-page"),
    draw: (app: App) => html`<pg-synthetic .app=${app}></pg-synthetic>`,
  },
};

export class PageView extends View {
  static override topics = ["engine", "settings"] as const;
  static override properties = { tab: { state: true } };
  declare tab: Tab;
  private readonly loaded = new Map<string, "loading" | "there" | "failed">();

  constructor() {
    super();
    this.tab = "couplings";
  }

  private onDemand(view: keyof typeof ON_DEMAND) {
    const state = this.loaded.get(view);
    if (!state) {
      this.loaded.set(view, "loading");
      const arrived = (state: "there" | "failed") => {
        this.loaded.set(view, state);
        this.requestUpdate();
      };
      ON_DEMAND[view].load().then(
        () => arrived("there"),
        () => arrived("failed"),
      );
    }
    if (state === "there") return ON_DEMAND[view].draw(this.app);
    if (state !== "failed") return html`<p class="empty" role="status">Loading</p>`;
    const again = () => {
      this.loaded.delete(view);
      this.requestUpdate();
    };
    return html`<p class="empty" role="alert">This part of the page could not be loaded. <button class="small" @click=${again}>Try again</button></p>`;
  }

  get stage(): StageView {
    return this.querySelector("pg-stage")!;
  }

  get timeline(): TimelineView {
    return this.querySelector("pg-timeline")!;
  }

  /** What the keys for play and step work on. */
  get clock(): Clock | null {
    const { settings, embedded } = this.app;
    return settings.view === "play" || embedded
      ? this.timeline
      : this.querySelector<HTMLElement & Clock>("pg-side-by-side");
  }

  get help(): HelpView {
    return this.querySelector("pg-help")!;
  }

  private tabKeys(event: KeyboardEvent): void {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const tabs = this.tabs();
    const at = tabs.findIndex(([id]) => id === this.tab);
    this.tab = tabs[(at + step + tabs.length) % tabs.length]![0];
    void this.updateComplete.then(() => this.querySelector<HTMLElement>(`#tab-${this.tab}`)?.focus());
  }

  private tabs() {
    return this.app.embedded ? TABS.slice(0, 2) : TABS;
  }

  protected override render() {
    const { app } = this;
    const panel = (id: Tab) => (this.tab === id ? "panel active" : "panel");
    return html`
      <div class="page" data-embed=${app.embedded ? "1" : "0"} @show-help=${() => this.help.open()}
        @show-couplings=${() => {
          this.tab = "couplings";
          void this.updateComplete.then(() =>
            this.querySelector<HTMLElement>(
              "pg-couplings tbody tr:first-child td:last-of-type input, pg-couplings input",
            )?.focus(),
          );
        }}>
        ${app.embedded ? nothing : html`<pg-header .app=${app} role="banner"></pg-header>`}
        ${
          app.engineState === "failed"
            ? html`<p class="banner" role="alert">The model cannot run here: ${app.engineProblem} The walk below is a stored rollout; sliders and training need the model.</p>`
            : nothing
        }
        ${app.settings.view === "play" || app.embedded ? nothing : html`<main class="on-demand">${this.onDemand(app.settings.view)}</main>`}
        <main ?hidden=${app.settings.view !== "play" && !app.embedded}>
          <section class="stage-area" aria-label="Stage">
            <pg-stage .app=${app}></pg-stage>
            <pg-timeline .app=${app}></pg-timeline>
          </section>
          <div class="tabs" role="tablist" aria-label="Panels" @keydown=${this.tabKeys}>
            ${this.tabs().map(
              ([id, title]) => html`
              <button role="tab" id="tab-${id}" aria-controls="panel-${id}" aria-selected=${this.tab === id ? "true" : "false"}
                tabindex=${this.tab === id ? 0 : -1} @click=${() => (this.tab = id)}>${title}</button>`,
            )}
          </div>
          <section id="panel-latents" class=${panel("latents")} aria-label="Latent spaces"><pg-latents .app=${app}></pg-latents></section>
          <section id="panel-couplings" class=${panel("couplings")} aria-label="Couplings"><pg-couplings .app=${app}></pg-couplings></section>
          ${
            app.embedded
              ? nothing
              : html`
            <div class="side">
              <section id="panel-clips" class=${panel("clips")} aria-label="Clips"><pg-clips .app=${app}></pg-clips></section>
              <section id="panel-training" class=${panel("training")} aria-label="Training"><pg-training .app=${app}></pg-training></section>
            </div>`
          }
        </main>
        ${
          app.embedded
            ? nothing
            : html`
          <footer>
            <span>Nothing you load leaves your machine.</span>
            <span>The start model was trained on CMU subject 35. ${ACKNOWLEDGEMENT}</span>
          </footer>`
        }
        <pg-notices .app=${app}></pg-notices>
        <pg-help .app=${app}></pg-help>
        <div class="drop-hint" aria-hidden="true"><p>Drop motion clips (.bvh) or a model (.json)</p></div>
      </div>`;
  }
}
customElements.define("pg-page", PageView);
