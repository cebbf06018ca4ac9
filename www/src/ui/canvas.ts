// A canvas of the page, as fine as the screen.

/**
 * Makes a canvas empty and as large as it stands on the page; null where the browser cannot draw. Two dots a
 * pixel are fine enough.
 */
export function cleared(
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
