// The base of all figures: the title, the width, and two buttons that save the figure as CSV and PNG.
import { html, nothing, type TemplateResult } from "lit";
import { download } from "../ui/download";
import "./figures.css";
import { csv, type Table } from "./csv";
import { pictureOf } from "./picture";
import { messageOf } from "../ui/format";
import { View } from "../ui/view";
import { lab } from "../words/lab";

/** The detail of the bubbling event `save-failed`. */
export interface SaveFailure {
  /** The file's name. */
  name: string;
  message: string;
}

/** The page's type is 14 px, and larger for a projector. */
const TYPE = 14;
/** The width of a printed figure on A4, pixels. */
const PAPER = 680;

export abstract class FigureElement<Data> extends View {
  static override properties = { data: { attribute: false }, width: { state: true }, type: { state: true } };
  /** The data that the figure shows. */
  data: Data | null = null;
  /** The figure's width, pixels. */
  width = 0;
  /** The size of a drawing's type, pixels. */
  type = 12;

  protected abstract readonly words: () => { readonly heading: string };
  /** The name of its files, without an ending. */
  protected abstract readonly file: string;
  protected abstract figure(data: Data): TemplateResult;
  protected abstract table(data: Data): Table;
  /** A sentence about the data that are missing; null where the figure can be drawn. */
  protected abstract missing(data: Data): string | null;

  override connectedCallback(): void {
    super.connectedCallback();
    const measure = () => this.#measure();
    measure();
    this.watchSize(this, measure);
    this.listen(window, "beforeprint", () => {
      this.width = PAPER;
    });
    this.listen(window, "afterprint", measure);
  }

  #measure(): void {
    // A hidden view has no width: the figure keeps its last width.
    if (this.clientWidth > 0) this.width = this.clientWidth;
    const root = Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
    this.type = (12 * (Number.isFinite(root) ? root : TYPE)) / TYPE;
  }

  protected get heading(): string {
    return this.words().heading;
  }

  async #save(ending: "csv" | "png"): Promise<void> {
    const { data } = this;
    const figure = this.querySelector("figure");
    if (!data || !figure) return;
    const name = `${this.file}.${ending}`;
    try {
      const content =
        ending === "png"
          ? await pictureOf(figure)
          : new Blob([csv(this.table(data))], { type: "text/csv;charset=utf-8" });
      download(name, content);
    } catch (problem) {
      const detail: SaveFailure = { name, message: messageOf(problem) };
      this.dispatchEvent(
        new CustomEvent<SaveFailure>("save-failed", { detail, bubbles: true, composed: true }),
      );
    }
  }

  protected override render() {
    const { data } = this;
    if (!data) return nothing;
    const missing = this.missing(data);
    return html`
      <figure class="figure-card">
        <div class="figure-head row spread">
          <h3>${this.heading}</h3>
          ${
            missing !== null
              ? nothing
              : html`
            <div class="figure-files" data-not-in-picture>
              <button class="small" title=${lab().files.figures.csv} aria-label="CSV: ${this.heading}" @click=${() => this.#save("csv")}>CSV</button>
              <button class="small" title=${lab().files.figures.png} aria-label="PNG: ${this.heading}" @click=${() => this.#save("png")}>PNG</button>
            </div>`
          }
        </div>
        ${missing !== null ? html`<p class="empty">${missing}</p>` : this.width > 0 ? this.figure(data) : nothing}
      </figure>`;
  }
}
