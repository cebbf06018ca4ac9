// The view Draw: the pads of two hands, and the picture of loops and couplings of the model that goes on.
import { html, nothing } from "lit";
import type { Space } from "../latents/latent-plot";
import { LayersStore } from "../latents/layers-store";
import { coupledPicture } from "../picture/coupled-picture";
import type { SettingsStore } from "../settings/settings-store";
import { download } from "../ui/download";
import { eachFrame } from "../ui/browser";
import { icon } from "../ui/icons";
import { View } from "../ui/view";
import type { Draw } from "../views/define-view";
import { lab } from "../words/lab";
import { drawingWords } from "./view-words";
import "./drawing.css";
import { drawingFile, type DrawingStore } from "./drawing-store";
import "./pad-view";

export class DrawingPage extends View {
  declare store: DrawingStore;
  declare settings: SettingsStore;
  #space: Space | null = null;

  protected override stores() {
    return [this.store];
  }

  protected override arrived(): void {
    this.whenLeaving(eachFrame((seconds) => this.store.model.clock.advance(seconds)));
  }

  /** The clock that the keys for play and step control. */
  togglePlay(): void {
    this.store.model.clock.togglePlay();
  }

  step(direction: 1 | -1): void {
    this.store.model.clock.step(direction);
  }

  #controls() {
    const { store } = this;
    const { drawn, model } = store;
    const words = drawingWords();
    const { playing } = model.clock;
    const { time } = lab();
    const save = () => drawn && download("drawing.csv", drawingFile(drawn.drawing, drawn.pads));
    return html`
      <div class="draw-controls">
        ${
          drawn
            ? html`
          <button class="round primary" data-testid="draw-play" aria-label=${playing ? time.pause : time.play} @click=${() => this.togglePlay()}>${icon(playing ? "pause" : "play")}</button>
          <button class="small" data-testid="draw-clear" @click=${() => store.clear()}>${words.again}</button>
          <button class="small" data-testid="save-drawing" title=${words.saveDrawingMeaning} @click=${save}>${icon("save")} ${words.saveDrawing}</button>
          <button class="small" data-testid="save-drawing-model" title=${words.saveModelMeaning} @click=${() => model.save()}>${icon("save")} ${words.saveModel}</button>`
            : nothing
        }
      </div>`;
  }

  #picture() {
    const { store } = this;
    const words = drawingWords();
    this.#space ??= {
      layers: new LayersStore(async () => null),
      settings: this.settings,
      playback: store.model.clock,
    };
    if (!store.drawn)
      return html`
        <div class="picture-area draw-begin">
          <h2>${words.title}</h2>
          <p>${words.text}</p>
          <button class="small" title=${words.exampleMeaning} data-testid="draw-example" ?disabled=${store.busy} @click=${() => void store.example()}>${words.example}</button>
        </div>`;
    return coupledPicture({
      model: store.model,
      space: this.#space,
      lead: store.drawn.pads.length > 1 ? words.lead.two : words.lead.one,
      problem: store.problem,
      foot: nothing,
    });
  }

  protected override render() {
    return html`
      <div class="lab" data-panel="none">
        <section class="stage-area draw-area" aria-label=${drawingWords().title}>
          <div class="pads">
            <pg-pad .store=${this.store} .pad=${0}></pg-pad>
            <pg-pad .store=${this.store} .pad=${1}></pg-pad>
          </div>
          <p role="status" data-testid="draw-words">${this.store.words}</p>
          ${this.#controls()}
        </section>
        ${this.#picture()}
      </div>`;
  }
}
customElements.define("pg-drawing", DrawingPage);

export const draw: Draw<"draw"> = (store, { settings }) =>
  html`<pg-drawing data-clock .store=${store} .settings=${settings}></pg-drawing>`;
