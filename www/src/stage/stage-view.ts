// The stage on the page: the canvas, the names of the parts, and a message where nothing can be drawn.
import { html, nothing } from "lit";
import { eachFrame } from "../ui/each-frame";
import { partColour } from "../ui/palette";
import { View } from "../ui/view";
import type { Playback } from "./playback";
import { Stage } from "./stage";
import "./stage.css";
import type { StageStore } from "./stage-store";
import { partStyle } from "../ui/styled";

const LABEL =
  "A figure walking. Drag to look from another side, scroll to come closer; with the keyboard: w, a, s, d, plus and minus.";

export class StageView extends View {
  declare stage: StageStore;
  declare playback: Playback;
  /** Whether the clock of the stage runs. */
  declare running: boolean;
  /** The name of the picture, for another language. */
  declare label: string | undefined;
  /** Null where there is no WebGL. */
  scene: Stage | null = null;
  #problem = "";

  protected override stores() {
    return [this.stage];
  }

  protected override arrived(): void {
    const canvas = this.querySelector("canvas");
    if (!canvas) return;
    this.#keepTime();
    try {
      this.scene = new Stage(this.stage, this.playback, canvas);
    } catch {
      this.#problem =
        "This browser shows no 3-D graphics (WebGL), so the figure cannot be drawn. The latent plots, couplings and training work all the same.";
      this.requestUpdate();
      return;
    }
    const { scene } = this;
    this.listen(canvas, "webglcontextlost", () => {
      this.#problem =
        "The browser has taken the 3-D graphics away, perhaps because other pages need them. The figure comes back when it gives them back; reloading the page may help.";
      this.requestUpdate();
    });
    this.listen(canvas, "webglcontextrestored", () => {
      this.#problem = "";
      scene.update();
      this.requestUpdate();
    });
    this.whenLeaving(this.stage.on(() => scene.update()));
    this.whenLeaving(this.playback.on(() => scene.tick()));
    this.whenLeaving(() => scene.dispose());
  }

  /** Moves the clock on and draws, once a display frame. */
  #keepTime(): void {
    const frame = (seconds: number) => {
      if (!this.running) return;
      this.playback.advance(seconds);
      if (!this.stage.columns) this.scene?.draw(seconds);
    };
    this.whenLeaving(eachFrame(frame));
  }

  /** Several motions side by side. One figure walks alone if their view cannot be loaded. */
  #columns() {
    if (!this.stage.columns) return nothing;
    import("./columns-view").catch(() => this.stage.setColumns(null));
    return html`<pg-columns .stage=${this.stage} .playback=${this.playback}></pg-columns>`;
  }

  protected override render() {
    return html`
      <canvas ?hidden=${this.stage.columns !== null}
        class="stage-canvas" tabindex="0" role="img" data-testid="stage"
        aria-label=${this.label ?? LABEL}
      ></canvas>
      ${this.#problem ? html`<p class="stage-problem" role="alert">${this.#problem}</p>` : nothing}
      ${this.#columns()}
      <ul class="stage-legend" aria-label="Parts">
        ${(this.stage.content?.parts ?? []).map(
          ({ name }, part) =>
            html`<li style=${partStyle(partColour(part))}><i class="swatch"></i>${name}</li>`,
        )}
      </ul>
    `;
  }
}
customElements.define("pg-stage", StageView);
