// The picture of a model without a body: the reading, the loops and the couplings between them, and a foot.
import { html, nothing, type TemplateResult } from "lit";
import { readingChoice } from "../couplings/reading-choice";
import type { Space } from "../latents/latent-plot";
import { icon } from "../ui/icons";
import { lab } from "../words/lab";
import { FUTURES, type SeriesStore } from "./series-store";
import "../picture/loops-view";
import "../picture/picture.css";

export interface CoupledPicture {
  model: SeriesStore;
  space: Space;
  /** What to try while the couplings are as learned. */
  lead: string;
  /** The reason why the rollout under the newest couplings failed; empty if it did not fail. */
  problem: string;
  foot: TemplateResult | typeof nothing;
}

/** Futures behind the loops, and others at a wish. */
function futuresChoice(model: SeriesStore, { layers }: Space) {
  const { futures, fiveOthers } = lab().loops;
  const show = async (seed: number) => {
    const { drawFutures } = await import("../latents/outlook-drawing");
    layers.behind = (draw, plane, part, frame) => drawFutures(draw, plane, part, frame, model.futures);
    model.showFutures(seed);
  };
  const { seed } = model;
  return html`
    <div class="marks">
      <button class="chip" data-testid="series-futures" aria-pressed=${seed > 0 ? "true" : "false"} title=${futures.meaning} @click=${() => void show(seed > 0 ? 0 : 1)}>${futures.label}</button>
      ${seed > 0 ? html`<button class="small" data-testid="other-futures" @click=${() => void show(seed + FUTURES)}>${fiveOthers}</button>` : nothing}
    </div>`;
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
      ${model.model ? futuresChoice(model, space) : nothing}
      ${foot}
    </div>`;
}
