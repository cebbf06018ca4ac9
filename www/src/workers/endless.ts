// Motions without an end: takes frames back, makes changes, and computes the next frames. No DOM.
import type { Endless } from "vcgpdm/player";
import type { LiveBody, LiveChange, LiveFrames, LiveStep } from "../engine/protocol";
import { transfer, using } from "./using";

/** A change of primitives, which only a library can make. */
export type PrimitivesChange = Extract<LiveChange, { kind: "use" | "nearest" }>;

/** `primitives` makes the changes of primitives; absent: a model, which has none. */
export function advance(
  endless: Endless,
  { figure, frameTime, parts }: LiveBody,
  { back, changes, frames }: LiveStep,
  primitives: (change: PrimitivesChange) => void = () => {},
): LiveFrames {
  if (back > 0) endless.rewind(back);
  for (const change of changes) {
    if (change.kind === "use" || change.kind === "nearest") primitives(change);
    else make(endless, change);
  }
  return using(endless.advance(frames), (next) => {
    const motion = { positions: next.positions(), frames, nodes: figure.nodes.length, frameTime };
    const latents = parts.map((_, part) => next.latents(part));
    const [phases, distances, recorded] = [next.phases(), next.distances(), next.recorded()];
    const columns = next.values();
    const result = { motion, latents, columns, phases, distances, recorded };
    return transfer(result, motion.positions, ...latents, columns, phases, distances, recorded);
  });
}

function make(endless: Endless, change: Exclude<LiveChange, PrimitivesChange>): void {
  switch (change.kind) {
    case "couplings":
      endless.setCouplings(Float64Array.from(change.alpha.flat()), change.reading === "re-inferred");
      break;
    case "tempo":
      endless.setTempo(change.part, change.tempo);
      break;
    case "cut":
      endless.cut(change.source, change.target, change.cut);
      break;
    case "push":
      endless.push(change.part, Float64Array.from(change.by));
      break;
    case "pull":
      endless.pull(change.node, ...change.by);
      break;
    case "drive":
      endless.drive(change.part, change.turns);
      break;
    case "record":
      endless.record(change.part, change.latents);
      break;
    case "reach":
      endless.reach(change.node, ...change.place);
      break;
    case "release":
      endless.release(change.part);
      break;
  }
}
