// How wide a text will be, before it is drawn.

let measure: CanvasRenderingContext2D | null = null;

/** Pixels, in the page's font; without a page about as wide as in a common one. */
export function textWidth(text: string, size: number, weight = 400): number {
  if (typeof document === "undefined") return 0.59 * size * text.length;
  measure ??= document.createElement("canvas").getContext("2d");
  if (!measure) return 0.68 * size * text.length;
  measure.font = `${weight} ${size}px ${getComputedStyle(document.documentElement).fontFamily}`;
  return measure.measureText(text).width;
}
