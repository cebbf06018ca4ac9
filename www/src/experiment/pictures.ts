// The pictures of an experiment: true and learned latents, and the observed curves.
import { html, nothing, svg } from "lit";
import { percent } from "../figures/numbers";
import { partColour } from "../ui/palette";
import type { SyntheticTruth } from "../engine/whole-protocol";
import { curvePaths, frameOf, linePath } from "./paths";
import { partStyle } from "../ui/styled";

const SIDE = 200;
/** The most frames of the curves; more would blur. */
export const CURVE_FRAMES = 100;

/** A part's true latents, and the learned ones above them. */
export function latentPicture(
  part: number,
  truth: SyntheticTruth | null,
  learned: number[] | null,
  explained: number | null,
) {
  const actual = truth?.latents[part] ?? [];
  const frame = frameOf(actual, SIDE);
  const label = learned
    ? `Part ${part + 1}: the learned latents over the true ones, of which they explain ${percent(explained ?? 0)}`
    : `Part ${part + 1}: the true latents, a path in the plane`;
  return html`
    <figure class="latent-picture" style=${partStyle(partColour(part))}>
      <svg viewBox="0 0 ${SIDE} ${SIDE}" role="img" aria-label=${label}>
        <path class="true-path" d=${linePath(actual, frame)} />
        ${learned ? svg`<path class="learned-path" d=${linePath(learned, frame)} />` : nothing}
      </svg>
      <figcaption><i class="swatch"></i>Part ${part + 1}${learned && explained !== null ? html` <small>${percent(explained)} explained</small>` : nothing}</figcaption>
    </figure>`;
}

/** The observed curves of a part. */
export function curvesPicture(part: number, truth: SyntheticTruth | null) {
  const [width, height] = [300, 130];
  const paths = truth
    ? curvePaths({
        values: truth.observed[part] ?? [],
        columns: truth.columns,
        frames: CURVE_FRAMES,
        width,
        height,
      })
    : [];
  return html`
    <figure class="curves-picture" style=${partStyle(partColour(part))}>
      <svg viewBox="0 0 ${width} ${height}" preserveAspectRatio="none" role="img" aria-label="Part ${part + 1}: ten noisy curves over time">
        ${paths.map((path) => svg`<path d=${path} />`)}
      </svg>
      <figcaption><i class="swatch"></i>Part ${part + 1}</figcaption>
    </figure>`;
}
