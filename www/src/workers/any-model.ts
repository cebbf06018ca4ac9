// Rollouts of models of any kind: the program of the first visit knows only vCGPDM and vGPDM. No DOM.
import { Model } from "vcgpdm";
import type { AnyModelWorker } from "../engine/whole-protocol";
import { transfer } from "./transfer";
import { using } from "./using";

export const anyModelWorker: AnyModelWorker = {
  rollOutAny: (text, frames) =>
    using(Model.fromJson(text), (model) => {
      const { kind, figure, joints, parts, frameTime } = model.info();
      if (!figure || !joints) throw new Error("expected a model of a body, found a model of tables");
      return using(model.rollout({ frames, sequence: 0 }), (rollout) => {
        const positions = rollout.positions();
        const motion = { positions, frames: rollout.frames, nodes: figure.nodes.length, frameTime };
        return transfer(
          { kind, figure, joints, parts, motion, bvh: rollout.toBvh({ plainNames: true }) },
          positions,
        );
      });
    }),
};
