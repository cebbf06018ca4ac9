// Several motions of the model's body side by side, each with its name, under the clock of the stage. Loaded
// on demand.
import { html, nothing } from "lit";
import { Columns } from "../scene/columns";
import { eachFrame } from "../ui/browser";
import { View } from "../ui/view";
import "./columns-view.css";
import type { Playback } from "./playback";
import { sameBody } from "../scene/followed-figure";
import type { StageContent, StageColumn, StageStore } from "./stage-store";
import { styled } from "../ui/styled";
import { lab } from "../words/lab";
import "./stage-canvas.css";

export class ColumnsView extends View {
  declare stage: StageStore;
  declare playback: Playback;
  #columns: Columns | null = null;
  /** The columns that are drawn, and the body of their figures. */
  #drawnColumns: readonly StageColumn[] | null = null;
  #body: StageContent | null = null;

  protected override stores() {
    return [this.stage];
  }

  protected override arrived(): void {
    const canvas = this.querySelector("canvas");
    if (!canvas) return;
    try {
      this.#columns = new Columns(canvas);
    } catch {
      // The stage shows the message that nothing can be drawn.
      return;
    }
    this.#keepDrawing(this.#columns);
    this.whenLeaving(() => {
      this.#columns?.dispose();
      [this.#columns, this.#drawnColumns, this.#body] = [null, null, null];
    });
    this.#show();
  }

  #keepDrawing(columns: Columns): void {
    let drawnAt = -1;
    const draw = (seconds: number) => {
      const { frame, playing } = this.playback;
      columns.draw(frame, frame !== drawnAt, seconds, playing);
      drawnAt = frame;
    };
    // The stage moves its clock on itself.
    this.whenLeaving(eachFrame(draw, Infinity));
  }

  protected override updated(): void {
    this.#show();
  }

  /** Draws new columns. */
  #show(): void {
    const { columns, content } = this.stage;
    if (!this.#columns || !columns || !content || columns === this.#drawnColumns) return;
    // The motions belong to another body than the one on the stage.
    if (columns.some(({ motion }) => motion.nodes !== content.motion.nodes)) return;
    this.#drawnColumns = columns;
    if (!this.#body || !sameBody(this.#body, content)) this.#body = content;
    this.#columns.show(
      this.#body,
      columns.map(({ motion }) => ({ motion, ghost: null })),
    );
  }

  protected override render() {
    const { columns } = this.stage;
    if (!columns) return nothing;
    const titles = columns.map(({ title }) => title);
    return html`
      <canvas class="stage-canvas cover" tabindex="0" role="img" data-testid="stage-columns"
        aria-label=${lab().stage.figures(titles)}></canvas>
      <ol class="stage-columns passive" style=${styled({ "--columns": columns.length })}>${titles.map((title) => html`<li>${title}</li>`)}</ol>`;
  }
}
customElements.define("pg-columns", ColumnsView);
