// All latent plots, and what they show.
import { html } from "lit";
import { changeSettings } from "../settings/change";
import type { Marks } from "./latent-plot";
import "./latent-plot";
import { View } from "../ui/view";

export class LatentsView extends View {
  static override topics = ["model", "settings", "engine"] as const;
  static override properties = { marks: { state: true } };
  declare marks: Marks;

  constructor() {
    super();
    this.marks = { pose: true, dynamics: true, between: false };
  }

  private toggle(kind: keyof Marks) {
    return () => (this.marks = { ...this.marks, [kind]: !this.marks[kind] });
  }

  protected override render() {
    const { model, settings, engineState } = this.app;
    const parts = model?.info.parts ?? [];
    const pressed = (kind: keyof Marks) => (this.marks[kind] ? "true" : "false");
    return html`
      <header class="panel-head">
        <h2>Latent spaces</h2>
        <div class="segments" role="group" aria-label="Plot">
          ${(["2d", "3d"] as const).map(
            (plot) => html`
            <button aria-pressed=${settings.plot === plot ? "true" : "false"}
              @click=${() => changeSettings(this.app, { plot })}>${plot === "2d" ? "2-D" : "3-D"}</button>`,
          )}
        </div>
      </header>
      ${
        parts.length === 0
          ? html`<p class="empty">${
              engineState === "failed"
                ? "The model could not be started, so there are no latents to show."
                : "Each part's path through its latent space appears here."
            }</p>`
          : html`
          <div class="plots" data-count=${Math.min(parts.length, 5)}>
            ${parts.map((_, part) => html`<pg-latent-plot .app=${this.app} .bodyPart=${part} .marks=${this.marks}></pg-latent-plot>`)}
          </div>
          <div class="marks" role="group" aria-label="Show inducing points">
            <button class="chip" aria-pressed=${pressed("pose")} @click=${this.toggle("pose")} title="Pose inducing points: poses that the pose map is pinned to">
              <svg viewBox="0 0 12 12" aria-hidden="true"><path d="M6 1.8L10.2 6 6 10.2 1.8 6z" /></svg>poses</button>
            <button class="chip" aria-pressed=${pressed("dynamics")} @click=${this.toggle("dynamics")} title="Dynamics inducing points: a history in, its prediction out">
              <svg viewBox="0 0 12 12" aria-hidden="true"><path d="M1.5 10.5L9.5 2.5M5 2.2h4.8V7" /></svg>dynamics</button>
            ${
              parts.length > 1
                ? html`
              <button class="chip" aria-pressed=${pressed("between")} @click=${this.toggle("between")} title="Dynamics inducing points of the couplings between parts: dots are histories that predict another part, triangles are predictions by another part">
                <svg viewBox="0 0 12 12" aria-hidden="true"><path d="M2 9.8L6 3l4 6.8z" /></svg>couplings</button>`
                : ""
            }
          </div>`
      }
    `;
  }
}
customElements.define("pg-latents", LatentsView);
