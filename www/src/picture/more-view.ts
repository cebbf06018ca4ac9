// The panel More: what the plots show, where the motion begins, and both readings side by side.
import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
import type { ClipStartStore } from "../couplings/clip-start-store";
import type { ModelInfo } from "../engine/protocol";
import "../latents/layers-view";
import { clipTitle, fixed } from "../ui/format";
import { withTerms } from "../terms/term";
import { View } from "../ui/view";
import { lab } from "../words/lab";
import type { PictureStores } from "./picture-view";

export class MoreView extends View {
  declare app: PictureStores & { readonly starts: ClipStartStore };

  protected override stores() {
    const { model, settings, starts, readings } = this.app;
    return [model, settings, starts, readings];
  }

  #starts({ sequences }: ModelInfo) {
    const { model, settings, starts, playback } = this.app;
    const { start, startFrame } = settings.values;
    const last = model.startFrames(start) - 1;
    const frame = Math.min(startFrame, last);
    // The clock stops at frame 0, so that the first pose is visible.
    const from = (event: Event) => {
      playback.scrub(0);
      model.setStart(start, (event.target as HTMLInputElement).valueAsNumber);
    };
    const frames =
      last > 0 && starts.clip === null
        ? html`<label class="start row quiet">${lab().couplings.fromFrame} <input type="range" min="0" max=${last} .value=${String(frame)} data-testid="start-frame"
            aria-valuetext=${lab().couplings.frame(frame + 1, last + 1)} @input=${from} /><output>${frame + 1}</output></label>`
        : nothing;
    return html`${this.#startChoice(sequences, start)}${frames}`;
  }

  /** The training sequences and the other clips that a rollout can start as. */
  #startChoice(sequences: ModelInfo["sequences"], start: number) {
    const { starts } = this.app;
    const { clip: chosen, clips, observed } = starts;
    if (sequences.length + clips.length < 2) return nothing;
    const words = lab().couplings;
    const choose = (event: Event) => {
      const { value } = event.target as HTMLSelectElement;
      if (clips.some(({ key }) => key === value)) starts.chooseClip(value);
      else starts.chooseSequence(Number(value));
    };
    // A choice that failed must show the present start again.
    const option = (value: string, name: string, selected: boolean) =>
      html`<option value=${value} .selected=${live(selected)}>${clipTitle(name)}</option>`;
    return html`
      <label class="start row quiet">${words.startAs}
        <select aria-label=${words.startLabel} aria-busy=${starts.isBusy ? "true" : "false"} @change=${choose}>
          <optgroup label=${words.trainedOn}>
            ${sequences.map(({ name }, i) => option(String(i), name, chosen === null && i === start))}
          </optgroup>
          ${
            clips.length > 0
              ? html`<optgroup label=${words.notTrainedOn}>${clips.map(({ key, title }) => option(key, title, key === chosen))}</optgroup>`
              : nothing
          }
        </select>
      </label>
      ${chosen === null ? nothing : html`<p class="hint" data-testid="clip-start">${words.clipStart(fixed(observed, 1))}</p>`}`;
  }

  protected override render() {
    const { model, layers, predictions, settings, readings } = this.app;
    const info = model.model?.info;
    const { loops, stage, readings: words } = lab();
    if (!info) return nothing;
    // Its button is there when it has loaded.
    import("../live/sound-view").catch(() => {});
    const { bothShown } = readings;
    const { loop, samples } = settings.values;
    return html`
      <h2>${withTerms(loops.title)}</h2>
      <p class="hint">${withTerms(loops.about)}</p>
      <pg-layers .layers=${layers} .predictions=${predictions} .settings=${settings} .parts=${info.parts.length}></pg-layers>
      <h2>${lab().couplings.begins}</h2>
      <div class="starts wrap">${this.#starts(info)}</div>
      <button class="chip" aria-pressed=${samples ? "true" : "false"} title=${stage.samplesMeaning} @click=${() => model.playSamples(!samples)}>${stage.playSamples}</button>
      <button class="chip" aria-pressed=${loop ? "true" : "false"} @click=${() => settings.change({ loop: !loop })}>${lab().time.loop}</button>
      <pg-sound .app=${this.app}></pg-sound>
      ${
        info.parts.length > 1
          ? html`
          <h2>${withTerms(words.title)} <pg-term of="reading" text="?" about=${words.about}></pg-term></h2>
          <p class="hint">${withTerms(words.meaning[settings.values.reading])}</p>
          <button class="small" aria-pressed=${bothShown ? "true" : "false"} data-testid="readings-beside"
            @click=${() => readings.show(!bothShown)}>${words.bothButton}</button>`
          : nothing
      }`;
  }
}
customElements.define("pg-more", MoreView);
