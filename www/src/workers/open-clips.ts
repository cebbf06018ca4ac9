// The clips that the worker holds for the page, each under a number. No DOM.
import { type Clip, TrainingSet } from "vcgpdm/playground";
import type { LoadedClip } from "../engine/protocol";
import { handOver } from "./hand-over";

export class OpenClips {
  readonly #clips = new Map<number, Clip>();
  #lastId = 0;

  open(clip: Clip): LoadedClip {
    const info = clip.info();
    const motion = {
      positions: clip.positions(),
      frames: info.frames,
      nodes: info.figure.nodes.length,
      frameTime: info.frameTime,
    };
    this.#lastId += 1;
    this.#clips.set(this.#lastId, clip);
    return handOver({ id: this.#lastId, info, motion }, motion.positions);
  }

  drop(id: number): void {
    this.#clips.get(id)?.free();
    this.#clips.delete(id);
  }

  /** Throws with the reason when these clips cannot be trained on together. */
  checkTogether(ids: readonly number[]): void {
    const set = new TrainingSet();
    try {
      for (const id of ids) set.add(this.#clip(id));
    } finally {
      set.free();
    }
  }

  toBvh(id: number, first: number, end: number): string {
    const cut = this.#clip(id).cut(first, end);
    try {
      return cut.toBvh();
    } finally {
      cut.free();
    }
  }

  #clip(id: number): Clip {
    const clip = this.#clips.get(id);
    if (!clip) throw new Error(`Clip ${id} is no longer open.`);
    return clip;
  }
}
