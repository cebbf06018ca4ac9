// Paints how sure a pose map is over the plane of a plot: dense where the model knows the pose.

/** Pixels of a cell, which has one colour before the picture is smoothed. */
const CELL = 8;
/** Opacity of the colour where the pose is certain. */
const OPAQUE = 0.34;

/** The cells of a picture. */
export interface Cells {
  columns: number;
  rows: number;
}

export const cellsOf = (width: number, height: number): Cells => ({
  columns: Math.ceil(width / CELL),
  rows: Math.ceil(height / CELL),
});

/** The latent points at the middles of all cells, row after row [cells x Q]. */
export function cellPoints(
  { columns, rows }: Cells,
  pointAt: (x: number, y: number) => Float64Array,
): Float64Array {
  const first = pointAt(CELL / 2, CELL / 2);
  const points = new Float64Array(columns * rows * first.length);
  for (let n = 0; n < columns * rows; n++)
    points.set(
      pointAt(((n % columns) + 0.5) * CELL, (Math.floor(n / columns) + 0.5) * CELL),
      n * first.length,
    );
  return points;
}

/**
 * How strongly a pose is drawn, 0 to 1, where this share of the prior variance is left: by the deviation, which
 * is the error of the pose that the model expects.
 */
export const strengthOf = (share: number): number => (1 - Math.sqrt(Math.min(1, Math.max(0, share)))) ** 3;

/** A canvas with the colour (red, green, blue) in the strength of each cell. */
export function certaintyPicture(
  { columns, rows }: Cells,
  shares: Float64Array,
  colour: readonly [number, number, number],
): HTMLCanvasElement | null {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [columns, rows];
  const draw = canvas.getContext("2d");
  if (!draw) return null;
  const image = draw.createImageData(columns, rows);
  shares.forEach((share, n) => image.data.set([...colour, 255 * OPAQUE * strengthOf(share)], 4 * n));
  draw.putImageData(image, 0, 0);
  return canvas;
}

export function drawCertainty(
  draw: CanvasRenderingContext2D,
  picture: HTMLCanvasElement,
  { columns, rows }: Cells,
): void {
  draw.imageSmoothingEnabled = true;
  draw.imageSmoothingQuality = "high";
  draw.drawImage(picture, 0, 0, columns * CELL, rows * CELL);
}

/** Red, green and blue of a colour such as "#0072b2". */
export function channels(hex: string): [number, number, number] {
  const value = Number.parseInt(hex.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}
