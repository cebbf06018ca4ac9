// Draws the latent space of a part: training latents, rollout, inducing points, and the state now.
import { theme } from "../ui/palette";
import type { DynamicsInducing, InducingReport } from "../engine/protocol";
import { spotlight } from "../stage/spotlight";
import { Plane, type PlotView } from "./plane";
import { interpolate } from "./prediction-at";
import { drawPredictions, layOut, type PredictionPicture, type StepBand } from "./prediction-drawing";
import { arrowHead, fillDot } from "./shapes";

/** Inducing points of a coupling from or to another part. */
export interface Between {
  inducing: DynamicsInducing;
  other: number;
  colour: string;
}

/** Draws something behind the path of one part. */
export type Behind = (draw: CanvasRenderingContext2D, plane: Plane, part: number, frame: number) => void;

export interface LatentPicture extends PlotView {
  ratio: number;
  part: number;
  colour: string;
  /** [frames x Q] */
  rollout: Float64Array;
  /** The path as learned, if the rollout differs from it. */
  learned: Float64Array | null;
  training: Float64Array | null;
  poses: Float64Array | null;
  dynamics: DynamicsInducing | null;
  /** Inducing points whose histories are in this part, and which predict another part. */
  outgoing: Between[];
  /** Inducing points whose predictions are in this part, from another part. */
  incoming: Between[];
  order: number;
  frame: number;
  /** False while the clock belongs to a clip. */
  live: boolean;
  report: InducingReport | null;
  /** Whether the frames of the report belong to this part. */
  lit: boolean;
  /** The predictions about this part; null while they are hidden. */
  predicted: Pick<PredictionPicture, "report" | "weights"> | null;
  band: StepBand;
  behind: Behind | null;
}

/** The opacity of inducing points where predictions are shown. */
const WITH_PREDICTIONS = 0.4;

/** Frames over which the path behind the marker fades. */
const TRAIL = 75;

export function drawLatents(draw: CanvasRenderingContext2D, picture: LatentPicture): void {
  const { width, height, ratio, part, live, frame } = picture;
  const predicted = live ? picture.predicted : null;
  const predictions: PredictionPicture | null = predicted && {
    ...predicted,
    part,
    frame,
    dimensions: picture.projection.dimensions,
    path: picture.rollout,
  };
  draw.setTransform(ratio, 0, 0, ratio, 0, 0);
  draw.clearRect(0, 0, width, height);
  draw.lineJoin = "round";
  draw.lineCap = "round";
  const plane = new Plane(picture);
  if (picture.training) drawTraining(draw, picture, plane, picture.training);
  if (picture.learned) drawLearned(draw, picture, plane, picture.learned);
  if (live) picture.behind?.(draw, plane, part, frame);
  if (predictions)
    picture.band.draw(draw, plane, predictions, { view: picture, colour: picture.colour, ratio });
  drawRollout(draw, picture, plane);
  if (picture.lit && picture.report) drawLit(draw, picture, plane, spotlight(picture.report.frames));
  const strength = predicted ? WITH_PREDICTIONS : 1;
  if (picture.dynamics) drawPairs(draw, picture, plane, picture.dynamics, strength);
  for (const between of picture.outgoing) drawOutgoing(draw, picture, plane, between);
  for (const between of picture.incoming) drawIncoming(draw, plane, between);
  if (picture.poses) drawPoses(draw, picture, plane, picture.poses, strength);
  const drawn = predictions && layOut(plane, predictions);
  if (live) drawNow(draw, picture, plane, drawn !== null);
  if (predictions && drawn) drawPredictions(draw, drawn, predictions.weights);
  draw.globalAlpha = 1;
}

function rows(points: Float64Array, picture: LatentPicture): number {
  return Math.floor(points.length / picture.projection.dimensions);
}

