// The loop of one part in the plane of a plot.
import { type Projection, principalAxes } from "../../latents/projection";
import type { StoryBody } from "../../app/story-body";
import { type Lap, lapOf } from "./lap";
import { projectPath } from "./lift";

export interface WalkLoop {
  lap: Lap;
  /** The plane of the two widest directions of the loop. */
  projection: Projection;
  /** The lap on the axes of the plot [frames x 3]. */
  seen: Float64Array;
}

/** The loop of a part of the body; `around`: the plot shows this many times its width. Null before the model. */
export function walkLoop(
  { model: { model, learned } }: StoryBody,
  part: number,
  around: number,
): WalkLoop | null {
  const path = learned?.latents[part];
  const dimensions = model?.info.parts[part]?.latent;
  if (!path || !dimensions) return null;
  const lap = lapOf(path, dimensions);
  const { flat, ...axes } = principalAxes(lap.path, dimensions);
  const [right, up] = flat;
  const projection: Projection = { ...axes, flat: [around * right, around * up] };
  return { lap, projection, seen: projectPath(projection, lap.path) };
}
