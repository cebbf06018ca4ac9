// The view Draw: the pads of two hands, and the picture of loops and couplings of the model that goes on.
import { html, nothing } from "lit";
import { coupledPicture } from "../picture/coupled-picture";
import { FUTURES } from "../series/series-store";
import { SeriesView } from "../series/series-view";
import { download } from "../ui/download";
import { icon } from "../ui/icons";
import type { Draw } from "../views/define-view";
import { lab } from "../words/lab";
import type { WordsStore } from "../words/words";
import { DARES } from "../settings/settings";
import { drawingWords } from "./view-words";
import "./drawing.css";
import { HEIGHT } from "./hand";
import { drawingFile, type DrawingStore } from "./drawing-store";
import "./pad-view";
import "../live/sound-view";

/** A hand that visits a smaller share of its drawing has stopped. */
const STOPPED = 0.3;

export class DrawingPage extends SeriesView {
  static override properties = { playing: { state: true } };
  declare store: DrawingStore;
  declare page: { words: WordsStore };
  /** Whether the clock runs. */
  declare playing: boolean;

  constructor() {
    super();
    this.playing = false;
  }

  protected override stores() {
    return [this.store, this.settings];
  }

  protected override get shown() {
    return this.store.model;
  }

  protected override arrived(): void {
    super.arrived();
    const { clock } = this.shown;
    const look = () => {
      this.playing = clock.playing;
    };
    look();
    this.whenLeaving(clock.on(look));
  }

  #controls() {
    const { store } = this;
    const { drawn, model } = store;
    const words = drawingWords();
    const { playing } = this;
    const { time } = lab();
    const save = () => drawn && download("drawing.csv", drawingFile(drawn.drawing, drawn.pads));
    return html`
      <div class="draw-controls">
        ${
          drawn
            ? html`
          <button class="round primary" data-testid="draw-play" aria-label=${playing ? time.pause : time.play} @click=${() => this.togglePlay()}>${icon(playing ? "pause" : "play")}</button>
          <pg-sound .app=${this.page} .hands=${() => this.#heights()}></pg-sound>
          ${drawn.pads.length > 1 ? drawn.pads.map((pad) => html`<button class="small" data-testid="back-${pad}" title=${words.backMeaning} @click=${() => store.setBack(pad)}>${words.back(words.hands[pad] ?? "")}</button>`) : nothing}
          <button class="small" data-testid="draw-clear" @click=${() => store.clear()}>${words.again}</button>
          <label class="says"><span class="visually-hidden">${words.says}</span>
            <input data-testid="says" maxlength="80" placeholder=${words.says} .value=${this.settings.values.says}
              @input=${({ target }: Event) => this.settings.change({ says: (target as HTMLInputElement).value })} /></label>
          <button class="small" data-testid="send" title=${words.sendMeaning} @click=${() => this.tell("share")}>${words.send}</button>
          <button class="small" data-testid="save-drawing" title=${words.saveDrawingMeaning} @click=${save}>${icon("save")} ${words.saveDrawing}</button>
          <button class="small" data-testid="save-drawing-model" title=${words.saveModelMeaning} @click=${() => model.save()}>${icon("save")} ${words.saveModel}</button>`
            : nothing
        }
      </div>`;
  }

  /** The height of the pen of each hand, 0 to 1, while the model draws. */
  #heights(): number[] {
    const { drawn, model, isDrawing } = this.store;
    const pads = model.clock.playing && !isDrawing ? (drawn?.pads ?? []) : [];
    return pads.map((pad) => (this.store.pen(pad, 0)?.[1] ?? 0) / HEIGHT);
  }

  /** Whether one changed coupling has stopped one hand while the other goes on. */
  get #hasStoppedOne(): boolean {
    const { couplings, rollout } = this.shown;
    const changed = couplings.learned.flatMap((row, source) =>
      row.filter((_, target) => couplings.isChanged(source, target)),
    );
    const hands = changed.length === 1 ? this.store.compared(rollout?.values) : [];
    return hands.some(({ visited }) => visited < STOPPED) && hands.some(({ goesOn }) => goesOn);
  }

  /** Shows futures behind the loops, from this seed on; 0: none. */
  async #showFutures(seed: number): Promise<void> {
    const { model } = this.store;
    const { drawFutures } = await import("../latents/outlook-drawing");
    this.space.layers.behind = (draw, plane, part, frame) =>
      drawFutures(draw, plane, part, frame, model.futures);
    model.showFutures(seed);
  }

  #futures() {
    const { seed } = this.store.model;
    const { futures, fiveOthers } = lab().loops;
    return html`
      <div class="marks row wrap hint">
        <button class="chip" data-testid="futures" aria-pressed=${seed > 0 ? "true" : "false"} title=${futures.meaning} @click=${() => void this.#showFutures(seed > 0 ? 0 : 1)}>${futures.label}</button>
        ${seed > 0 ? html`<button class="small" data-testid="other-futures" @click=${() => void this.#showFutures(seed + FUTURES)}>${fiveOthers}</button>` : nothing}
      </div>`;
  }

  #picture() {
    const { store } = this;
    const words = drawingWords();
    if (!store.drawn)
      return html`
        <div class="picture-area draw-begin">
          <h2>${words.title}</h2>
          <p>${words.text}</p>
          <button class="small" title=${words.exampleMeaning} data-testid="draw-example" ?disabled=${store.busy} @click=${() => void store.example()}>${words.example}</button>
        </div>`;
    return coupledPicture({
      model: store.model,
      space: this.space,
      lead: store.drawn.pads.length > 1 ? words.lead.two : words.lead.one,
      problem: store.model.problem,
      foot: this.#futures(),
    });
  }

  protected override render() {
    const { says, exercise, drawing } = this.settings.values;
    const isMet = exercise === DARES.hand && this.#hasStoppedOne;
    const { dare } = drawingWords();
    return html`
      <div class="lab" data-panel="none">
        <section class="stage-area draw-area" aria-label=${drawingWords().title}>
          ${says && drawing ? html`<p class="draw-says" data-testid="said">“${says}”</p>` : nothing}
          ${exercise === DARES.hand ? html`<p class="draw-dare" role="status" data-testid="dare" data-met=${isMet ? "yes" : "no"}>${isMet ? dare.met : dare.task}</p>` : nothing}
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

export const draw: Draw<"draw"> = (store, page) =>
  html`<pg-drawing data-clock .store=${store} .settings=${page.settings} .page=${page}></pg-drawing>`;
