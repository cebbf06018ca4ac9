// The handles that trim the clip on the stage, over the whole length of its recording.
import { html } from "lit";
import type { Playback } from "../stage/playback";
import type { StageStore } from "../stage/stage-store";
import { View } from "../ui/view";
import type { ClipsStore } from "./clips-store";
import "./trim.css";
import { styled } from "../ui/styled";

export class TrimView extends View {
  declare clips: ClipsStore;
  declare stage: StageStore;
  declare playback: Playback;

  protected override stores() {
    return [this.clips, this.stage];
  }

  /** Cuts, and stops at the frame that is now the first or the last, so that it can be seen. */
  private cut(key: string, change: { first: number } | { end: number }): void {
    const clip = this.clips.all.find((clip) => clip.key === key);
    if (!clip) return;
    const { first, end } = { ...clip, ...change };
    this.clips.cut(key, first, end);
    this.playback.scrub("first" in change ? 0 : this.playback.lastFrame);
    // Where the handle may not go, it goes back.
    this.requestUpdate();
  }

  protected override render() {
    const clip = this.clips.all.find(({ key }) => key === this.stage.clip);
    if (!clip) return html``;
    const { key, title, first, end, loaded } = clip;
    const { frames, frameTime } = loaded.info;
    const value = (event: Event) => (event.target as HTMLInputElement).valueAsNumber;
    const seconds = (frame: number) => `${(frame * frameTime).toFixed(1)} s`;
    const share = (frame: number) => `${((100 * frame) / frames).toFixed(2)}%`;
    return html`
      <div class="trim" role="group" aria-label="Trim ${title}">
        <span>Keep</span>
        <div class="handles" style=${styled({ "--from": share(first), "--to": share(end) })}>
          <input type="range" data-testid="trim-first" aria-label="Trim the start of ${title}" min="0" max=${frames} .value=${String(first)}
            aria-valuetext="frame ${first + 1}, ${seconds(first)}" ?disabled=${this.clips.locked}
            @input=${(event: Event) => this.cut(key, { first: value(event) })} />
          <input type="range" data-testid="trim-end" aria-label="Trim the end of ${title}" min="0" max=${frames} .value=${String(end)}
            aria-valuetext="frame ${end}, ${seconds(end)}" ?disabled=${this.clips.locked}
            @input=${(event: Event) => this.cut(key, { end: value(event) })} />
        </div>
        <output>${seconds(first)} to ${seconds(end)}</output>
      </div>`;
  }
}
customElements.define("pg-trim", TrimView);
