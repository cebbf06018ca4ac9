// A text about the parts of a combination that come to rest.
import type { LibraryInfo, PartMotion } from "../engine/library-protocol";
import { sentence } from "../ui/format";
import { primitivesWords } from "../words/primitives";
import { shownPart } from "../words/lab";

/** Names the parts that rest under these couplings, with the reason; empty if all parts move. */
export function restingPartsText(
  { parts, primitives }: LibraryInfo,
  uses: readonly number[],
  moves: readonly PartMotion[],
): string {
  const words = primitivesWords().couplings.rests;
  const name = (part: number) => shownPart(parts[part]?.name ?? "");
  const primitive = (part: number) => `${name(part)}: ${primitives[uses[part] ?? -1]?.name ?? ""}`;
  const why = ({ leader }: PartMotion, part: number): string => {
    if (!leader) return words.alone;
    const { weight, met } = leader;
    const share = words.decides(name(leader.part), weight, name(part));
    if (weight < 0.5) return `${share}${words.ownRest}`;
    return met
      ? `${share}${words.doesNotDrive}`
      : `${share}${words.neverLearned(primitive(leader.part), primitive(part))}`;
  };
  return moves
    .flatMap((motion, part) => (motion.still ? [words.keepsPose(name(part)), why(motion, part)] : []))
    .map(sentence)
    .join(" ");
}
