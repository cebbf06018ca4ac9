// Draws the product of experts at one time: the prediction of each part, their product, and the next step.
import type { PredictionsReport } from "../engine/protocol";
import { partColourNow, theme } from "../ui/palette";
import { type Ellipse, ellipseOf, type Plane, type PlotView } from "./plane";
import { interpolate, type Gaussian, type PartPrediction, predictedAt } from "./prediction-at";
import { type BandPoint, arrowHead, fillDot, traceBand, traceEllipse } from "./shapes";

/** A source with a smaller weight is drawn dashed. */
const HEARD = 0.01;

export interface PredictionPicture {
  report: PredictionsReport;
  part: number;
  dimensions: number;
  /** w of each source. */
  weights: number[];
  frame: number;
  /** [frames x Q] */
  path: Float64Array;
}

/** The drawing in pixels. */
interface DrawnPredictions {
  experts: Ellipse[];
  product: Ellipse;
  /** The state before and the state now. */
  step: [from: [number, number], to: [number, number]];
}

/** The drawing of a time; null without predictions at that time. */
export function layOut(plane: Plane, picture: PredictionPicture): DrawnPredictions | null {
  const { report, part, dimensions, frame, path } = picture;
  const predictions: PartPrediction | null = predictedAt(report, part, frame, dimensions);
  if (!predictions) return null;
  const seen = ({ mean, variance }: Gaussian) => ellipseOf(plane.place(mean, 0), plane.roundSpread(variance));
  const state = (time: number): [number, number] => {
    const [x, y] = plane.place(interpolate(path, time, dimensions), 0);
    return [x, y];
  };
  return {
    experts: predictions.experts.map(seen),
    product: seen(predictions.product),
    step: [state(frame - 1), state(frame)],
  };
}

export interface BandLook {
  view: PlotView;
  colour: string;
  ratio: number;
}

/**
 * A band around the path: one standard deviation of the product to each side. The band does not change with
 * time, so it is drawn once, on a canvas of its own.
 */
export class StepBand {
  #canvas: HTMLCanvasElement | null = null;
  #drawn: (BandLook & { report: PredictionsReport }) | null = null;

  draw(
    draw: CanvasRenderingContext2D,
    plane: Plane,
    predictions: { report: PredictionsReport; part: number },
    look: BandLook,
  ): void {
    const { report } = predictions;
    const { view, colour, ratio } = look;
    this.#canvas ??= document.createElement("canvas");
    const before = this.#drawn;
    if (
      before?.report !== report ||
      before.colour !== colour ||
      before.ratio !== ratio ||
      !sameView(before.view, view)
    ) {
      const { projection, turn, width, height } = view;
      this.#drawn = { report, colour, ratio, view: { projection, turn, width, height } };
      [this.#canvas.width, this.#canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
      const band = this.#canvas.getContext("2d");
      if (!band) return;
      band.scale(ratio, ratio);
      band.globalAlpha = 0.16;
      band.fillStyle = colour;
      band.beginPath();
      traceBand(band, stepBand(plane, report, predictions.part));
      band.fill();
    }
    draw.globalAlpha = 1;
    draw.drawImage(this.#canvas, 0, 0, view.width, view.height);
  }
}

function sameView(a: PlotView, b: PlotView): boolean {
  return a.projection === b.projection && a.turn === b.turn && a.width === b.width && a.height === b.height;
}

function stepBand(plane: Plane, report: PredictionsReport, part: number): BandPoint[] {
  const product = report.parts[part]?.product;
  if (!product) return [];
  return Array.from(product.variances, (variance, row): BandPoint => {
    const [x, y] = plane.place(product.means, row);
    return { x, y, spread: plane.roundSpread(variance) };
  });
}

export function drawPredictions(
  draw: CanvasRenderingContext2D,
  { experts, product, step }: DrawnPredictions,
  weights: readonly number[],
): void {
  const { ink, dark } = theme();
  experts.forEach((expert, source) =>
    drawExpert(draw, expert, product, weights[source] ?? 0, partColourNow(source)),
  );
  const [from, to] = step;
  draw.globalAlpha = 1;
  draw.strokeStyle = draw.fillStyle = ink;
  draw.lineWidth = 1.5;
  draw.beginPath();
  draw.moveTo(...from);
  draw.lineTo(...to);
  draw.stroke();
  arrowHead(draw, from, to, 7);
  draw.strokeStyle = dark ? "#ffffff" : "#000000";
  draw.lineWidth = 1.75;
  draw.beginPath();
  traceEllipse(draw, product);
  draw.stroke();
}

function drawExpert(
  draw: CanvasRenderingContext2D,
  expert: Ellipse,
  product: Ellipse,
  weight: number,
  colour: string,
): void {
  const heard = weight >= HEARD;
  draw.strokeStyle = draw.fillStyle = colour;
  draw.lineWidth = heard ? 2 : 1;
  draw.globalAlpha = 0.12;
  draw.beginPath();
  traceEllipse(draw, expert);
  if (heard) draw.fill();
  else draw.setLineDash([4, 4]);
  draw.globalAlpha = heard ? 0.95 : 0.45;
  draw.stroke();
  draw.setLineDash([]);
  if (!heard) return;
  // With two sources, the product lies on the line between them.
  draw.lineWidth = 1;
  draw.globalAlpha = 0.6;
  draw.beginPath();
  draw.moveTo(expert.x, expert.y);
  draw.lineTo(product.x, product.y);
  draw.stroke();
  draw.globalAlpha = 1;
  fillDot(draw, expert.x, expert.y, 2.2);
}
