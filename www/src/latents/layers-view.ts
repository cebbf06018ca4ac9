// The choice of what the latent plots show.
import { html, nothing } from "lit";
import type { SettingsStore } from "../settings/settings-store";
import "../terms/term";
import { View } from "../ui/view";
import type { Layers, LayersStore } from "./layers-store";
import type { PredictionsStore } from "./predictions-store";
import { lab } from "../words/lab";

/** The marks of the layers, as in the plots. */
const MARKS = {
  pose: "M6 1.8L10.2 6 6 10.2 1.8 6z",
  dynamics: "M1.5 10.5L9.5 2.5M5 2.2h4.8V7",
  between: "M2 9.8L6 3l4 6.8z",
  predictions: "M1 6a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0 -6.4 0M4.6 6a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0 -6.4 0",
};

export class LayersView extends View {
  static override properties = { parts: { type: Number } };
  declare layers: LayersStore;
  declare predictions: PredictionsStore;
  declare settings: SettingsStore;
  /** The number of parts of the model. */
  parts = 1;

  #mark(of: keyof typeof MARKS, pressed: boolean, press: () => void) {
    const { label, meaning } = lab().loops[of];
    return html`
      <button class="chip" aria-pressed=${pressed ? "true" : "false"} title=${meaning} @click=${press}>
        <svg viewBox="0 0 12 12" aria-hidden="true"><path d=${MARKS[of]} /></svg>${label}</button>`;
  }

  protected override render() {
    const { layers, predictions, settings, parts } = this;
    const words = lab().loops;
    const points = (layer: keyof Layers) =>
      this.#mark(layer, layers.shown[layer], () => layers.toggle(layer));
    return html`
      <div class="marks row wrap hint" role="group" aria-label=${words.layers}>
        ${points("pose")} ${points("dynamics")} ${parts > 1 ? points("between") : nothing}
        <pg-term of="inducing-point" text="?" about=${words.aboutPoints}></pg-term>
        ${this.#mark("predictions", predictions.visible, () => predictions.show(!predictions.visible))}
        <pg-term of="predictions" text="?" about=${words.aboutPredictions}></pg-term>
        ${(["futures", "uncertainty", "certainty"] as const).map((outlook) => {
          const { label, meaning } = words[outlook];
          return html`
          <button class="chip" aria-pressed=${layers.outlook?.isShown(outlook) ? "true" : "false"} title=${meaning}
            @click=${() => void layers.toggleOutlook(outlook)}>${label}</button>`;
        })}
        <div class="segments" role="group" aria-label=${words.plot}>
          ${(["2d", "3d"] as const).map(
            (plot) => html`
            <button aria-pressed=${settings.values.plot === plot ? "true" : "false"}
              @click=${() => settings.change({ plot })}>${plot === "2d" ? "2-D" : "3-D"}</button>`,
          )}
        </div>
      </div>
      ${layers.outlook ? html`<pg-outlook .outlook=${layers.outlook}></pg-outlook>` : nothing}`;
  }
}
customElements.define("pg-layers", LayersView);
