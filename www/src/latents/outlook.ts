// The outlook: its store, its drawing and its text. Loaded on demand.
import type { Behind } from "./latent-drawing";
import { drawFutures, drawMoments, drawPicture } from "./outlook-drawing";
import type { OutlookStore } from "./outlook-store";
import "./outlook-view";

export { OutlookStore } from "./outlook-store";

/** The drawing behind the path; null if there is nothing to draw. */
export function behindPath(outlook: OutlookStore): Behind | null {
  const { futures, moments } = outlook;
  if (futures.length === 0 && !moments && !outlook.isShown("certainty")) return null;
  return (draw, plane, part, frame) => {
    drawPicture(draw, plane, part, outlook);
    const own = moments?.[part];
    if (own) drawMoments(draw, plane, frame, own);
    drawFutures(draw, plane, part, frame, futures);
  };
}
