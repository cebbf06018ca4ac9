// The picture of a model without a body: the reading, the loops and the couplings between them, and a foot.
import { html, nothing, type TemplateResult } from "lit";
import type { Coupled } from "../couplings/coupled";
import { readingChoice } from "../couplings/reading-choice";
import type { Space } from "../latents/latent-plot";
import { icon } from "../ui/icons";
import { lab } from "../words/lab";
import "./loops-view";
import "./picture.css";

export interface CoupledPicture {
  model: Coupled;
  space: Space;
  /** What to try while the couplings are as learned. */
  lead: string;
  /** The reason why the rollout under the newest couplings failed; empty if it did not fail. */
  problem: string;
  foot: TemplateResult | typeof nothing;
}

export function coupledPicture({ model, space, lead, problem, foot }: CoupledPicture) {
  const { couplings } = model;
  const isCoupled = (model.model?.info.parts.length ?? 0) > 1;
  const words = () => {
    if (problem) return html`<span class="bad" role="alert">${problem}</span>`;
    return couplings.altered ? lab().stage.lead.own : lead;
  };
  return html`
    <div class="picture-area picture">
      ${
        isCoupled
          ? html`
        <div class="picture-head" role="group" aria-label=${lab().couplings.map}>
          ${readingChoice(couplings)}
          ${couplings.altered ? html`<button data-testid="series-reset" @click=${() => couplings.resetAll()}>${icon("reset")} ${lab().readings.resetAll}</button>` : nothing}
        </div>`
          : nothing
      }
      <p class="picture-lead" role="status">${words()}</p>
      <pg-loops .model=${model} .space=${space}></pg-loops>
      ${foot}
    </div>`;
}
