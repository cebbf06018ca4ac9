// A canvas with the resolution of the screen.

/**
 * Clears a canvas and fits it to its size on the page, with at most two dots for a pixel; null: the browser
 * cannot draw.
 */
export function clearCanvas(
  canvas: HTMLCanvasElement,
): { draw: CanvasRenderingContext2D; width: number; height: number } | null {
  const ratio = Math.min(2, devicePixelRatio);
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  canvas.width = Math.max(1, width * ratio);
  canvas.height = Math.max(1, height * ratio);
  const draw = canvas.getContext("2d");
  if (!draw) return null;
  draw.scale(ratio, ratio);
  return { draw, width, height };
}
