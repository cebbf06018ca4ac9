// The stage on the page: the canvas, the names of the parts, and a message where nothing can be drawn.
import { html, nothing } from "lit";
import { eachFrame } from "../ui/browser";
import { partColour } from "../ui/palette";
import { View } from "../ui/view";
import type { Playback } from "./playback";
import { Stage } from "./stage";
import "./stage-canvas.css";
import "./stage.css";
import type { StageStore } from "./stage-store";
import { partStyle } from "../ui/styled";
import { withLab } from "../words/lab";

export class StageView extends View {
  declare stage: StageStore;
  declare playback: Playback;
  /** Whether the clock of the stage runs. */
  declare running: boolean;
  /** The name of the picture. */
  declare label: string;
  /** Its name in tests; absent: "stage". */
  declare testId: string | undefined;
  /** The name of the list of parts, and that of each part as it is shown; absent: no list. */
  declare legend: { label: string; nameOf: (part: string) => string } | undefined;
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
      this.#fail("noGraphics");
      return;
    }
    const { scene } = this;
    let isLost = false;
    this.listen(canvas, "webglcontextlost", () => {
      isLost = true;
      this.#fail("graphicsLost", () => isLost);
    });
    this.listen(canvas, "webglcontextrestored", () => {
      isLost = false;
      this.#problem = "";
      scene.update();
      this.requestUpdate();
    });
    this.whenLeaving(this.stage.on(() => scene.update()));
    this.whenLeaving(this.playback.on(() => scene.tick()));
    this.whenLeaving(() => scene.dispose());
  }

  /** Says why nothing is drawn, if that still holds when the words are there. */
  #fail(why: "noGraphics" | "graphicsLost", holds = () => true): void {
    withLab(({ stage }) => {
      if (!holds()) return;
      this.#problem = stage[why];
      this.requestUpdate();
    });
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

  #legend() {
    if (!this.legend) return nothing;
    const { label, nameOf } = this.legend;
    return html`
      <ul class="stage-legend passive stack note" aria-label=${label}>
        ${(this.stage.content?.parts ?? []).map(
          ({ name }, part) =>
            html`<li class="row" style=${partStyle(partColour(part))}><i class="swatch"></i>${nameOf(name)}</li>`,
        )}
      </ul>`;
  }

  protected override render() {
    return html`
      <canvas ?hidden=${this.stage.columns !== null}
        class="stage-canvas cover" tabindex="0" role="img" data-testid=${this.testId ?? "stage"}
        aria-label=${this.label}
      ></canvas>
      ${this.#problem ? html`<p class="stage-problem quiet" role="alert">${this.#problem}</p>` : nothing}
      ${this.#columns()}
      ${this.#legend()}
    `;
  }
}
customElements.define("pg-stage", StageView);
