// The controls of the clock, and the frames that an inducing point lights up.
import { html, nothing } from "lit";
import { SETTINGS } from "../settings/settings";
import type { SettingsStore } from "../settings/settings-store";
import { clearCanvas } from "../ui/browser";
import { fixed } from "../ui/format";
import { icon } from "../ui/icons";
import { onThemeChange, partColourNow } from "../ui/palette";
import { limitWords } from "../settings/number-field";
import { View } from "../ui/view";
import type { Playback } from "./playback";
import { spotlight } from "./spotlight";
import type { Marks, StageStore } from "./stage-store";
import { lab } from "../words/lab";

export class TimelineView extends View {
  declare stage: StageStore;
  declare playback: Playback;
  declare settings: SettingsStore;
  #drawn: { marks: Marks | null; width: number } | null = null;

  protected override arrived(): void {
    const redraw = () => {
      this.#drawn = null;
      this.requestUpdate();
    };
    this.whenLeaving(onThemeChange(redraw));
  }

  override updated(): void {
    const canvas = this.querySelector("canvas");
    if (!canvas) return;
    const { marks } = this.stage;
    const width = canvas.clientWidth;
    if (this.#drawn?.marks === marks && this.#drawn.width === width) return;
    this.#drawn = { marks, width };
    drawMarks(canvas, marks);
  }

  /** The length of the motion, which can be chosen for the model's motion only. */
  #length(frameTime: number, last: string) {
    if (this.stage.content?.live) return nothing;
    if (this.stage.content?.kind !== "model") return html`<span> / ${last} s</span>`;
    const { frames } = this.settings.values;
    const { min, max } = SETTINGS.frames;
    const seconds = (frames: number) => String(Number((frames * frameTime).toFixed(1)));
    const change = (event: Event) => {
      const input = event.target as HTMLInputElement;
      const detail = input.valueAsNumber;
      if (detail > 0) this.tell("set-seconds", detail);
      input.value = seconds(this.settings.values.frames);
      const words = input.parentElement?.nextElementSibling;
      const limits = { min: Number(seconds(min)), max: Number(seconds(max)) };
      if (words) words.textContent = limitWords(detail, limits);
    };
    return html`<label title=${lab().time.lengthMeaning(seconds(min), seconds(max))}> /
      <input type="number" data-testid="length" aria-label=${lab().time.length} min=${seconds(min)} max=${seconds(max)}
        step="1" .value=${seconds(frames)} @change=${change} /> s</label><small class="limit" role="status" data-testid="length-limit"></small>`;
  }

  /** Goes on without an end, or back to a motion of some seconds. */
  #live() {
    const { content } = this.stage;
    if (content?.kind !== "model") return nothing;
    const live = content.live === true;
    const words = lab().time;
    const turn = () => this.tell("switch-live", !live);
    return html`<button class="chip" aria-pressed=${live ? "true" : "false"} data-testid="live-on" title=${words.liveMeaning} @click=${turn}>${words.live}</button>`;
  }

  protected override render() {
    const { playback, settings } = this;
    const { playing, lastFrame } = playback;
    const words = lab().time;
    const { speed: now } = settings.values;
    const frameTime = this.stage.content?.motion.frameTime ?? 1 / 30;
    const frame = Math.min(Math.floor(playback.frame + 1e-6), lastFrame);
    const seconds = (value: number) => fixed(value * frameTime, 1);
    return html`
      <div class="timeline row" data-playing=${playing ? "yes" : "no"} role="group" aria-label=${words.label}>
        <button class="round primary" data-testid="play" aria-label=${playing ? words.pause : words.play} title=${playing ? words.pauseMeaning : words.playMeaning}
          @click=${() => playback.togglePlay()}>${icon(playing ? "pause" : "play")}</button>
        <button class="round step" aria-label=${words.back} title=${words.backMeaning} @click=${() => playback.step(-1)}>${icon("back")}</button>
        <button class="round step" aria-label=${words.forward} title=${words.forwardMeaning} @click=${() => playback.step(1)}>${icon("forward")}</button>
        ${this.#live()}
        <div class="scrub">
          <canvas class="passive" aria-hidden="true"></canvas>
          <input class="cover" type="range" aria-label=${words.frame} data-testid="scrub" ?disabled=${this.stage.content?.live === true} min="0" max=${lastFrame} step="1" .value=${String(frame)}
            aria-valuetext=${words.frameOf(frame + 1, lastFrame + 1)}
            @input=${(event: Event) => playback.scrub((event.target as HTMLInputElement).valueAsNumber)} />
        </div>
        <span class="clock note tabular"><output aria-hidden="true">${seconds(frame)}</output>${this.#length(frameTime, seconds(lastFrame))}</span>
        <label class="speed"><span class="visually-hidden">${words.speed}</span>
          <select aria-label=${words.speed} @change=${(event: Event) => {
            const chosen = SETTINGS.speed.read((event.target as HTMLSelectElement).value);
            if (chosen !== null) settings.change({ speed: chosen });
          }}>
            ${SETTINGS.speed.values.map(
              (speed) => html`<option value=${speed} ?selected=${speed === now}>${speed}×</option>`,
            )}
          </select>
        </label>
      </div>
    `;
  }
}
customElements.define("pg-timeline", TimelineView);

/** Lights up the frames of an inducing point. */
function drawMarks(canvas: HTMLCanvasElement, marks: Marks | null): void {
  const paper = clearCanvas(canvas);
  if (!paper || !marks) return;
  const { draw, height } = paper;
  draw.fillStyle = partColourNow(marks.part);
  const width = paper.width / Math.max(1, marks.frames.length);
  spotlight(marks.frames).forEach((share, frame) => {
    if (share < 0.02) return;
    draw.globalAlpha = share;
    draw.fillRect(frame * width, 0, Math.max(0.5, width + 0.25), height);
  });
}
