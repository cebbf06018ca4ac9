// The clips of this worker's trainings and questions. They stay in memory for the next, which mostly has the
// same.
import { Clip, TrainingSet, type VcgpdmError } from "vcgpdm";
import type { ClipSource, ClipsWorker, TrainingClip } from "../engine/protocol";
import { shownClip } from "./shown-clip";
import { using } from "./using";

const read = new Map<number, Clip>();
/** Frames a second of a file whose frame time is no time. */
const ASSUMED = 30;

/** Reads a clip; the caller frees it. */
export async function readClip(source: ClipSource): Promise<Clip> {
  if ("sample" in source) return Clip.sample(source.sample);
  const { name, file, up, fps, root } = source;
  const clip =
    root === undefined
      ? await Clip.read(name, file, fps)
      : Clip.readBody(name, await file.arrayBuffer(), root, fps);
  return up ? using(clip, (found) => found.withUp(up)) : clip;
}

async function clipOf({ id, source }: TrainingClip): Promise<Clip> {
  let clip = read.get(id);
  if (!clip) {
    clip = await readClip(source);
    read.set(id, clip);
  }
  return clip;
}

/** These clips, or pieces of them, as a set, which the caller frees. Other clips are freed. */
export async function clipSet(chosen: readonly TrainingClip[]): Promise<TrainingSet> {
  for (const [id, clip] of read) {
    if (chosen.some((clip) => clip.id === id)) continue;
    read.delete(id);
    clip.free();
  }
  const set = new TrainingSet();
  try {
    for (const piece of chosen) await add(set, piece, chosen[0]);
    return set;
  } catch (problem) {
    set.free();
    throw problem;
  }
}

/** Adds the chosen piece of a clip, with the bones of the first clip where the visitor wants them. */
async function add(set: TrainingSet, piece: TrainingClip, first = piece): Promise<void> {
  const clip = await clipOf(piece);
  const cut = (clip: Clip) =>
    piece.first > 0 || piece.end < clip.info().frames
      ? using(clip.cut(piece.first, piece.end), (cut) => set.add(cut))
      : set.add(clip);
  if (piece.firstBones) using(clip.withBonesOf(await clipOf(first)), cut);
  else cut(clip);
}

export const clipsWorker: ClipsWorker = {
  madeClips: () => Clip.samples(),
  async readClip(source) {
    try {
      return using(await readClip(source), shownClip);
    } catch (problem) {
      if ("sample" in source || source.fps !== undefined) throw problem;
      // A stated rate replaces the frame time: if that helps, nothing else was wrong with the file.
      const clip = await readClip({ ...source, fps: ASSUMED }).catch(() => {
        throw problem;
      });
      const assumed = { fps: ASSUMED, why: (problem as VcgpdmError).message };
      return { ...using(clip, shownClip), assumed };
    }
  },
  async checkTogether(clips) {
    try {
      (await clipSet(clips)).free();
      return null;
    } catch (problem) {
      const { name, message, code } = problem as VcgpdmError;
      // Any other error is a failure of the worker.
      if (name !== "VcgpdmError") throw problem;
      return { words: message, bones: code === "bones" };
    }
  },
  clipBvh: async ({ source, first, end }) =>
    using(await readClip(source), (clip) => using(clip.cut(first, end), (cut) => cut.toBvh())),
};
