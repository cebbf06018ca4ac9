// The base of the figures: title, the two files that can be saved of it, and how wide it is.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { download } from "../ui/download";
import "./figures.css";
import { csv, type Table } from "./csv";
import { pictureOf } from "./picture";
import { messageOf } from "../ui/format";

/** What the bubbling event `save-failed` tells: a file could not be made. */
export interface SaveFailure {
  /** The file's name. */
  name: string;
  message: string;
}

/** The page's type is 14 px, and larger for a projector. */
const TYPE = 14;
/** What a sheet of A4 has room for, pixels. */
const PAPER = 680;

export abstract class FigureElement<Data> extends LitElement {
  static override properties = { data: { attribute: false }, width: { state: true }, type: { state: true } };
  /** What it shows. */
  declare data: Data | null;
  /** The figure's width, pixels. */
  declare width: number;
  /** The size of a drawing's type, pixels. */
  declare type: number;
  private observer: ResizeObserver | null = null;

  constructor() {
    super();
    this.data = null;
    this.width = 0;
    this.type = 12;
  }

  protected abstract readonly heading: string;
  /** The name of its files, without an ending. */
  protected abstract readonly file: string;
  protected abstract figure(data: Data): TemplateResult;
  protected abstract table(data: Data): Table;
  /** What is missing, in words, where there is nothing to draw; null where there is. */
  protected abstract missing(data: Data): string | null;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.observer = new ResizeObserver(() => this.measure());
    this.observer.observe(this);
    this.measure();
    window.addEventListener("beforeprint", this.onPrint);
    window.addEventListener("afterprint", this.measure);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.observer?.disconnect();
    window.removeEventListener("beforeprint", this.onPrint);
    window.removeEventListener("afterprint", this.measure);
  }

  private readonly measure = (): void => {
    // In a view that is hidden it stays as wide as it was.
    if (this.clientWidth > 0) this.width = this.clientWidth;
    const root = Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
    this.type = (12 * (Number.isFinite(root) ? root : TYPE)) / TYPE;
  };

  private readonly onPrint = (): void => {
    this.width = PAPER;
  };

  private async save(ending: "csv" | "png"): Promise<void> {
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
        <div class="figure-head">
          <h3>${this.heading}</h3>
          ${
            missing !== null
              ? nothing
              : html`
            <div class="figure-files" data-not-in-picture>
              <button class="small" title="Save the numbers of this figure" aria-label="CSV: ${this.heading}" @click=${() => this.save("csv")}>CSV</button>
              <button class="small" title="Save a picture of this figure" aria-label="PNG: ${this.heading}" @click=${() => this.save("png")}>PNG</button>
            </div>`
          }
        </div>
        ${missing !== null ? html`<p class="empty">${missing}</p>` : this.width > 0 ? this.figure(data) : nothing}
      </figure>`;
  }
}
