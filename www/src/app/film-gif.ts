// A moving picture as GIF, for a browser that writes no videos.
import { encode } from "modern-gif";
import workerUrl from "modern-gif/worker?url";
import { eachFrame } from "../ui/browser";

/** The longer side of the picture in pixels. */
const SIDE = 480;
const PICTURES_A_SECOND = 10;

/** What a canvas shows until `ended`. */
export async function gifOf(canvas: HTMLCanvasElement, ended: Promise<void>): Promise<Blob> {
  const scale = Math.min(1, SIDE / Math.max(canvas.width, canvas.height));
  const [width, height] = [Math.round(scale * canvas.width), Math.round(scale * canvas.height)];
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("no 2d canvas");
  context.fillStyle = getComputedStyle(document.body).backgroundColor;
  const delay = 1000 / PICTURES_A_SECOND;
  const frames: { data: Uint8ClampedArray<ArrayBuffer>; delay: number }[] = [];
  let since = Number.POSITIVE_INFINITY;
  // The stage has drawn its picture earlier in the same frame of the browser; later the picture is gone.
  const stop = eachFrame((seconds) => {
    since += 1000 * seconds;
    if (since < delay) return;
    since = 0;
    context.fillRect(0, 0, width, height);
    context.drawImage(canvas, 0, 0, width, height);
    frames.push({ data: context.getImageData(0, 0, width, height).data, delay });
  });
  await ended;
  stop();
  return encode({ width, height, frames, workerUrl, format: "blob" });
}
