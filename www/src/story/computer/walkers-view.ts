// Two walkers side by side as points of light. A tap on one of them is a guess.
import { html, nothing } from "lit";
import { Columns } from "../../scene/columns";
import { underWay } from "../../scene/under-way";
import { eachFrame } from "../../ui/each-frame";
import { View } from "../../ui/view";
import { tellGuess } from "../chapter";
import type { ComputerChapter } from "./computer-chapter";
import "./computer.css";

/** The heading of both: sideways, and a little towards the visitor. */
const HEADING = Math.PI / 3;
/** Seconds in which a movement comes and goes. */
const COMING = 0.25;

export class WalkersView extends View {
  declare chapter: ComputerChapter;
  #columns: Columns | null = null;
  #drawn: unknown = null;
  #seconds = 0;

  protected override stores() {
    return [this.chapter];
  }

  protected override arrived(): void {
    const canvas = this.querySelector("canvas");
    if (!canvas) return;
    try {
      this.#columns = new Columns(canvas, { from: 0, turns: false });
    } catch {
      // Without WebGL the buttons of the card still work.
      return;
    }
    const columns = this.#columns;
    this.whenLeaving(() => {
      columns.dispose();
      [this.#columns, this.#drawn] = [null, null];
    });
    this.#show();
    this.whenLeaving(eachFrame((seconds) => this.#draw(columns, canvas, seconds)));
  }

  #draw(columns: Columns, canvas: HTMLCanvasElement, seconds: number): void {
    const { pair, playing } = this.chapter;
    const { frames, frameTime } = pair.program.motion;
    const length = (frames - 1) * frameTime;
    if (playing) this.#seconds = (this.#seconds + seconds) % length;
    columns.draw(this.#seconds / frameTime, true, seconds, playing);
    const edge = Math.min(this.#seconds, length - this.#seconds) / COMING;
    canvas.style.opacity = String(playing ? Math.min(1, 0.1 + edge) : 1);
  }

  /** Shows the pair from its first pose. */
  #show(): void {
    const { pair, body, modelSide } = this.chapter;
    if (!this.#columns || pair === this.#drawn) return;
    this.#drawn = pair;
    this.#seconds = 0;
    const walkers = modelSide === "left" ? [pair.model, pair.program] : [pair.program, pair.model];
    this.#columns.show(
      body,
      walkers.map(({ motion, speed }) => underWay(motion, speed, HEADING)),
    );
  }

  protected override updated(): void {
    this.#show();
  }

  #tap({ offsetX, currentTarget }: MouseEvent): void {
    const { clientWidth } = currentTarget as HTMLElement;
    tellGuess(this, offsetX < clientWidth / 2 ? "left" : "right");
  }

  protected override render() {
    const { names, isOpen } = this.chapter;
    return html`
      <div class="walker-screen"><canvas class=${isOpen ? "asks" : ""} aria-hidden="true" data-testid="walkers" @click=${this.#tap}></canvas></div>
      <ol class="walker-names">${names.map((name) => html`<li>${name || nothing}</li>`)}</ol>`;
  }
}
customElements.define("pg-walkers", WalkersView);