function drawTraining(
  draw: CanvasRenderingContext2D,
  picture: LatentPicture,
  plane: Plane,
  points: Float64Array,
): void {
  draw.fillStyle = theme().quiet;
  draw.globalAlpha = 0.32;
  const count = rows(points, picture);
  for (let t = 0; t < count; t++) {
    const [x, y] = plane.place(points, t);
    draw.fillRect(x - 0.75, y - 0.75, 1.5, 1.5);
  }
}

function drawLearned(
  draw: CanvasRenderingContext2D,
  picture: LatentPicture,
  plane: Plane,
  points: Float64Array,
): void {
  draw.strokeStyle = theme().ghost;
  draw.globalAlpha = 0.5;
  draw.lineWidth = 1.25;
  tracePath(draw, plane, points, rows(points, picture));
}

/** The whole path, and over it the trail that fades behind the marker. */
function drawRollout(draw: CanvasRenderingContext2D, picture: LatentPicture, plane: Plane): void {
  const { rollout, frame, live } = picture;
  const count = rows(rollout, picture);
  draw.strokeStyle = picture.colour;
  draw.globalAlpha = live ? 0.16 : 0.5;
  draw.lineWidth = 1.25;
  tracePath(draw, plane, rollout, count);
  if (!live) return;
  const first = Math.max(1, Math.ceil(frame - TRAIL));
  for (let t = first; t < count && t <= frame + 1; t++) {
    const recent = 1 - (frame - t) / TRAIL;
    draw.globalAlpha = Math.min(1, recent * recent);
    draw.lineWidth = 1.25 + 1.75 * recent;
    const [[x0, y0], [x, y]] = [plane.place(rollout, t - 1), plane.place(rollout, t)];
    draw.beginPath();
    draw.moveTo(x0, y0);
    draw.lineTo(x, y);
    draw.stroke();
  }
}

function tracePath(draw: CanvasRenderingContext2D, plane: Plane, path: Float64Array, count: number): void {
  draw.beginPath();
  for (let t = 0; t < count; t++) {
    const [x, y] = plane.place(path, t);
    draw.lineTo(x, y);
  }
  draw.stroke();
}

function drawLit(
  draw: CanvasRenderingContext2D,
  picture: LatentPicture,
  plane: Plane,
  light: Float64Array,
): void {
  draw.fillStyle = picture.colour;
  const count = Math.min(light.length, rows(picture.rollout, picture));
  for (let t = 0; t < count; t++) {
    if (light[t]! < 0.05) continue;
    const [x, y] = plane.place(picture.rollout, t);
    draw.globalAlpha = 0.55 * light[t]!;
    fillDot(draw, x, y, 4.5);
  }
}

/** Draws an arrow at the edge for an inducing point outside the plot; false for a point inside. */
function drawBeyond(draw: CanvasRenderingContext2D, plane: Plane, x: number, y: number): boolean {
  const [atX, atY] = plane.inFrame(x, y);
  const away = Math.hypot(x - atX, y - atY);
  if (away === 0) return false;
  const tip = [atX + (5 * (x - atX)) / away, atY + (5 * (y - atY)) / away];
  arrowHead(draw, [atX, atY], tip, 8);
  draw.stroke();
  return true;
}

/** Each history as a dot and a line through its states, then an arrow to its prediction. */
function drawPairs(
  draw: CanvasRenderingContext2D,
  picture: LatentPicture,
  plane: Plane,
  inducing: DynamicsInducing,
  strength: number,
): void {
  const { ink } = theme();
  const { order } = picture;
  draw.strokeStyle = ink;
  draw.fillStyle = ink;
  draw.lineWidth = 1.25;
  for (let i = 0; i < inducing.count; i++) {
    draw.globalAlpha = 0.78 * strength;
    const end = plane.place(inducing.outputs, i);
    let last = plane.placeInHistory(inducing.inputs, order, i, 0);
    const start = last;
    draw.beginPath();
    draw.moveTo(last[0], last[1]);
    for (let step = 1; step < order; step++) {
      last = plane.placeInHistory(inducing.inputs, order, i, step);
      draw.lineTo(last[0], last[1]);
    }
    draw.lineTo(end[0], end[1]);
    draw.stroke();
    if (!drawBeyond(draw, plane, end[0], end[1])) arrowHead(draw, last, end, 5.5);
    fillDot(draw, start[0], start[1], 1.6);
  }
}

