// The couplings as a table of sliders: which part predicts which, and how much its prediction counts.
import { html, nothing } from "lit";
import type { EngineStore } from "../engine/engine-store";
import type { ModelInfo } from "../engine/protocol";
import type { SettingsStore } from "../settings/settings-store";
import type { Playback } from "../stage/playback";
import { clipTitle, short } from "../ui/format";
import { partColour } from "../ui/palette";
import "../terms/term";
import { View } from "../ui/view";
import "./body-map";
import type { BodyStore } from "./body-store";
import "./couplings.css";
import type { ModelStore } from "./model-store";
import "./presets-view";
import type { ReadingsStore } from "./readings-store";
import "./readings-view";
import "./share-bar";
import { isOff, shareWord } from "./shares";
import { alphaOf, placeOf, STRONGEST, strengthOf, WEAKEST } from "./strength";
import { partStyle, styled } from "../ui/styled";

export class CouplingsView extends View {
  declare model: ModelStore;
  declare settings: SettingsStore;
  declare engine: EngineStore;
  declare body: BodyStore;
  declare readings: ReadingsStore;
  declare playback: Playback;

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
    const classes = `${changed ? "changed" : ""} ${isOff(w) ? "off" : ""}`;
    return html`
      <td style=${partStyle(partColour(source))} class=${classes}>
        <div class="slider">
          <span class="fill" style=${styled({ "--at": placeOf(alpha).toFixed(4) })}></span>
          <span class="tick" style=${styled({ "--at": placeOf(learned).toFixed(4) })} title="As learned: ${short(learned)}"></span>
          <input type="range" min=${WEAKEST} max=${STRONGEST} step="0.01" .value=${strengthOf(alpha).toFixed(2)}
            aria-label=${label} aria-valuetext="alpha ${short(alpha)}, weight ${shareWord(w)}; learned ${short(learned)}"
            data-source=${source} data-target=${target} data-testid="coupling-${source}-${target}"
            title="${label}: drag to change, double click to reset"
            @input=${(event: Event) => model.setCoupling(source, target, alphaOf((event.target as HTMLInputElement).valueAsNumber))}
            @keydown=${this.keys(source, target)}
            @dblclick=${() => model.resetCoupling(source, target)} />
        </div>
        <div class="numbers">
          <span title="alpha, the variance of this prediction: small means influential"><i>α</i> <output data-testid="alpha-${source}-${target}">${short(alpha)}</output></span>
          <span title="weight of this prediction; the weights into a part sum to 1"><i>w</i> <output data-testid="weight-${source}-${target}">${shareWord(w)}</output></span>
        </div>
      </td>`;
  }

  private table(info: ModelInfo) {
    const { parts } = info;
    const head = (name: string, part: number) =>
      html`<span class="part-name" style=${partStyle(partColour(part))}><i class="swatch"></i>${name}</span>`;
    return html`
      <table class="couplings" data-parts=${parts.length}>
        <thead>
          <tr>
            <td><small>who decides</small></td>
            ${parts.map(({ name }, target) => html`<th scope="col"><small>about</small> ${head(name, target)}</th>`)}
          </tr>
          ${
            parts.length > 1
              ? html`<tr>
            <td></td>
            ${parts.map((_, target) => html`<td><pg-share-bar .model=${this.model} .target=${target}></pg-share-bar></td>`)}
          </tr>`
              : nothing
          }
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

  private starts({ sequences }: ModelInfo) {
    const { start, startFrame } = this.settings.values;
    const last = this.model.startFrames(start) - 1;
    const frame = Math.min(startFrame, last);
    // The motion stops where it begins, so that its first pose is seen.
    const from = (event: Event) => {
      this.playback.scrub(0);
      this.model.setStart(start, (event.target as HTMLInputElement).valueAsNumber);
    };
    const frames =
      last > 0
        ? html`<label class="start">from frame <input type="range" min="0" max=${last} .value=${String(frame)} data-testid="start-frame"
            aria-valuetext="Frame ${frame + 1} of ${last + 1}" @input=${from} /><output>${frame + 1}</output></label>`
        : nothing;
    if (sequences.length < 2) return frames;
    return html`
      <label class="start">Start as
        <select aria-label="Start as in" @change=${(event: Event) =>
          this.model.setStart(Number((event.target as HTMLSelectElement).value))}>
          ${sequences.map(({ name }, i) => html`<option value=${i} ?selected=${i === start}>${clipTitle(name)}</option>`)}
        </select>
      </label>${frames}`;
  }

  protected override render() {
    const info = this.model.model?.info;
    return html`
      <header class="panel-head">
        <h2><pg-term of="coupling" text="Couplings"></pg-term></h2>
        <p class="hint">Which <pg-term of="part" text="part"></pg-term> decides about which. Right is strong: small
          <pg-term of="alpha" text="α"></pg-term>, large <pg-term of="weight" text="w"></pg-term>.</p>
        ${info ? this.starts(info) : nothing}
      </header>
      ${
        info
          ? html`
          <pg-presets .model=${this.model} .settings=${this.settings} .body=${this.body}></pg-presets>
          <div class="couplings-body">
            ${info.parts.length > 1 ? html`<pg-body-map .model=${this.model} .settings=${this.settings}></pg-body-map>` : nothing}
            <div class="table-box">${this.table(info)}</div>
            <pg-readings .model=${this.model} .settings=${this.settings} .readings=${this.readings}></pg-readings>
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
