// All latent plots, and the choice of their layers.
import { html } from "lit";
import type { ModelStore } from "../couplings/model-store";
import type { EngineStore } from "../engine/engine-store";
import type { SettingsStore } from "../settings/settings-store";
import type { Playback } from "../stage/playback";
import type { StageStore } from "../stage/stage-store";
import { withTerms } from "../terms/term";
import { View } from "../ui/view";
import type { Behind } from "./latent-drawing";
import type { Layers } from "./latent-plot";
import "./latent-plot";
import "./latents.css";
import type { Outlook, OutlookStore } from "./outlook-store";
import type { PointingStore } from "./pointing-store";
import type { PredictionsStore } from "./predictions-store";
import { lab } from "../words/lab";

export class LatentsView extends View {
  declare model: ModelStore;
  declare pointing: PointingStore;
  declare predictions: PredictionsStore;
  declare settings: SettingsStore;
  declare engine: EngineStore;
  declare stage: StageStore;
  declare playback: Playback;
  /** Loads the outlook; null if it cannot be loaded. */
  declare openOutlook: () => Promise<{
    store: OutlookStore;
    behindPath(store: OutlookStore): Behind | null;
  } | null>;
  static override properties = { layers: { state: true }, behind: { state: true } };
  declare layers: Layers;
  declare behind: Behind | null;
  #outlook: OutlookStore | null = null;

  constructor() {
    super();
    this.layers = { pose: true, dynamics: true, between: false };
    this.behind = null;
  }

  protected override stores() {
    return [this.model, this.predictions, this.settings, this.engine];
  }

  #toggle(kind: keyof Layers) {
    return () => {
      this.layers = { ...this.layers, [kind]: !this.layers[kind] };
    };
  }

  async #toggleOutlook(outlook: Outlook): Promise<void> {
    const opened = await this.openOutlook();
    if (!opened) return;
    const { store, behindPath } = opened;
    if (!this.#outlook) {
      this.#outlook = store;
      this.whenLeaving(
        store.on(() => {
          this.behind = behindPath(store);
          this.requestUpdate();
        }),
      );
      this.whenLeaving(() => {
        this.#outlook = null;
      });
    }
    store.show(outlook, !store.isShown(outlook));
  }

  /** The chips of futures and uncertainty. */
  #outlookChips() {
    return (["futures", "uncertainty", "certainty"] as const).map((outlook) => {
      const { label, meaning } = lab().loops[outlook];
      return html`
      <button class="chip" aria-pressed=${this.#outlook?.isShown(outlook) ? "true" : "false"} title=${meaning}
        @click=${() => void this.#toggleOutlook(outlook)}>${label}</button>`;
    });
  }

  protected override render() {
    const { model, pointing, predictions, settings, stage, playback } = this;
    const parts = model.model?.info.parts ?? [];
    const words = lab().loops;
    const pressed = (kind: keyof Layers) => (this.layers[kind] ? "true" : "false");
    return html`
      <header class="panel-head">
        <h2>${withTerms(words.title)}</h2>
        <div class="segments" role="group" aria-label=${words.plot}>
          ${(["2d", "3d"] as const).map(
            (plot) => html`
            <button aria-pressed=${settings.values.plot === plot ? "true" : "false"}
              @click=${() => settings.change({ plot })}>${plot === "2d" ? "2-D" : "3-D"}</button>`,
          )}
        </div>
      </header>
      ${
        parts.length === 0
          ? html`<p class="empty">${this.engine.state === "failed" ? words.failed : words.empty}</p>`
          : html`
          <div class="plots" data-count=${Math.min(parts.length, 5)}>
            ${parts.map(
              (_, part) => html`
              <pg-latent-plot .bodyPart=${part} .layers=${this.layers} .behind=${this.behind} .model=${model} .pointing=${pointing} .predictions=${predictions}
                .settings=${settings} .stage=${stage} .playback=${playback}></pg-latent-plot>`,
            )}
          </div>
          <div class="marks" role="group" aria-label=${words.layers}>
            <button class="chip" aria-pressed=${pressed("pose")} @click=${this.#toggle("pose")} title=${words.pose.meaning}>
              <svg viewBox="0 0 12 12" aria-hidden="true"><path d="M6 1.8L10.2 6 6 10.2 1.8 6z" /></svg>${words.pose.label}</button>
            <button class="chip" aria-pressed=${pressed("dynamics")} @click=${this.#toggle("dynamics")} title=${words.dynamics.meaning}>
              <svg viewBox="0 0 12 12" aria-hidden="true"><path d="M1.5 10.5L9.5 2.5M5 2.2h4.8V7" /></svg>${words.dynamics.label}</button>
            ${
              parts.length > 1
                ? html`
              <button class="chip" aria-pressed=${pressed("between")} @click=${this.#toggle("between")} title=${words.between.meaning}>
                <svg viewBox="0 0 12 12" aria-hidden="true"><path d="M2 9.8L6 3l4 6.8z" /></svg>${words.between.label}</button>`
                : ""
            }
            <pg-term of="inducing-point" text="?" about=${words.aboutPoints}></pg-term>
            <button class="chip" aria-pressed=${predictions.visible ? "true" : "false"} @click=${() => predictions.show(!predictions.visible)}
              title=${words.predictions.meaning}>
              <svg viewBox="0 0 12 12" aria-hidden="true"><path d="M1 6a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0 -6.4 0M4.6 6a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0 -6.4 0" /></svg>${words.predictions.label}</button>
            <pg-term of="predictions" text="?" about=${words.aboutPredictions}></pg-term>
            ${this.#outlookChips()}
          </div>
          ${this.#outlook ? html`<pg-outlook .outlook=${this.#outlook}></pg-outlook>` : ""}`
      }
    `;
  }
}
customElements.define("pg-latents", LatentsView);
