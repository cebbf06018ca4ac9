// The width of a text before it is drawn.

let measure: CanvasRenderingContext2D | null = null;

/** The width in the page's font, pixels; an estimate without a page. */
export function textWidth(text: string, size: number, weight = 400): number {
  if (typeof document === "undefined") return 0.59 * size * text.length;
  measure ??= document.createElement("canvas").getContext("2d");
  if (!measure) return 0.68 * size * text.length;
  measure.font = `${weight} ${size}px ${getComputedStyle(document.documentElement).fontFamily}`;
  return measure.measureText(text).width;
}
