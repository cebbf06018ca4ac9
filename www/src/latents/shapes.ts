// Shapes for the drawings of latent spaces.
import { deviationAcross, type Ellipse, ellipseOf, type Spread } from "./plane";

/** The head of an arrow, in the fill colour. */
export function arrowHead(draw: CanvasRenderingContext2D, from: number[], to: number[], size: number): void {
  const angle = Math.atan2(to[1]! - from[1]!, to[0]! - from[0]!);
  draw.beginPath();
  draw.moveTo(to[0]!, to[1]!);
  draw.lineTo(to[0]! - size * Math.cos(angle - 0.5), to[1]! - size * Math.sin(angle - 0.5));
  draw.lineTo(to[0]! - size * Math.cos(angle + 0.5), to[1]! - size * Math.sin(angle + 0.5));
  draw.closePath();
  draw.fill();
}

export function fillDot(draw: CanvasRenderingContext2D, x: number, y: number, radius: number): void {
  draw.beginPath();
  draw.arc(x, y, radius, 0, 2 * Math.PI);
  draw.fill();
}

export function traceEllipse(draw: CanvasPath, { x, y, major, minor, angle }: Ellipse, times = 1): void {
  draw.ellipse(x, y, times * major, times * minor, angle, 0, 2 * Math.PI, true);
}

/** An ellipse in the present colours, its inside with this opacity. */
export function drawEllipse(
  draw: CanvasRenderingContext2D,
  ellipse: Ellipse,
  inside: number,
  times = 1,
): void {
  draw.beginPath();
  traceEllipse(draw, ellipse, times);
  draw.globalAlpha = inside;
  draw.fill();
  draw.globalAlpha = 1;
  draw.stroke();
}

/** One frame of a band. */
export interface BandPoint {
  x: number;
  y: number;
  spread: Spread;
}

/** A band of `times` deviations to each side of a path, as one shape, so that crossings are not darker. */
export function traceBand(draw: CanvasPath, points: readonly BandPoint[], times = 1): void {
  let before: BandPoint | null = null;
  for (const point of points) {
    const { x, y, spread } = point;
    const start = ellipseOf([x, y], spread);
    draw.moveTo(
      x + times * start.major * Math.cos(start.angle),
      y + times * start.major * Math.sin(start.angle),
    );
    traceEllipse(draw, start, times);
    if (before) {
      const [dx, dy] = [x - before.x, y - before.y];
      const length = Math.hypot(dx, dy) || 1;
      const [nx, ny] = [-dy / length, dx / length];
      const [wide0, wide1] = [before, point].map(({ spread }) => times * deviationAcross(spread, dx, dy)) as [
        number,
        number,
      ];
      // The same orientation as the ellipses, so that overlapping shapes are filled once.
      draw.moveTo(before.x + wide0 * nx, before.y + wide0 * ny);
      draw.lineTo(x + wide1 * nx, y + wide1 * ny);
      draw.lineTo(x - wide1 * nx, y - wide1 * ny);
      draw.lineTo(before.x - wide0 * nx, before.y - wide0 * ny);
      draw.closePath();
    }
    before = point;
  }
}
