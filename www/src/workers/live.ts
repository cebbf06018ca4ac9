// A rollout that never ends, of the model that the page shows. No DOM.
import { LiveRollout } from "vcgpdm/player";
import type { LiveChange, LiveFrames, ModelInfo, RolloutRequest } from "../engine/protocol";
import { transfer, using } from "./using";
import type { ShownModel } from "./shown-model";

export class Live {
  #live: { rollout: LiveRollout; info: ModelInfo } | null = null;

  constructor(private readonly model: ShownModel) {}

  start(request: RolloutRequest, frame: number): void {
    const next = this.model.withRollout(request, (rollout, info) => ({
      rollout: new LiveRollout(rollout, frame),
      info,
    }));
    this.end();
    this.#live = next;
  }

  advance(changes: LiveChange[], frames: number): LiveFrames {
    if (!this.#live) throw new Error("The live motion ended: start it again.");
    const { rollout, info } = this.#live;
    for (const change of changes) this.#change(rollout, change);
    return using(rollout.advance(frames), (next) => {
      const motion = {
        positions: next.positions(),
        frames,
        nodes: info.figure.nodes.length,
        frameTime: info.frameTime,
      };
      const latents = info.parts.map((_, part) => next.latents(part));
      const [phases, distances, recorded] = [next.phases(), next.distances(), next.recorded()];
      const result = { motion, latents, phases, distances, recorded };
      return transfer(result, motion.positions, ...latents, phases, distances, recorded);
    });
  }

  end(): void {
    this.#live?.rollout.free();
    this.#live = null;
  }

  #change(rollout: LiveRollout, change: LiveChange): void {
    switch (change.kind) {
      case "take-back":
        rollout.takeBack();
        break;
      case "couplings":
        rollout.setCouplings(Float64Array.from(change.alpha.flat()), change.reading === "re-inferred");
        break;
      case "cut":
        rollout.cut(change.source, change.target, change.cut);
        break;
      case "push":
        rollout.push(change.part, Float64Array.from(change.by));
        break;
      case "pull":
        rollout.pull(change.node, ...change.by);
        break;
      case "drive":
        rollout.drive(change.part, change.turns);
        break;
      case "record":
        rollout.record(change.part, change.latents);
        break;
      case "reach":
        rollout.reach(change.node, ...change.place);
        break;
      case "release":
        rollout.release(change.part);
        break;
    }
  }
}
