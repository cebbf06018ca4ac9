// Draws the outlook behind the path of a part: sampled futures, and the Gaussian of moment matching.
import type { PartMoments } from "../engine/whole-protocol";
import { partColourNow, theme } from "../ui/palette";
import type { OutlookStore } from "./outlook-store";
import { ellipseOf, type Plane } from "./plane";
import { interpolate } from "./prediction-at";
import { type BandPoint, fillDot, traceBand, traceEllipse } from "./shapes";

/** A sampled rollout. */
export type Future = { latents: readonly Float64Array[]; request: { frames: number } };

/** Frames of the drawn trail: half a second. All laps together would be a tangle. */
const TRAIL = 15;

/** The whole frames of the trail, and then the time now. */
export function trailTimes(frame: number, last: number): number[] {
  const now = Math.min(frame, last);
  const first = Math.max(0, Math.ceil(now - TRAIL));
  const whole = Array.from({ length: Math.max(0, Math.ceil(now) - first) }, (_, i) => first + i);
  return [...whole, now];
}

/** The picture of how sure the model is, in the colour of the part; nothing where the plot is turned. */
export function drawPicture(
  draw: CanvasRenderingContext2D,
  plane: Plane,
  part: number,
  outlook: OutlookStore,
): void {
  const { section } = plane;
  if (!section) return;
  const hex = Number.parseInt(partColourNow(part).slice(1), 16);
  const colour: [number, number, number] = [hex >> 16, (hex >> 8) & 255, hex & 255];
  const picture = outlook.pictureOf(part, { ...section, colour });
  if (picture) draw.drawImage(picture, 0, 0, section.width, section.height);
}

export function drawFutures(
  draw: CanvasRenderingContext2D,
  plane: Plane,
  part: number,
  frame: number,
  futures: readonly Future[],
): void {
  draw.strokeStyle = draw.fillStyle = partColourNow(part);
  draw.lineWidth = 1.25;
  for (const { latents, request } of futures) {
    const path = latents[part];
    if (!path) continue;
    const dimensions = path.length / request.frames;
    const points = trailTimes(frame, request.frames - 1).map((time) =>
      plane.place(interpolate(path, time, dimensions), 0),
    );
    draw.globalAlpha = 0.4;
    draw.beginPath();
    for (const [x, y] of points) draw.lineTo(x, y);
    draw.stroke();
    const [x, y] = points.at(-1) ?? [0, 0];
    draw.globalAlpha = 0.8;
    fillDot(draw, x, y, 2.8);
  }
}

/** The Gaussian at a time, which need not be a whole frame. */
export function momentsAt(plane: Plane, { means, covariances }: PartMoments, time: number): BandPoint {
  // n Q numbers and n Q^2 numbers.
  const dimensions = covariances.length / means.length;
  const [x, y] = plane.place(interpolate(means, time, dimensions), 0);
  return { x, y, spread: plane.spread(interpolate(covariances, time, dimensions * dimensions), 0) };
}

export function drawMoments(
  draw: CanvasRenderingContext2D,
  plane: Plane,
  frame: number,
  moments: PartMoments,
): void {
  const frames = moments.means.length ** 2 / Math.max(1, moments.covariances.length);
  const band = trailTimes(frame, frames - 1).map((time) => momentsAt(plane, moments, time));
  const now = band.at(-1);
  if (!now) return;
  const { quiet } = theme();
  draw.fillStyle = draw.strokeStyle = quiet;
  for (const deviations of [2, 1]) {
    draw.globalAlpha = 0.14;
    draw.beginPath();
    traceBand(draw, band, deviations);
    draw.fill();
    draw.globalAlpha = 0.9;
    draw.lineWidth = deviations === 1 ? 1.5 : 1;
    draw.beginPath();
    traceEllipse(draw, ellipseOf([now.x, now.y], now.spread), deviations);
    draw.stroke();
  }
}
