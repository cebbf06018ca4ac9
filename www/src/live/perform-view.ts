// Buttons that record what the visitor does live, and two feet for two fingers or two keys.
import { html, nothing } from "lit";
import type { LiveBody } from "../engine/protocol";
import type { Playback } from "../stage/playback";
import { eachFrame } from "../ui/browser";
import { isUsedByControl } from "../ui/keyboard";
import { View } from "../ui/view";
import { performingWords } from "../words/sections";
import { type Asked, Feet, type Foot, gaitOf, legsOf } from "./feet";
import type { LiveStore } from "./live-store";
import { LONGEST, type Performance } from "./performance";
import "./perform.css";

const KEYS: Record<string, Foot> = { f: 0, j: 1 };

export class PerformView extends View {
  static override properties = { said: { state: true }, feet: { state: true }, waits: { state: true } };
  declare performed: Performance;
  /** What the last press asked for. */
  declare said: Asked | null;
  /** Whether two fingers are the feet. */
  declare feet: boolean;
  /** Whether the feet wait for the first cycle of the motion. */
  declare waits: boolean;
  #walker: { feet: Feet; part: number } | null = null;
  #stop = () => {};
  /** The body of the live motion, and whether it has legs. */
  #body: LiveBody | null = null;
  #legs = false;

  constructor() {
    super();
    [this.said, this.feet, this.waits] = [null, false, false];
  }

  protected override stores() {
    return [this.live, this.performed];
  }

  get live(): LiveStore {
    return this.performed.live;
  }

  get playback(): Playback {
    return this.performed.app.playback;
  }

  protected override arrived(): void {
    this.whenLeaving(() => this.#walk(false));
    this.listen(window, "keydown", (event) => {
      const { key, repeat } = event as KeyboardEvent;
      const foot = KEYS[key.toLowerCase()];
      if (!this.feet || foot === undefined || repeat || isUsedByControl(event as KeyboardEvent)) return;
      this.#press(foot);
    });
  }

  override updated(): void {
    if (this.feet && !this.live.running) this.#walk(false);
  }

  /** Whether two feet can move a part of the body. In the first frames a foot may be in the air. */
  get #hasLegs(): boolean {
    const { body, track } = this.live;
    if (this.#body !== body) [this.#body, this.#legs] = [body, false];
    this.#legs ||= body !== null && track !== null && legsOf(body, track) !== null;
    return this.#legs;
  }

  /** Gives the feet to the visitor, or back to the model. */
  #walk(on: boolean): void {
    this.#stop();
    if (this.#walker && this.live.running) this.live.release(this.#walker.part);
    [this.#walker, this.feet, this.said, this.waits] = [null, on, null, on];
    if (on) this.#stop = eachFrame((seconds) => this.#follow(seconds));
  }

  #follow(seconds: number): void {
    const { live, playback } = this;
    if (!this.#walker) {
      const gait = live.body && live.track && gaitOf(live.body, live.track, live.trace);
      if (!gait) return;
      const phase = live.trace.at(-1)?.phases[gait.part] ?? 0;
      this.#walker = { feet: new Feet(gait, phase), part: gait.part };
      this.waits = false;
      live.drive(gait.part, 0, true);
    }
    if (!playback.playing) return;
    const turns = this.#walker.feet.advance(seconds * playback.speed);
    if (turns > 0) live.drive(this.#walker.part, turns, true);
  }

  #press(foot: Foot): void {
    if (this.#walker) this.said = this.#walker.feet.press(foot, performance.now() / 1000);
    this.querySelector(`[data-testid="foot-${foot}"]`)?.animate({ scale: [0.95, 1] }, 150);
  }

  #foot(foot: Foot) {
    const words = performingWords();
    // A key on the button comes as a click without a pointer.
    const click = ({ detail }: MouseEvent) => detail === 0 && this.#press(foot);
    return html`<button class="foot" data-testid="foot-${foot}" @pointerdown=${() => this.#press(foot)} @click=${click}>${words.foot[foot]} <kbd>${foot === 0 ? "F" : "J"}</kbd></button>`;
  }

  #state(): string {
    const words = performingWords();
    if (this.performed.busy) return words.making;
    if (!this.feet) return "";
    return this.waits ? words.waits : words.says[this.said ?? "step"];
  }

  protected override render() {
    const { live, performed: own } = this;
    if (!live.running) return nothing;
    const words = performingWords();
    const { clip } = own;
    const hasLegs = live.isCyclic && this.#hasLegs;
    const record = () => void (own.isRecording ? own.stop() : own.start());
    return html`
      <div class="perform" data-testid="perform">
        <div class="button-row">
          <button class="chip" data-testid="record" aria-pressed=${own.isRecording ? "true" : "false"} ?disabled=${own.busy} title=${words.recordMeaning} @click=${record}>
            <span class="record-dot"></span> ${own.isRecording ? words.left(own.left) : words.record(LONGEST)}</button>
          <button class="chip" data-testid="feet" aria-pressed=${this.feet ? "true" : "false"} title=${hasLegs ? words.feetMeaning : words.noLegs} ?disabled=${!hasLegs}
            @click=${() => this.#walk(!this.feet)}>${words.feet}</button>
          ${
            clip
              ? html`<button class="small" data-testid="play-performed" @click=${() => own.show()}>${words.play(clip.title)}</button>
              <button class="small" data-testid="train-performed" title=${words.trainMeaning} @click=${() => void own.train()}>${words.train}</button>`
              : nothing
          }
        </div>
        ${this.feet ? html`<div class="feet" role="group" aria-label=${words.feet}>${this.#foot(0)}${this.#foot(1)}</div>` : nothing}
        <p role="status" class="perform-state">${this.#state()}</p>
      </div>`;
  }
}
customElements.define("pg-perform", PerformView);
