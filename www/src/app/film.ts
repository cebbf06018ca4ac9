// The item Moving picture of the menu Save: some seconds of the stage as a video, by the browser's own encoder, else as
// GIF.
import { html } from "lit";
import type { SoundView } from "../live/sound-view";
import { download } from "../ui/download";
import { View } from "../ui/view";
import { messageOf } from "../ui/format";
import { loadPerforming, performingWords } from "../words/sections";
import type { App } from "./app";

/** About as long, in seconds: whole turns of the walk. */
const SECONDS = 4;
const BITS_A_SECOND = 6_000_000;
const KINDS = [
  ["mp4", "video/mp4;codecs=avc1"],
  ["webm", "video/webm;codecs=vp9"],
  ["webm", "video/webm"],
] as const;

/** The first kind of video that this browser writes, else GIF. */
const kindHere = () =>
  KINDS.find(([, type]) => "MediaRecorder" in window && MediaRecorder.isTypeSupported(type)) ??
  (["gif", "image/gif"] as const);

/** What a canvas shows until `ended`, as a video, with the sound of the page if it is on. */
async function videoOf(canvas: HTMLCanvasElement, mimeType: string, ended: Promise<void>): Promise<Blob> {
  const pieces: Blob[] = [];
  const video = canvas.captureStream(30);
  const sound = document.querySelector<SoundView>("pg-sound")?.recorded?.getTracks() ?? [];
  const both = new MediaStream([...video.getTracks(), ...sound]);
  const recorder = new MediaRecorder(both, { mimeType, videoBitsPerSecond: BITS_A_SECOND });
  recorder.ondataavailable = ({ data }) => pieces.push(data);
  const stopped = new Promise((stopped, failed) => {
    recorder.onstop = stopped;
    recorder.onerror = failed;
  });
  recorder.start();
  await ended;
  recorder.stop();
  await stopped;
  for (const track of video.getTracks()) track.stop();
  return new Blob(pieces, { type: mimeType });
}

export class Film extends View {
  static override properties = { left: { state: true }, ready: { state: true } };
  declare app: App;
  /** Seconds that are left of the recording; 0: none runs. */
  left = 0;
  ready = false;

  protected override stores() {
    return [this.app.stage];
  }

  protected override arrived(): void {
    void loadPerforming(this.app.words).then(() => {
      this.ready = true;
    });
  }

  get #canvas(): HTMLCanvasElement | null {
    return document.querySelector<HTMLCanvasElement>("pg-lab canvas.stage-canvas:not([hidden])");
  }

  /** Whole turns of the first part that has a pace, so that the last pose goes over into the first. */
  get #seconds(): number {
    const { phases, playback } = this.app;
    const period = phases.parts
      .map((_, part) => phases.period(part))
      .find((found) => typeof found === "number");
    const motion = typeof period === "number" ? Math.max(1, Math.round(SECONDS / period)) * period : SECONDS;
    return motion / (playback.speed || 1);
  }

  async #countDown(seconds: number): Promise<void> {
    const end = performance.now() + 1000 * seconds;
    this.left = Math.ceil(seconds);
    // An error ends it sooner.
    while (this.left > 0) {
      await new Promise((passed) => setTimeout(passed, Math.min(250, end - performance.now())));
      if (this.left > 0) this.left = Math.max(0, Math.ceil((end - performance.now()) / 1000));
    }
  }

  async #record(): Promise<void> {
    const canvas = this.#canvas;
    if (!canvas || this.left > 0) return;
    const [extension, type] = kindHere();
    const { playback, notices } = this.app;
    playback.play();
    try {
      const gif = extension === "gif" ? await import("./film-gif") : null;
      const ended = this.#countDown(this.#seconds);
      const film = gif ? await gif.gifOf(canvas, ended) : await videoOf(canvas, type, ended);
      const { fileNameOf } = await import("./saving");
      download(`${fileNameOf(this.app)}.${extension}`, film);
    } catch (problem) {
      notices.addError(performingWords().notFilmed, messageOf(problem));
    }
    this.left = 0;
  }

  protected override render() {
    if (!this.ready) return html``;
    const { film } = performingWords();
    const about = this.left > 0 ? film.left(this.left) : film.about;
    return html`
      <button data-testid="save-film" ?disabled=${!this.#canvas || this.left > 0} @click=${() => void this.#record()}>
        <span>${film.title}<small class="own-line" role="status">${about}</small></span><small>${kindHere()[0].toUpperCase()}</small></button>`;
  }
}
customElements.define("pg-film", Film);
