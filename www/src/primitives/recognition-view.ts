// Which primitive of the library each part uses in a recording: the figure, and under it one band for each part
// with the primitive that the part uses at each moment.
import { html, nothing } from "lit";
import type { LibraryInfo, Recognised } from "../engine/library-protocol";
import { shapeOf, type Shape } from "../scene/body-shape";
import { HERE, poseAt } from "../scene/motion";
import { partOfJoints } from "../scene/joints";
import { floorOf, headingOf } from "../scene/stance";
import { clearCanvas, eachFrame } from "../ui/browser";
import { fixed, sentence } from "../ui/format";
import { icon } from "../ui/icons";
import { onThemeChange, partColour, partColourNow } from "../ui/palette";
import { progressBar } from "../ui/progress-bar";
import { partStyle, styled } from "../ui/styled";
import { View } from "../ui/view";
import { lab, shownPart } from "../words/lab";
import { primitivesWords } from "./view-words";
import type { LibraryStore } from "./library-store";
import "./recognition.css";
import { type Band, bandsOf, nameOf, type RecognitionStore } from "./recognition-store";
import { drawStrokes, SIDE, strokesOf } from "./small-figure";

/** What does not change while a recording plays. */
interface Drawn {
  of: Recognised;
  shape: Shape;
  parts: Int16Array;
  pose: Float32Array;
  floor: number;
  turn: number;
}

export class RecognitionView extends View {
  declare recognition: RecognitionStore;
  declare library: LibraryStore;
  #drawn: Drawn | null = null;

  protected override arrived(): void {
    this.whenLeaving(onThemeChange(() => this.#draw()));
    this.watchSize(this, () => this.#draw());
    const tick = (seconds: number) => {
      if (!this.recognition.found || !this.recognition.player.playing) return;
      this.recognition.player.advance(seconds);
      this.#draw();
    };
    this.whenLeaving(eachFrame(tick));
  }

  protected override updated(): void {
    this.#draw();
  }

  #preparedFor(found: Recognised, { figure, joints, parts }: LibraryInfo): Drawn {
    if (this.#drawn?.of === found) return this.#drawn;
    const pose = poseAt(found.motion, 0, HERE, new Float32Array(found.motion.nodes * 3));
    this.#drawn = {
      of: found,
      shape: shapeOf(
        figure,
        joints.map(({ name }) => name),
        pose,
      ),
      parts: partOfJoints(joints.length, parts),
      pose,
      floor: floorOf(found.motion),
      turn: headingOf(found.motion) + SIDE,
    };
    return this.#drawn;
  }

  /** Draws the pose of the frame now, and moves the line of the time to it. */
  #draw(): void {
    const { found, player } = this.recognition;
    const info = this.library.current?.info;
    const canvas = this.querySelector("canvas");
    const surface = canvas && canvas.clientWidth > 0 ? clearCanvas(canvas) : null;
    if (!found || !info || !surface) return;
    const { shape, parts, pose, floor, turn } = this.#preparedFor(found, info);
    poseAt(found.motion, player.frame, HERE, pose);
    drawStrokes(surface.draw, strokesOf(shape, parts, pose, { ...surface, floor, turn }), partColourNow);
    const time = this.querySelector<HTMLInputElement>("input[type=range]");
    if (time) {
      time.value = String(player.frame);
      const at = player.frame / Math.max(1, player.last);
      this.querySelector<HTMLElement>(".bands")?.style.setProperty("--at", String(at));
    }
  }

  #choice(place: number) {
    const { recognition } = this;
    const words = primitivesWords().recognition;
    const chosen = recognition.chosen[place]?.key ?? "";
    return html`
      <label class="row tight hint">${place === 0 ? words.clip : words.after}
        <select data-testid="recognise-${place}" @change=${(event: Event) => recognition.choose(place, (event.target as HTMLSelectElement).value)}>
          ${place === 0 ? nothing : html`<option value="" ?selected=${chosen === ""}>${words.nothing}</option>`}
          ${recognition.clips.map(({ key, title }) => html`<option value=${key} ?selected=${key === chosen}>${title}</option>`)}
        </select></label>`;
  }

  #band(part: number, { primitive, first, end }: Band, frames: number, info: LibraryInfo) {
    const name = info.primitives[primitive]?.name ?? "";
    // The primitives of a part have the colour of the part, the later ones with more white.
    const place = info.primitives.slice(0, primitive).filter((other) => other.part === part).length;
    const style = { left: `${(100 * first) / frames}%`, width: `${(100 * (end - first)) / frames}%` };
    return html`<span class="band ellipsis" style=${styled({ ...style, "--place": place })} title=${name}>${name}</span>`;
  }

  #bands({ motion, segments }: Recognised, info: LibraryInfo) {
    const words = primitivesWords().recognition;
    const { frames, frameTime } = motion;
    const text = segments.map((segment) =>
      words.segment(
        nameOf(segment, info),
        fixed(segment.first * frameTime, 1),
        fixed(segment.end * frameTime, 1),
      ),
    );
    return html`
      <div class="bands" aria-hidden="true">
        ${info.parts.map(
          ({ name }, part) => html`
          <span class="band-part ellipsis">${shownPart(name)}</span>
          <div class="band-row" data-testid="bands-${part}" style=${partStyle(partColour(part))}>
            ${bandsOf(segments, part).map((band) => this.#band(part, band, frames, info))}
          </div>`,
        )}
      </div>
      <p role="status" data-testid="recognised">${sentence(text.join(", "))}</p>`;
  }

  #result(found: Recognised, info: LibraryInfo) {
    const { recognition } = this;
    const { playing, last } = recognition.player;
    const { time } = lab();
    const words = primitivesWords().recognition;
    return html`
      <canvas class="recognised-figure" role="img" aria-label=${words.figure}></canvas>
      <div class="recognised-time">
        <button class="round" data-testid="recognised-play" aria-label=${playing ? time.pause : time.play}
          @click=${() => recognition.togglePlay()}>${icon(playing ? "pause" : "play")}</button>
        <input type="range" min="0" max=${last} step="any" aria-label=${words.time}
          @input=${(event: Event) => recognition.goTo((event.target as HTMLInputElement).valueAsNumber)} />
      </div>
      ${this.#bands(found, info)}`;
  }

  protected override render() {
    const { recognition } = this;
    const info = this.library.current?.info;
    const words = primitivesWords().recognition;
    if (!info) return nothing;
    const { fraction, problem, found } = recognition;
    const busy = fraction !== null;
    const tooFew = info.movements.length < 2;
    return html`
      <h2>${words.title}</h2>
      <p class="hint">${words.about}</p>
      <div class="fit-row row wrap">
        ${recognition.chosen.map((_, place) => this.#choice(place))}
        <button class="small primary" data-testid=${busy ? "recognise-cancel" : "recognise"} ?disabled=${tooFew || recognition.clips.length === 0}
          @click=${() => (busy ? recognition.cancel() : void recognition.recognise())}>${busy ? lab().learn.training.cancel : words.recognise}</button>
      </div>
      ${progressBar(words.going, fraction)}
      ${problem ? html`<p class="bad" role="alert">${sentence(problem)}</p>` : nothing}
      ${tooFew ? html`<p class="hint">${words.tooFew}</p>` : nothing}
      ${found ? this.#result(found, info) : nothing}`;
  }
}
customElements.define("pg-recognition", RecognitionView);