function drawOutgoing(
  draw: CanvasRenderingContext2D,
  picture: LatentPicture,
  plane: Plane,
  between: Between,
): void {
  const { order } = picture;
  draw.strokeStyle = between.colour;
  draw.fillStyle = between.colour;
  draw.lineWidth = 1.5;
  draw.globalAlpha = 0.85;
  for (let i = 0; i < between.inducing.count; i++) {
    draw.beginPath();
    let last = plane.placeInHistory(between.inducing.inputs, order, i, 0);
    draw.moveTo(last[0], last[1]);
    for (let step = 1; step < order; step++) {
      last = plane.placeInHistory(between.inducing.inputs, order, i, step);
      draw.lineTo(last[0], last[1]);
    }
    draw.stroke();
    if (drawBeyond(draw, plane, last[0], last[1])) continue;
    fillDot(draw, last[0], last[1], 2.4);
  }
}

function drawIncoming(draw: CanvasRenderingContext2D, plane: Plane, between: Between): void {
  draw.fillStyle = between.colour;
  draw.globalAlpha = 0.85;
  for (let i = 0; i < between.inducing.count; i++) {
    const [x, y] = plane.place(between.inducing.outputs, i);
    if (drawBeyond(draw, plane, x, y)) continue;
    draw.beginPath();
    draw.moveTo(x, y - 3.6);
    draw.lineTo(x + 3.4, y + 2.6);
    draw.lineTo(x - 3.4, y + 2.6);
    draw.closePath();
    draw.fill();
  }
}

function drawPoses(
  draw: CanvasRenderingContext2D,
  picture: LatentPicture,
  plane: Plane,
  points: Float64Array,
  strength: number,
): void {
  const { ground, ink } = theme();
  draw.lineWidth = 1.5;
  draw.strokeStyle = ink;
  draw.fillStyle = ground;
  draw.globalAlpha = strength;
  const count = rows(points, picture);
  for (let i = 0; i < count; i++) {
    const [x, y, near] = plane.place(points, i);
    if (drawBeyond(draw, plane, x, y)) continue;
    const size = 3.9 * (1 + 0.12 * Math.max(-1, Math.min(1, near)));
    draw.beginPath();
    draw.moveTo(x, y - size);
    draw.lineTo(x + size, y);
    draw.lineTo(x, y + size);
    draw.lineTo(x - size, y);
    draw.closePath();
    draw.fill();
    draw.stroke();
  }
}

/** The place of the state now, in pixels; null without a path. */
export function placeNow(picture: LatentPicture, plane: Plane): [number, number] | null {
  const { rollout, frame, projection } = picture;
  if (rollout.length === 0) return null;
  const [x, y] = plane.place(interpolate(rollout, frame, projection.dimensions), 0);
  return [x, y];
}

/** Draws the marker. With predictions it is small and has no halo, which would look like a prediction. */
function drawNow(draw: CanvasRenderingContext2D, picture: LatentPicture, plane: Plane, small: boolean): void {
  const now = placeNow(picture, plane);
  if (!now) return;
  const [x, y] = now;
  draw.fillStyle = picture.colour;
  if (!small) {
    draw.globalAlpha = 0.22;
    fillDot(draw, x, y, 12);
  }
  draw.globalAlpha = 1;
  fillDot(draw, x, y, small ? 3.5 : 6);
  draw.lineWidth = small ? 1 : 2;
  draw.strokeStyle = "#ffffff";
  draw.stroke();
}
