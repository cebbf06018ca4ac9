// A text about the parts of a combination that come to rest.
import type { LibraryInfo, PartMotion } from "../engine/library-protocol";
import { sentence } from "../ui/format";

/** Names the parts that rest under these couplings, with the reason; empty if all parts move. */
export function restingPartsText(
  { parts, primitives }: LibraryInfo,
  uses: readonly number[],
  moves: readonly PartMotion[],
): string {
  const name = (part: number) => parts[part]?.name ?? "";
  const primitive = (part: number) => `${name(part)}: ${primitives[uses[part] ?? -1]?.name ?? ""}`;
  const why = ({ leader }: PartMotion, part: number): string => {
    if (!leader) return "alone it comes to rest";
    const { weight, met } = leader;
    const share = `${name(leader.part)} decides ${Math.round(100 * weight)} % of what ${name(part)} does`;
    if (weight < 0.5) return `${share}; with that, its own predictions come to rest`;
    return met
      ? `${share}, and does not drive it under these couplings`
      : `${share}, and ${primitive(leader.part)} never learned to drive ${primitive(part)}`;
  };
  return moves
    .flatMap((motion, part) => (motion.still ? [`${name(part)} keeps one pose`, why(motion, part)] : []))
    .map(sentence)
    .join(" ");
}
