// Clips for a worker that trains: read where they are needed, kept for the next work, which mostly has the
// same. No DOM.
import type { ClipInfo, ClipSource, TrainingClip } from "../engine/protocol";

interface Freed {
  free(): void;
}

interface ClipLike<Clip> extends Freed {
  info(): Pick<ClipInfo, "frames">;
  cut(first: number, end: number): Clip;
  withBonesOf(other: Clip): Clip;
}

interface SetLike extends Freed {
  add(clip: unknown): void;
}

/** What the package offers for reading; there are two packages, a small and a whole one. */
interface Package<Clip, TrainingSet> {
  Clip: { sample(id: string): Clip; read(name: string, bytes: Uint8Array): Clip };
  TrainingSet: { new (): TrainingSet };
}

/** Reads a clip; whoever asks frees it. */
export const readClip = async <Clip>(
  { Clip }: Pick<Package<Clip, never>, "Clip">,
  source: ClipSource,
): Promise<Clip> =>
  "sample" in source
    ? Clip.sample(source.sample)
    : Clip.read(source.name, new Uint8Array(await source.file.arrayBuffer()));

export class ClipReader<Clip extends ClipLike<Clip>, TrainingSet extends SetLike> {
  private readonly read = new Map<number, Clip>();

  constructor(private readonly from: Package<Clip, TrainingSet>) {}

  private async clip({ id, source }: TrainingClip): Promise<Clip> {
    let clip = this.read.get(id);
    if (!clip) {
      clip = await readClip(this.from, source);
      this.read.set(id, clip);
    }
    return clip;
  }

  /** These clips, or their pieces, as a set; whoever asks frees it. Other clips are forgotten. */
  async set(chosen: readonly TrainingClip[]): Promise<TrainingSet> {
    for (const [id, clip] of this.read) {
      if (chosen.some((clip) => clip.id === id)) continue;
      this.read.delete(id);
      clip.free();
    }
    const set = new this.from.TrainingSet();
    try {
      for (const piece of chosen) await this.add(set, piece, chosen[0]);
      return set;
    } catch (problem) {
      set.free();
      throw problem;
    }
  }

  /** Adds the piece of a clip that was chosen, with the bones of the first clip where that is asked for. */
  private async add(set: TrainingSet, piece: TrainingClip, first = piece): Promise<void> {
    const whole = await this.clip(piece);
    const moved = piece.firstBones ? whole.withBonesOf(await this.clip(first)) : null;
    const isCut = piece.first > 0 || piece.end < whole.info().frames;
    let cut: Clip | null = null;
    try {
      if (isCut) cut = (moved ?? whole).cut(piece.first, piece.end);
      set.add(cut ?? moved ?? whole);
    } finally {
      cut?.free();
      moved?.free();
    }
  }
}
