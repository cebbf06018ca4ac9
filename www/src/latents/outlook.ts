// What may come: the store, how the plots draw it, and its words; loaded when it is asked for.
import type { Behind } from "./latent-drawing";
import { drawFutures, drawMoments } from "./outlook-drawing";
import type { OutlookStore } from "./outlook-store";
import "./outlook-view";

export { OutlookStore } from "./outlook-store";

/** What the plots draw behind the path now; null: nothing. */
export function behindPath({ futures, moments }: OutlookStore): Behind | null {
  if (futures.length === 0 && !moments) return null;
  return (draw, plane, part, frame) => {
    const known = moments?.[part];
    if (known) drawMoments(draw, plane, frame, known);
    drawFutures(draw, plane, part, frame, futures);
  };
}
