// Draws the product of experts at one time: what each part predicts, what their product is, and the step that is taken.
import type { PredictionsReport } from "../engine/protocol";
import { partColour, theme } from "../ui/palette";
import { type Ellipse, ellipseOf, type Plane } from "./plane";
import { between, type Predicted, type PredictedPart, predictedAt } from "./predicted";
import { type BandPoint, arrowHead, traceBand, traceEllipse } from "./shapes";

/** Whoever has a smaller weight is hardly heard. */
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

/** What is drawn, in pixels. */
export interface DrawnPredictions {
  frame: number;
  experts: Ellipse[];
  product: Ellipse;
  /** The state before and the state now. */
  step: [from: [number, number], to: [number, number]];
}

/** Where everything goes; null where nothing is predicted. */
export function layOut(plane: Plane, picture: PredictionPicture): DrawnPredictions | null {
  const { report, part, dimensions, frame, path } = picture;
  const said: PredictedPart | null = predictedAt(report, part, frame, dimensions);
  if (!said) return null;
  const seen = ({ mean, variance }: Predicted) => ellipseOf(plane.place(mean, 0), plane.roundSpread(variance));
  const state = (time: number): [number, number] => {
    const [x, y] = plane.place(between(path, time, dimensions), 0);
    return [x, y];
  };
  return {
    frame,
    experts: said.experts.map(seen),
    product: seen(said.product),
    step: [state(frame - 1), state(frame)],
  };
}

/** The path as wide as the model is sure of each step: one standard deviation of the product to each side. */
export function drawStepBand(
  draw: CanvasRenderingContext2D,
  plane: Plane,
  { report, part, path }: Pick<PredictionPicture, "report" | "part" | "path">,
  colour: string,
): void {
  const variances = report.parts[part]?.product.variances ?? [];
  const points = Array.from(variances, (variance, row): BandPoint => {
    const [x, y] = plane.place(path, report.firstFrame + row);
    return { x, y, spread: plane.roundSpread(variance) };
  });
  draw.beginPath();
  traceBand(draw, points);
  draw.globalAlpha = 0.16;
  draw.fillStyle = colour;
  draw.fill();
}

export function drawPredictions(
  draw: CanvasRenderingContext2D,
  { experts, product, step }: DrawnPredictions,
  weights: readonly number[],
): void {
  const { ink, dark } = theme();
  experts.forEach((expert, source) => drawExpert(draw, expert, product, weights[source] ?? 0, partColour(source)));
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
  // How far each one pulls: the product lies on the line between two.
  draw.lineWidth = 1;
  draw.globalAlpha = 0.6;
  draw.beginPath();
  draw.moveTo(expert.x, expert.y);
  draw.lineTo(product.x, product.y);
  draw.stroke();
  draw.globalAlpha = 1;
  draw.beginPath();
  draw.arc(expert.x, expert.y, 2.2, 0, 2 * Math.PI);
  draw.fill();
}
