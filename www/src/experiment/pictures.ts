// The pictures of a part: its true and learned latents, its curves, and the model before and after training.
import { html, nothing, svg } from "lit";
import type { SyntheticSnapshot, SyntheticTruth } from "../engine/whole-protocol";
import { percent } from "../figures/numbers";
import { prefersReducedMotion } from "../ui/browser";
import { partColour } from "../ui/palette";
import { partStyle } from "../ui/styled";
import { curvePaths, type Frame, frameOf, linePath, placeIn } from "./paths";
import { experimentWords } from "./view-words";

const SIDE = 200;
/** The free share at each edge of a plane with inducing points, some of which are beside the path. */
const AROUND = 0.17;
/** Frames a second of the moving points. */
const PACE = 15;
/** The size of the pictures of curves. */
const [WIDTH, HEIGHT] = [300, 130];
/** The frames and the columns of generated curves: more would blur. */
const GENERATED = { frames: 100, columns: 3 };
/** Generated curves may be this many times as large as the largest recorded value, and are still drawn whole. */
const LARGEST_GENERATED = 1.7;

/** A point that goes along a path in these seconds. */
const movingPoint = (path: string, seconds: number) =>
  path && seconds > 0 && !prefersReducedMotion()
    ? svg`<circle class="moving-point" r="5"><animateMotion calcMode="linear" path=${path} dur="${seconds}s" repeatCount="indefinite" /></circle>`
    : nothing;

const name = (part: number) => html`<i class="swatch"></i>${experimentWords().part(part + 1)}`;

/** A part's true latents, and the learned ones above them. */
export function latentPicture(part: number, truth: SyntheticTruth | null, model: SyntheticSnapshot | null) {
  const actual = truth?.latents[part] ?? [];
  const frame = frameOf(actual, SIDE);
  const words = experimentWords().pictures;
  const learned = model?.learned[part] ?? null;
  const explained = percent(model?.explained[part] ?? 0);
  const label = learned ? words.learned(part + 1, explained) : words.true(part + 1);
  return html`
    <figure class="latent-picture" style=${partStyle(partColour(part))}>
      <svg viewBox="0 0 ${SIDE} ${SIDE}" role="img" aria-label=${label}>
        <path class="true-path" d=${linePath(actual, frame)} />
        ${movingPoint(linePath(learned ?? actual, frame), (truth?.frames ?? 0) / PACE)}
        ${learned ? svg`<path class="learned-path" d=${linePath(learned, frame)} />` : nothing}
      </svg>
      <figcaption class="row tight note">${name(part)}${learned ? html` <small>${words.explained(explained)}</small>` : nothing}</figcaption>
    </figure>`;
}

/** The observed curves of a part. */
export function curvesPicture(part: number, truth: SyntheticTruth | null, frames: number) {
  const words = experimentWords().pictures;
  const values = truth?.observed[part] ?? [];
  const paths = curvePaths({ values, columns: truth?.columns ?? 0, frames, width: WIDTH, height: HEIGHT });
  return html`
    <figure class="curves-picture" style=${partStyle(partColour(part))}>
      <svg viewBox="0 0 ${WIDTH} ${HEIGHT}" preserveAspectRatio="none" role="img" aria-label=${words.curves(part + 1)}>
        ${paths.map((path) => svg`<path d=${path} />`)}
      </svg>
      <figcaption class="row tight note">${name(part)}</figcaption>
    </figure>`;
}

/** Rows of `width` numbers. */
const rows = (values: readonly number[], width: number) =>
  Array.from({ length: values.length / width }, (_, row) => values.slice(row * width, (row + 1) * width));

/** The states of a dynamics inducing point, joined from the first to the last, which is filled. */
function dynamicsPoint(states: readonly number[], frame: Frame) {
  const places = rows(states, 2).map(([x = 0, y = 0]) => placeIn(frame, x, y));
  const dot = ([x, y]: readonly [number, number], k: number) =>
    svg`<circle class=${k + 1 < places.length ? "" : "last"} cx=${x} cy=${y} r="3.2" />`;
  return svg`<g class="dynamics-point"><path d=${linePath(states, frame)} />${places.map(dot)}</g>`;
}

