// What a worker does for the uncertainty of a rollout: moment matching through time. No DOM.
import { Model } from "vcgpdm";
import type { UncertaintyWorker } from "../engine/whole-protocol";
import { transfer } from "./transfer";
import { using } from "./using";

export const uncertaintyWorker: UncertaintyWorker = {
  moments: (text, request) =>
    using(Model.fromJson(text), (model) =>
      using(model.moments(request), (moments) => {
        const parts = model.info().parts.map((_, part) => ({
          means: moments.means(part),
          covariances: moments.covariances(part),
        }));
        return transfer(parts, ...parts.flatMap(({ means, covariances }) => [means, covariances]));
      }),
    ),
};
