// What the page shows of a clip of either program. No DOM.
import type { Clip } from "vcgpdm";
import type { ShownClip } from "../engine/protocol";
import { transfer } from "./using";

export function shownClip(clip: Pick<Clip, "info" | "positions">): ShownClip {
  const info = clip.info();
  const motion = {
    positions: clip.positions(),
    frames: info.frames,
    nodes: info.figure.nodes.length,
    frameTime: info.frameTime,
  };
  return transfer({ info, motion }, motion.positions);
}
