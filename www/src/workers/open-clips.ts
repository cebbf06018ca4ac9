// The clips that the worker holds for the page, each under a number. No DOM.
import { type Clip, TrainingSet, type VcgpdmError } from "vcgpdm/player";
import type { Clash, LoadedClip } from "../engine/protocol";
import { transfer } from "./transfer";
import { using } from "./using";

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
    return transfer({ id: this.#lastId, info, motion }, motion.positions);
  }

  drop(id: number): void {
    this.#clips.get(id)?.free();
    this.#clips.delete(id);
  }

  /** Why these clips cannot be trained on together; null: they can. */
  checkTogether(ids: readonly number[], firstBones: boolean): Clash | null {
    const [first, ...others] = ids.map((id) => this.#clip(id));
    if (!first) return null;
    try {
      using(new TrainingSet(), (set) => {
        set.add(first);
        for (const clip of others) {
          if (firstBones) using(clip.withBonesOf(first), (moved) => set.add(moved));
          else set.add(clip);
        }
      });
      return null;
    } catch (problem) {
      const { message, code } = problem as VcgpdmError;
      return { words: message, bones: code === "bones" };
    }
  }

  toBvh(id: number, first: number, end: number): string {
    return using(this.#clip(id).cut(first, end), (cut) => cut.toBvh());
  }

  #clip(id: number): Clip {
    const clip = this.#clips.get(id);
    if (!clip) throw new Error(`Clip ${id} is no longer open.`);
    return clip;
  }
}
