// The live motion of a model, which follows the couplings of the page.
import type { ModelStore } from "../couplings/model-store";
import type { EngineStore } from "../engine/engine-store";
import type { LiveStep } from "../engine/protocol";
import type { Playback } from "../stage/playback";
import type { StageStore } from "../stage/stage-store";
import type { NoticesStore } from "../ui/notices-store";
import { LiveStore } from "./live-store";

interface ModelStores {
  engine: EngineStore;
  model: ModelStore;
  stage: StageStore;
  playback: Playback;
  notices: NoticesStore;
}

export function modelLive({ engine: engines, model, stage, playback, notices }: ModelStores): LiveStore {
  const engine = () => {
    if (!engines.engine) throw new Error(engines.problem);
    return engines.engine;
  };
  const source = {
    get body() {
      return (engines.engine && model.model?.info) ?? null;
    },
    get revision() {
      return model.model?.revision ?? 0;
    },
    get couplings() {
      const { alpha, reading } = model.couplings;
      return { kind: "couplings" as const, alpha, reading };
    },
    on: (listener: () => void) => model.on(listener),
    begin() {
      const request = model.rolloutRequest();
      const frame = Math.min(Math.floor(playback.frame), request.frames - 1);
      return engine().startLive(request, frame);
    },
    advance: (step: LiveStep) => engine().advanceLive(step),
    end: () => void engines.engine?.endLive(),
  };
  return new LiveStore(source, stage, playback, notices);
}
