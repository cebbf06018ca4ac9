// Names of saved files. BVH has no comments that every reader skips, so the name of a motion has its model,
// changed couplings, start and length.
import { modelName, plain } from "../couplings/model-file";
import type { ModelInfo, Reading } from "../engine/protocol";
import type { ChangedCouplings } from "../settings/settings";
import { clipTitle } from "../ui/format";

/** The most changed couplings in a name; of more the name has the number. */
const NAMED = 3;

export interface RolledOut {
  info: Pick<ModelInfo, "parts" | "sequences" | "frameTime">;
  /** The first digits of the hash of the model's document. */
  id: string;
  alpha: ChangedCouplings;
  reading: Reading;
  /** The training sequence that begins the motion. */
  sequence: number;
  /** The frame of that sequence; absent: the first. */
  frame?: number | undefined;
  /** The title of the clip that begins the motion in place of a sequence. */
  clip?: string | undefined;
  frames: number;
}

/** The name of the model and the differences of this motion: "...-lower-upper-5-as-35_02-10s". */
export function motionName(motion: RolledOut): string {
  const { info, sequence, frame, frames, clip } = motion;
  const start = info.sequences[sequence];
  const words = [modelName(motion), ...couplingWords(motion)];
  if (clip) words.push(`as-${plain(clip) || "clip"}`);
  else if (sequence > 0 && start) words.push(`as-${plain(clipTitle(start.name)) || sequence + 1}`);
  if (frame) words.push(`from-${frame + 1}`);
  words.push(`${Number((frames * info.frameTime).toFixed(1))}s`);
  return words.join("-");
}

function couplingWords({ info, alpha, reading }: RolledOut): string[] {
  const changed = Object.entries(alpha);
  if (changed.length === 0) return [];
  const name = (part: string | undefined) => plain(info.parts[Number(part)]?.name ?? "") || String(part);
  const words = changed.slice(0, NAMED).map(([pair, value]) => {
    const [source, target] = pair.split(".");
    return `${name(source)}-${name(target)}-${Number(value.toPrecision(4))}`;
  });
  // Motions that differ only in couplings outside the name have different checksums.
  if (changed.length > NAMED)
    words.push(`and-${changed.length - NAMED}-more-${checksum(JSON.stringify(changed))}`);
  return reading === "re-inferred" ? [...words, "re-inferred"] : words;
}

/** Four hexadecimal digits that nearly always differ for different texts (FNV-1a, folded). */
function checksum(text: string): string {
  let hash = 0x811c9dc5;
  for (const character of text) hash = Math.imul(hash ^ character.charCodeAt(0), 0x01000193);
  return ((hash ^ (hash >>> 16)) & 0xffff).toString(16).padStart(4, "0");
}
