// The pictures of an experiment: true and learned latents, and the observed curves.
import { html, nothing, svg } from "lit";
import { percent } from "../figures/numbers";
import { partColour } from "../ui/palette";
import type { SyntheticTruth } from "../engine/whole-protocol";
import { curvePaths, frameOf, linePath } from "./paths";
import { partStyle } from "../ui/styled";
import { experimentWords } from "../words/experiment";

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
  const { part: name, pictures: words } = experimentWords();
  const label = learned ? words.learned(part + 1, percent(explained ?? 0)) : words.true(part + 1);
  return html`
    <figure class="latent-picture" style=${partStyle(partColour(part))}>
      <svg viewBox="0 0 ${SIDE} ${SIDE}" role="img" aria-label=${label}>
        <path class="true-path" d=${linePath(actual, frame)} />
        ${learned ? svg`<path class="learned-path" d=${linePath(learned, frame)} />` : nothing}
      </svg>
      <figcaption><i class="swatch"></i>${name(part + 1)}${learned && explained !== null ? html` <small>${words.explained(percent(explained))}</small>` : nothing}</figcaption>
    </figure>`;
}

/** The observed curves of a part. */
export function curvesPicture(part: number, truth: SyntheticTruth | null) {
  const [width, height] = [300, 130];
  const { part: name, pictures: words } = experimentWords();
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
      <svg viewBox="0 0 ${width} ${height}" preserveAspectRatio="none" role="img" aria-label=${words.curves(part + 1)}>
        ${paths.map((path) => svg`<path d=${path} />`)}
      </svg>
      <figcaption><i class="swatch"></i>${name(part + 1)}</figcaption>
    </figure>`;
}
