// An element with a small moving figure, with all parts or one part in colour.
import { html } from "lit";
import type { Motion } from "../engine/protocol";
import type { Body } from "../scene/columns";
import { clearCanvas, eachFrame } from "../ui/browser";
import { onThemeChange, partColourNow, theme } from "../ui/palette";
import { View } from "../ui/view";
import { SmallFigure } from "./small-figure";

/** Milliseconds between two pictures. */
const BETWEEN = 40;

export class SmallFigureView extends View {
  static override properties = { motion: {}, body: {}, accent: {}, playing: {} };
  declare body: Body;
  /** Null before it has arrived. */
  declare motion: Motion | null;
  /** The part in colour; null for all parts. */
  declare accent: number | null;
  declare playing: boolean;
  #figure: SmallFigure | null = null;
  /** Milliseconds that it has walked. */
  #walked = 0;
  #drawn = -BETWEEN;

  protected override arrived(): void {
    this.whenLeaving(onThemeChange(() => this.#draw()));
    this.watchSize(this, () => this.#draw());
    const tick = (seconds: number) => {
      if (this.playing) this.#walked += 1000 * seconds;
      if (this.#walked - this.#drawn >= BETWEEN) this.#draw();
    };
    this.whenLeaving(eachFrame(tick));
  }

  override willUpdate(changed: Map<string, unknown>): void {
    if (!changed.has("motion") && !changed.has("body")) return;
    this.#figure = this.motion && new SmallFigure(this.body, this.motion);
  }

  protected override updated(): void {
    this.#draw();
  }

  #draw(): void {
    const canvas = this.querySelector("canvas");
    const surface = canvas && canvas.clientWidth > 0 ? clearCanvas(canvas) : null;
    if (!surface || !this.#figure) return;
    this.#drawn = this.#walked;
    const pale = theme().dark ? "#3d444b" : "#d3d5d6";
    const colourOf = (part: number) =>
      part >= 0 && (this.accent === null || this.accent === part) ? partColourNow(part) : pale;
    this.#figure.draw(surface.draw, surface, this.#walked / 1000, colourOf);
  }

  protected override render() {
    return html`<canvas aria-hidden="true"></canvas>`;
  }
}
customElements.define("pg-small-figure", SmallFigureView);
