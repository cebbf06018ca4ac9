// The handles that trim the clip on the stage, over the whole length of its recording.
import { html } from "lit";
import type { Playback } from "../stage/playback";
import type { StageStore } from "../stage/stage-store";
import { View } from "../ui/view";
import type { ClipEntry, ClipsStore } from "./clips-store";
import "./trim.css";
import { styled } from "../ui/styled";
import { lab } from "../words/lab";

export class TrimView extends View {
  declare clips: ClipsStore;
  declare stage: StageStore;
  declare playback: Playback;

  protected override stores() {
    return [this.clips, this.stage];
  }

  get #clip(): ClipEntry | undefined {
    return this.clips.all.find(({ key }) => key === this.stage.clip);
  }

  /** Cuts, and shows the frame that is now the first or the last. */
  #cut(event: Event, side: "first" | "end"): void {
    const shown = this.#clip;
    if (!shown) return;
    const handle = event.target as HTMLInputElement;
    const asked: ClipEntry = { ...shown, [side]: handle.valueAsNumber };
    this.clips.cut(asked.key, asked.first, asked.end);
    this.playback.scrub(side === "first" ? 0 : this.playback.lastFrame);
    // A handle beyond its limit goes back; Lit does not draw an unchanged value again.
    handle.value = String((this.#clip ?? shown)[side]);
  }

  protected override render() {
    const clip = this.#clip;
    if (!clip) return html``;
    const { title, first, end, loaded } = clip;
    const { frames, frameTime } = loaded.info;
    const words = lab().learn.clips;
    const seconds = (frame: number) => words.seconds(frame * frameTime);
    const share = (frame: number) => `${((100 * frame) / frames).toFixed(2)}%`;
    return html`
      <div class="trim row hint" role="group" aria-label=${words.trim(title)}>
        <span>${words.keep}</span>
        <div class="handles" style=${styled({ "--from": share(first), "--to": share(end) })}>
          <input class="cover" type="range" data-testid="trim-first" aria-label=${words.trimSide.first(title)} min="0" max=${frames} .value=${String(first)}
            aria-valuetext=${words.frame(first + 1, seconds(first))} ?disabled=${this.clips.locked}
            @input=${(event: Event) => this.#cut(event, "first")} />
          <input class="cover" type="range" data-testid="trim-end" aria-label=${words.trimSide.end(title)} min="0" max=${frames} .value=${String(end)}
            aria-valuetext=${words.frame(end, seconds(end))} ?disabled=${this.clips.locked}
            @input=${(event: Event) => this.#cut(event, "end")} />
        </div>
        <output>${words.range(seconds(first), seconds(end))}</output>
      </div>`;
  }
}
customElements.define("pg-trim", TrimView);
