// The couplings as a table of sliders: which part predicts which, and how much its prediction counts.
import { html, nothing } from "lit";
import type { EngineStore } from "../engine/engine-store";
import type { ModelInfo } from "../engine/protocol";
import type { SettingsStore } from "../settings/settings-store";
import { clipTitle, short, weight } from "../ui/format";
import { icon } from "../ui/icons";
import { partColour } from "../ui/palette";
import "../terms/term";
import { swatchStyle, View } from "../ui/view";
import "./body-map";
import "./couplings.css";
import type { ModelStore } from "./model-store";
import { alphaOf, placeOf, STRONGEST, strengthOf, WEAKEST } from "./strength";

export class CouplingsView extends View {
  declare model: ModelStore;
  declare settings: SettingsStore;
  declare engine: EngineStore;

  protected override stores() {
    return [this.model, this.settings, this.engine];
  }

  private keys(source: number, target: number) {
    return (event: KeyboardEvent) => {
      if (event.key !== "Backspace" && event.key !== "Delete") return;
      event.preventDefault();
      this.model.resetCoupling(source, target);
    };
  }

  private cell({ parts }: ModelInfo, source: number, target: number) {
    const { model } = this;
    const learned = model.learnedAlpha(source, target);
    const alpha = model.alpha(source, target);
    const w = model.weight(source, target);
    const changed = model.isChanged(source, target);
    const name = (part: number) => parts[part]?.name ?? "";
    const label = `${name(source)} to ${name(target)}`;
    return html`
      <td style=${swatchStyle(partColour(source))} class=${changed ? "changed" : ""}>
        <div class="slider">
          <span class="fill" style="--at:${placeOf(alpha).toFixed(4)}"></span>
          <span class="tick" style="--at:${placeOf(learned).toFixed(4)}" title="As learned: ${short(learned)}"></span>
          <input type="range" min=${WEAKEST} max=${STRONGEST} step="0.01" .value=${strengthOf(alpha).toFixed(2)}
            aria-label=${label} aria-valuetext="alpha ${short(alpha)}, weight ${weight(w)}; learned ${short(learned)}"
            data-source=${source} data-target=${target} data-testid="coupling-${source}-${target}"
            title="${label}: drag to change, double click to reset"
            @input=${(event: Event) => model.setCoupling(source, target, alphaOf((event.target as HTMLInputElement).valueAsNumber))}
            @keydown=${this.keys(source, target)}
            @dblclick=${() => model.resetCoupling(source, target)} />
        </div>
        <div class="numbers">
          <span title="alpha, the variance of this prediction: small means influential"><i>α</i> <output data-testid="alpha-${source}-${target}">${short(alpha)}</output></span>
          <span title="weight of this prediction; the weights into a part sum to 1"><i>w</i> <output data-testid="weight-${source}-${target}">${weight(w)}</output></span>
        </div>
      </td>`;
  }

  private table(info: ModelInfo) {
    const { parts } = info;
    const head = (name: string, part: number) =>
      html`<span class="part-name" style=${swatchStyle(partColour(part))}><i class="swatch"></i>${name}</span>`;
    return html`
      <table class="couplings" data-parts=${parts.length}>
        <thead>
          <tr>
            <td></td>
            ${parts.map(({ name }, target) => html`<th scope="col"><small>predicts</small> ${head(name, target)}</th>`)}
          </tr>
        </thead>
        <tbody>
          ${parts.map(
            ({ name }, source) => html`
            <tr>
              <th scope="row">${head(name, source)}</th>
              ${parts.map((_, target) => this.cell(info, source, target))}
            </tr>`,
          )}
        </tbody>
      </table>`;
  }

  private readings() {
    const { model } = this;
    const inferred = this.settings.values.reading === "re-inferred";
    return html`
      <fieldset class="readings">
        <legend>When a slider moves, <pg-term of="expert" text="experts"></pg-term> <pg-term of="reading" text="stay or are re-inferred"></pg-term></legend>
        <div class="segments">
          <button type="button" aria-pressed=${inferred ? "false" : "true"} data-testid="reading-learned"
            @click=${() => model.setReading("as learned")}>experts as learned</button>
          <button type="button" aria-pressed=${inferred ? "true" : "false"} data-testid="reading-inferred"
            @click=${() => model.setReading("re-inferred")}>experts re-inferred</button>
        </div>
        <p>${
          inferred
            ? "What the same data would have taught each part’s predictions under these couplings."
            : "Only the weights change: each part predicts as before, and counts for more or less."
        }</p>
        <button type="button" class="small" data-testid="reset-couplings" ?disabled=${!model.altered} @click=${() => model.resetCouplings()}>
          ${icon("reset")} Reset all <kbd>0</kbd></button>
      </fieldset>`;
  }

  private starts({ sequences }: ModelInfo) {
    if (sequences.length < 2) return nothing;
    return html`
      <label class="start">Start as
        <select aria-label="Start as in" @change=${(event: Event) =>
          this.model.setStart(Number((event.target as HTMLSelectElement).value))}>
          ${sequences.map(({ name }, i) => html`<option value=${i} ?selected=${i === this.settings.values.start}>${clipTitle(name)}</option>`)}
        </select>
      </label>`;
  }

  protected override render() {
    const info = this.model.model?.info;
    return html`
      <header class="panel-head">
        <h2><pg-term of="coupling" text="Couplings"></pg-term></h2>
        <p class="hint">Which <pg-term of="part" text="part"></pg-term> predicts which. Right is strong: small
          <pg-term of="alpha" text="α"></pg-term>, large <pg-term of="weight" text="w"></pg-term>.</p>
        ${info ? this.starts(info) : nothing}
      </header>
      ${
        info
          ? html`
          <div class="couplings-body">
            ${info.parts.length > 1 ? html`<pg-body-map .model=${this.model} .settings=${this.settings}></pg-body-map>` : nothing}
            <div class="table-box">${this.table(info)}</div>
            ${this.readings()}
          </div>`
          : html`<p class="empty">${
              this.engine.state === "failed"
                ? "The model could not be started, so its couplings cannot be changed."
                : "How the parts drive each other appears here."
            }</p>`
      }
    `;
  }
}
customElements.define("pg-couplings", CouplingsView);
