// A loop for each part, and between the loops the couplings with the sliders of alpha.
import { html, nothing } from "lit";
import type { Coupled } from "../couplings/coupled";
import "../couplings/coupling-view";
import type { Way } from "../couplings/coupling-view";
import type { ModelInfo } from "../engine/protocol";
import "../latents/latent-plot";
import type { Space } from "../latents/latent-plot";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { View } from "../ui/view";
import { lab, shownPart } from "../words/lab";

export class LoopsView extends View {
  static override properties = { chosen: { state: true }, one: { state: true } };
  declare model: Coupled;
  declare space: Space;
  /** With three parts or more: the part whose sliders are visible; null: the uppermost. */
  chosen: number | null = null;
  /** On a phone: the coupling whose slider is visible, as "source.target". */
  one = "0.1";

  #coupling(source: number, target: number, way: Way) {
    const key = `${source}.${target}`;
    return html`<pg-coupling .model=${this.model} .source=${source} .target=${target} .way=${way} data-one=${key === this.one ? "yes" : "no"}></pg-coupling>`;
  }

  /** A part: its name, the coupling with itself, and its latent space. */
  #loop(info: ModelInfo, part: number) {
    const name = shownPart(info.parts[part]?.name ?? "");
    const choice = info.parts.length > 2;
    const label = html`<i class="swatch"></i>${name}`;
    const isChosen = this.#chosenOf(info) === part;
    return html`
      <section class="loop" style=${partStyle(partColour(part))} aria-label=${name}>
        ${
          choice
            ? html`<button class="loop-name row tight" aria-pressed=${isChosen ? "true" : "false"} title=${lab().couplings.slidersOf(name)}
              data-testid="part-${part}" @click=${() => {
                this.chosen = part;
              }}>${label}</button>`
            : html`<span class="loop-name row tight">${label}</span>`
        }
        <pg-latent-plot .bodyPart=${part} .model=${this.model} .space=${this.space}></pg-latent-plot>
        ${info.alpha.length > 0 && (!choice || isChosen) ? this.#coupling(part, part, "itself") : nothing}
      </section>`;
  }

  #chosenOf({ parts }: ModelInfo): number {
    return Math.min(this.chosen ?? parts.length, parts.length - 1);
  }

  /** On a phone one slider is visible at a time. */
  #oneAtATime({ parts, alpha }: ModelInfo) {
    const { toOther, oneSlider } = lab().couplings;
    const name = (part: number) => shownPart(parts[part]?.name ?? "");
    const pairs = alpha.flatMap((row, source) => row.map((_, target) => [source, target] as const));
    const choose = (event: Event) => {
      this.one = (event.target as HTMLSelectElement).value;
      this.chosen = Number(this.one.split(".")[1]);
    };
    return html`
      <select class="one-slider" aria-label=${oneSlider} data-testid="one-slider" @change=${choose}>
        ${pairs.map(([source, target]) => html`<option value="${source}.${target}" .selected=${`${source}.${target}` === this.one}>${toOther(name(source), name(target))}</option>`)}
      </select>`;
  }

  /** The first part, often the legs, is the lowest. */
  protected override render() {
    const info = this.model.model?.info;
    if (!info) return nothing;
    const count = info.parts.length;
    const parts = info.parts.map((_, part) => part).reverse();
    const chosen = this.#chosenOf(info);
    const between = (part: number) => {
      if (count < 2) return nothing;
      if (count === 2)
        return part === 1
          ? html`<div class="between">${this.#coupling(0, 1, "up")}${this.#coupling(1, 0, "down")}</div>`
          : nothing;
      const others = parts.filter((other) => other !== part);
      return part === chosen
        ? html`<div class="between">${others.map((source) => this.#coupling(source, part, "up"))}</div>`
        : nothing;
    };
    return html`
      ${count > 1 ? this.#oneAtATime(info) : nothing}
      <div class="loops column ${count > 2 ? "many scroll" : ""}">
        ${parts.map((part) => html`${this.#loop(info, part)}${between(part)}`)}
      </div>`;
  }
}
customElements.define("pg-loops", LoopsView);
