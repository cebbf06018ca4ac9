// A rollout that goes on from a frame of the one before. No DOM.
import type { SeriesRollout } from "../engine/series-protocol";

/** Frames that stay before that frame: as many as the trail of a pen shows. */
const KEPT = 30;

/**
 * How a rollout of some frames goes on after `frame`, with dynamics of some order: the first frame that stays, the
 * latents that begin the next rollout, and both in one. `back`: frames by which each part is set back.
 */
export function goingOn(
  { values, latents }: SeriesRollout,
  [frames, frame, order]: readonly [number, number, number],
  back: readonly number[] = [],
) {
  const end = Math.max(order, Math.floor(frame) + 1);
  const first = Math.max(0, end - KEPT);
  const rows = (all: Float64Array, from: number, to: number) =>
    all.subarray((all.length / frames) * from, (all.length / frames) * to);
  const join = (all: Float64Array, next: Float64Array | undefined) =>
    Float64Array.from([...rows(all, first, end - order), ...(next ?? [])]);
  return {
    first,
    start: latents.map((path, part) => {
      const from = Math.max(0, end - order - (back[part] ?? 0));
      return Array.from({ length: order }, (_, k) => [...rows(path, from + k, from + k + 1)]);
    }),
    joined: (next: SeriesRollout): SeriesRollout => ({
      ...next,
      values: join(values, next.values),
      latents: latents.map((path, part) => join(path, next.latents[part])),
    }),
  };
}
