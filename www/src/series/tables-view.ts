// The tables, and which of their columns are which part's.
import { html, nothing } from "lit";
import "../clips/parts-editor.css";
import { MAX_PARTS } from "../engine/limits";
import { icon } from "../ui/icons";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import { placeOf } from "./parts-of-columns";
import type { TableEntry, TablesStore } from "./tables-store";

export class TablesView extends View {
  static override properties = { busy: { type: Boolean } };
  declare tables: TablesStore;
  /** Whether a training uses them, so that they cannot be changed now. */
  declare busy: boolean;

  protected override stores() {
    return [this.tables];
  }

  #table(table: TableEntry) {
    const { tables, busy } = this;
    const { name, rows, columns, frameTime } = table.info;
    const long = frameTime === null ? "" : `, ${((rows - 1) * frameTime).toFixed(1)} s`;
    return html`
      <li class="clip">
        <label class="tick-label"><input type="checkbox" aria-label="Train on ${name}" .checked=${table.ticked} ?disabled=${busy}
          @change=${(event: Event) => void tables.tick(table, (event.target as HTMLInputElement).checked)} />
          <span class="clip-title" title=${name}>${name}</span></label>
        <span class="clip-length">${rows} rows of ${columns.length}${long}</span>
        <button class="round" aria-label="Remove ${name}" title="Remove" ?disabled=${busy} @click=${() => void tables.remove(table)}>${icon("close")}</button>
      </li>`;
  }

  #part(name: string, part: number) {
    const { tables, busy } = this;
    return html`
      <div style=${partStyle(partColour(part))}>
        <i class="swatch"></i>
        <input type="text" maxlength="24" aria-label="Name of part ${part + 1}" .value=${name} ?disabled=${busy}
          @change=${(event: Event) => tables.renamePart(part, (event.target as HTMLInputElement).value)} />
        <button class="round" aria-label="Remove part ${name}" title="Its columns go to another" ?disabled=${busy || tables.parts.length < 2}
          @click=${() => tables.removePart(part)}>${icon("close")}</button>
      </div>`;
  }

  #column(column: string) {
    const { tables, busy } = this;
    const of = placeOf(tables.parts, column);
    return html`
      <li style=${partStyle(partColour(Math.max(0, of)))}>
        <i class="swatch"></i><span title=${column}>${column}</span>
        <select aria-label="Part of ${column}" ?disabled=${busy}
          @change=${(event: Event) => tables.moveColumn(column, Number((event.target as HTMLSelectElement).value))}>
          ${tables.parts.map(({ name }, part) => html`<option value=${part} .selected=${part === of}>${name}</option>`)}
        </select>
      </li>`;
  }

  protected override render() {
    const { tables, busy } = this;
    return html`
      ${tables.clash ? html`<p class="bad" role="alert">${tables.clash}</p>` : nothing}
      <ul class="clip-list" data-testid="tables">${tables.all.map((table) => this.#table(table))}</ul>
      ${
        tables.columns.length === 0
          ? nothing
          : html`
          <h3>Parts</h3>
          <div class="series-parts">
            <div class="part-names">
              ${tables.parts.map(({ name }, part) => this.#part(name, part))}
              <button class="small" data-testid="add-part" ?disabled=${busy || tables.parts.length >= MAX_PARTS} @click=${() => tables.addPart()}>Add a part</button>
            </div>
            <ul class="joint-tree" tabindex="0" aria-label="Columns and their parts">${tables.columns.map((column) => this.#column(column))}</ul>
          </div>`
      }`;
  }
}
customElements.define("pg-tables", TablesView);
