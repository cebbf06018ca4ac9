// The open tables, and the parts of their columns.
import { html, nothing } from "lit";
import "../clips/parts-editor.css";
import { MAX_PARTS } from "../engine/limits";
import { icon } from "../ui/icons";
import { fileNotices } from "../clips/clips-store";
import { memberRow, partColours, partNames } from "../clips/part-names";
import { View } from "../ui/view";
import { placeOf } from "./parts-of-columns";
import type { TableEntry, TablesStore } from "./tables-store";
import { lab } from "../words/lab";
import { seriesWords } from "./view-words";

/** Columns of mediapipe that are no places. */
const LEFT_OUT = "*.visibility, *.presence";

export class TablesView extends View {
  static override properties = { busy: { type: Boolean } };
  declare tables: TablesStore;
  /** Whether a training is using the tables, so that they cannot be changed now. */
  declare busy: boolean;

  #table(table: TableEntry) {
    const { tables, busy } = this;
    const { name, rows, columns, frameTime, warnings } = table.info;
    const { clips } = lab().learn;
    const seconds = frameTime === null ? null : clips.seconds((rows - 1) * frameTime);
    return html`
      <li class="clip row wrap">
        <label class="tick-label row"><input type="checkbox" aria-label=${clips.tick(name)} .checked=${table.ticked} ?disabled=${busy}
          @change=${(event: Event) => void tables.tick(table, (event.target as HTMLInputElement).checked)} />
          <span class="clip-title ellipsis" title=${name}>${name}</span></label>
        <span class="clip-length hint tabular">${seriesWords().size(rows, columns.length, seconds)}</span>
        <button class="round" aria-label=${clips.removeOf(name)} title=${clips.remove} ?disabled=${busy} @click=${() => void tables.remove(table)}>${icon("close")}</button>
        ${fileNotices(warnings)}
      </li>`;
  }

  #column(column: string, colours: readonly string[]) {
    const { tables, busy } = this;
    return memberRow({ parts: tables.parts, disabled: busy }, colours, {
      name: column,
      part: placeOf(tables.parts, column),
      title: column,
      move: (to) => tables.moveColumn(column, to),
    });
  }

  #leaveOut() {
    const { tables, busy } = this;
    const { label, hint } = seriesWords().leaveOut;
    return html`
      <div class="field stack"><label for="series-without" title=${hint}>${label}</label>
        <input type="text" id="series-without" data-testid="series-without" spellcheck="false" autocomplete="off"
          placeholder=${LEFT_OUT} .value=${tables.leftOut.join(", ")} ?disabled=${busy}
          @change=${(event: Event) => void tables.leaveOut((event.target as HTMLInputElement).value)} /></div>
      ${tables.leftOutProblem ? html`<p class="bad" role="alert">${tables.leftOutProblem}</p>` : nothing}`;
  }

  protected override render() {
    const { tables, busy } = this;
    const parts = tables.parts.map(({ name, columns }) => ({ name, size: columns.length }));
    const colours = partColours(parts.map(({ size }) => size));
    return html`
      ${tables.clash ? html`<p class="bad" role="alert">${tables.clash}</p>` : nothing}
      <ul class="clip-list" data-testid="tables">${tables.all.map((table) => this.#table(table))}</ul>
      ${
        tables.columns.length === 0
          ? nothing
          : html`
          ${this.#leaveOut()}
          <h3>${seriesWords().parts}</h3>
          <div class="series-parts stack">
            ${partNames({
              parts,
              of: "columns",
              most: MAX_PARTS,
              disabled: busy,
              refused: tables.refused,
              rename: (part, text) => tables.renamePart(part, text),
              remove: (part) => tables.removePart(part),
              add: () => tables.addPart(),
            })}
            <ul class="joint-tree note" tabindex="0" aria-label=${seriesWords().columns}>${tables.columns.map((column) => this.#column(column, colours))}</ul>
          </div>`
      }`;
  }
}
customElements.define("pg-tables", TablesView);
