// The clock's controls: play, step, scrub, speed, loop; and the frames an inducing point speaks for.
import { html } from "lit";
import { changeSettings } from "../settings/change";
import { partColour, theme } from "../ui/palette";
import { SETTINGS } from "../settings/settings";
import { icon } from "../ui/icons";
import { spotlight } from "./spotlight";
import { View } from "../ui/view";

export class TimelineView extends View {
  static override topics = ["playback", "shown", "tick", "pointed"] as const;
  private drawnFor: unknown = null;

  togglePlay(): void {
    const { player } = this.app;
    if (player.playing) player.pause();
    else player.play();
    this.app.tell("playback", "tick");
  }

  step(direction: 1 | -1): void {
    this.app.player.step(direction);
    this.app.goTo(this.app.player.frame);
    this.app.tell("playback");
  }

  private scrub(event: Event): void {
    this.app.player.pause();
    this.app.goTo(Number((event.target as HTMLInputElement).value));
    this.app.tell("playback");
  }

  override updated(): void {
    const { pointed } = this.app;
    const canvas = this.querySelector("canvas")!;
    const key = `${canvas.clientWidth}`;
    if (this.drawnFor === (pointed ?? key)) return;
    this.drawnFor = pointed ?? key;
    this.drawMarks(canvas);
  }

  /** Lights up the frames that the pointed-at inducing point speaks for. */
  private drawMarks(canvas: HTMLCanvasElement): void {
    const { pointed } = this.app;
    const ratio = Math.min(2, devicePixelRatio);
    canvas.width = Math.max(1, canvas.clientWidth * ratio);
    canvas.height = Math.max(1, canvas.clientHeight * ratio);
    const draw = canvas.getContext("2d");
    if (!draw) return;
    draw.clearRect(0, 0, canvas.width, canvas.height);
    if (!pointed) return;
    const { point } = pointed;
    const frames = spotlight(pointed.frames);
    draw.fillStyle = point ? partColour(point.kind === "pose" ? point.part : point.source) : theme().ink;
    const width = canvas.width / Math.max(1, frames.length);
    frames.forEach((share, frame) => {
      if (share < 0.02) return;
      draw.globalAlpha = share;
      draw.fillRect(frame * width, 0, Math.max(1, width + 0.5), canvas.height);
    });
  }

  protected override render() {
    const { player, shown, settings } = this.app;
    const frameTime = shown?.motion.frameTime ?? 1 / 30;
    const frame = Math.min(Math.floor(player.frame + 1e-6), player.last);
    const seconds = (value: number) => (value * frameTime).toFixed(1);
    const playing = player.playing;
    return html`
      <div class="timeline" role="group" aria-label="Time">
        <button class="round primary" data-testid="play" aria-label=${playing ? "Pause" : "Play"} title=${playing ? "Pause (space)" : "Play (space)"}
          @click=${this.togglePlay}>${icon(playing ? "pause" : "play")}</button>
        <button class="round" aria-label="One frame back" title="One frame back (left arrow)" @click=${() => this.step(-1)}>${icon("back")}</button>
        <button class="round" aria-label="One frame forward" title="One frame forward (right arrow)" @click=${() => this.step(1)}>${icon("forward")}</button>
        <div class="scrub">
          <canvas aria-hidden="true"></canvas>
          <input type="range" aria-label="Frame" data-testid="scrub" min="0" max=${player.last} step="1" .value=${String(frame)}
            aria-valuetext="Frame ${frame + 1} of ${player.last + 1}" @input=${this.scrub} />
        </div>
        <output class="clock" aria-hidden="true">${seconds(frame)}<span> / ${seconds(player.last)} s</span></output>
        <button class="round toggle" aria-label="Loop" title="Loop" aria-pressed=${player.loops ? "true" : "false"}
          @click=${() => changeSettings(this.app, { loop: !settings.loop })}>${icon("loop")}</button>
        <label class="speed"><span class="hidden">Speed</span>
          <select aria-label="Speed" @change=${(event: Event) =>
            changeSettings(this.app, { speed: Number((event.target as HTMLSelectElement).value) as 1 })}>
            ${SETTINGS.speed.values.map(
              (speed) => html`<option value=${speed} ?selected=${speed === settings.speed}>${speed}×</option>`,
            )}
          </select>
        </label>
      </div>
    `;
  }
}
customElements.define("pg-timeline", TimelineView);
