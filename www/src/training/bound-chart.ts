// The chart of the trainings' bounds, and below it the terms of the chosen bound.
import { html, nothing } from "lit";
import { grouped } from "../ui/format";
import "../terms/term";
import { onThemeChange } from "../ui/palette";
import { View } from "../ui/view";
import { termLines } from "./bound-lines";
import type { TrainingStore } from "./training-store";
import { lab, shownPart } from "../words/lab";
import { partStyle } from "../ui/styled";

export class BoundChart extends View {
  declare training: TrainingStore;
  /** Loaded with the table of trainings when the first training starts. */
  #drawing: typeof import("./bound-drawing") | null = null;
  #loading = false;

  protected override arrived(): void {
    this.whenLeaving(onThemeChange(() => this.requestUpdate()));
    this.watchSize(this, () => this.requestUpdate());
  }

  override updated(): void {
    if (this.training.busy && !this.#drawing && !this.#loading) void this.#load();
  }

  async #load(): Promise<void> {
    this.#loading = true;
    try {
      [this.#drawing] = await Promise.all([import("./bound-drawing"), import("./runs-table")]);
      this.requestUpdate();
    } catch {
      // The numbers below remain without a chart; the next step tries again.
    }
    this.#loading = false;
  }

  protected override render() {
    const { charted, learning, runs } = this.training;
    const last = charted?.steps.at(-1);
    const parts = charted?.settings.parts.map(({ name }) => shownPart(name)) ?? [];
    const words = lab().learn.bound;
    // With weighted poses it is no bound on the evidence.
    const weight = charted ? (charted.settings.poseWeight ?? 1) : this.training.poseWeight;
    const name = weight === 1 ? words.name : words.weighted;
    // The line is too short for both.
    const phase = learning && last ? `, ${lab().learn.phases[last.phase]}` : "";
    const which = runs.length > 1 ? `, ${words.seed(charted?.settings.seed ?? 0)}` : phase;
    // The size stays while the next training sets up.
    const isEmpty = runs.every(({ steps }) => steps.length === 0);
    const drawing = charted && last && this.clientWidth > 0 ? this.#drawing : null;
    return html`
      <figure class="chart" data-testid="bound-chart">
        <figcaption class="hint spread"><span><pg-term of="bound" text=${name}></pg-term><small>, ${words.in} <pg-term of="nats" text=${words.nats}></pg-term>${which}</small></span> <output data-testid="bound">${last ? grouped(last.best) : ""}</output></figcaption>
        <div class="bound-box">
          <div class="bound" role="img" aria-label=${words.overIterations}>${drawing && charted ? drawing.boundPicture(charted, runs, this.clientWidth) : nothing}</div>
          ${isEmpty ? html`<p class="empty cover">${words.empty}</p>` : nothing}
        </div>
        <pg-runs .training=${this.training}></pg-runs>
        <figcaption class="hint spread" ?hidden=${isEmpty}><pg-term of="bound-terms" text=${words.terms}></pg-term></figcaption>
        <div class="terms" ?hidden=${isEmpty} role="img" aria-label=${words.termsOverIterations}>${drawing && charted ? drawing.termsPicture(charted, this.clientWidth) : nothing}</div>
        <ul ?hidden=${isEmpty} class="term-list stack note">
          ${termLines(parts).map(
            ({ label, colour, dash, value }) => html`
            <li class="row" style=${partStyle(colour)}><i class="stroke ${dash ? "dashed" : ""}"></i><span>${label}</span>
              <output>${last ? grouped(value(last)) : ""}</output></li>`,
          )}
        </ul>
      </figure>`;
  }
}
customElements.define("pg-bound-chart", BoundChart);