const posePoint = ([x, y]: readonly [number, number]) =>
  svg`<path class="pose-point" d="M${x} ${y - 3.6}l3.6 3.6l-3.6 3.6l-3.6 -3.6z" />`;

/** The latent space of a part: mean path and inducing points, as many for the dynamics as for poses. */
function planePicture(part: number, truth: SyntheticTruth, model: SyntheticSnapshot, when: string) {
  const label = experimentWords().inside.plane(part + 1, when);
  const frame = frameOf(truth.latents[part] ?? [], SIDE, AROUND);
  const path = linePath(model.path[part] ?? [], frame);
  const poses = model.poseIps[part] ?? [];
  const dynamics = model.dynamicsIps[part] ?? [];
  return html`
    <svg viewBox="0 0 ${SIDE} ${SIDE}" role="img" aria-label=${label}>
      <path class="true-path" d=${linePath(model.learned[part] ?? [], frame)} />
      <path class="mean-path" d=${path} />
      ${rows(poses, 2).map(([x = 0, y = 0]) => posePoint(placeIn(frame, x, y)))}
      ${rows(dynamics, (2 * dynamics.length) / poses.length).map((states) => dynamicsPoint(states, frame))}
      ${movingPoint(path, truth.frames / PACE)}
    </svg>`;
}

/** Some of the recorded curves of a part, and over them those that the model makes. */
function generatedPicture(part: number, truth: SyntheticTruth, model: SyntheticSnapshot) {
  const some = (values: readonly number[] = []) =>
    rows(values, truth.columns).flatMap((row) => row.slice(0, GENERATED.columns));
  const recorded = some(truth.observed[part]);
  const largest = LARGEST_GENERATED * Math.max(...recorded.map(Math.abs));
  const paths = (values: number[]) =>
    curvePaths({ values, ...GENERATED, width: WIDTH, height: HEIGHT, largest });
  return html`
    <svg class="curves-box" viewBox="0 0 ${WIDTH} ${HEIGHT}" preserveAspectRatio="none" aria-hidden="true">
      ${paths(recorded).map((path) => svg`<path class="true-path" d=${path} />`)}
      ${paths(some(model.generated[part])).map((path) => svg`<path class="learned-path" d=${path} />`)}
    </svg>`;
}

/** A part of the model before training and now: figure 3, E to H, of the paper. `now`: null before training. */
export function snapshotPictures(part: number, truth: SyntheticTruth | null, now: SyntheticSnapshot | null) {
  const words = experimentWords().inside;
  const column = (model: SyntheticSnapshot | null, when: string) => html`
    <figure>
      <figcaption class="row tight note">${name(part)} <small>${when}</small></figcaption>
      ${
        truth && model
          ? [planePicture(part, truth, model, when), generatedPicture(part, truth, model)]
          : html`<p class="empty">${words.press}</p>`
      }
    </figure>`;
  return html`
    <div class="snapshots" style=${partStyle(partColour(part))}>
      ${column(truth?.start ?? null, words.before)} ${column(now, words.after)}
    </div>`;
}

/** What the marks of these pictures mean. */
export function snapshotLegend() {
  const words = experimentWords().inside;
  const entry = (mark: unknown, text: string) =>
    html`<li class="row tight"><svg viewBox="-10 -7 20 14" aria-hidden="true">${mark}</svg>${text}</li>`;
  const unit: Frame = { middle: [0, 0], scale: 1, side: 0 };
  return html`
    <ul class="legend wrap hint">
      ${entry(svg`<path class="true-path" d="M-9 0H9" />`, words.learned)}
      ${entry(svg`<path class="mean-path" d="M-9 0H9" />`, words.path)}
      ${entry(dynamicsPoint([-6, 0, 5, 0], unit), words.dynamics)}
      ${entry(posePoint([0, 0]), words.poses)}
    </ul>`;
}
