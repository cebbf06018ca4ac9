// The model on the stage as work that would be lost with another model.
import type { EngineStore } from "../engine/engine-store";
import type { Work } from "../unsaved/unsaved";
import type { ModelStore } from "./model-store";
import { lab } from "../words/lab";

/** Null where nothing would be lost. */
export function stageWork(store: ModelStore, { engine }: Pick<EngineStore, "engine">): Work | null {
  if (!store.unsaved || !engine) return null;
  const save = async () => (await import("./model-file")).saveModel(store, engine);
  return { what: lab().files.unsaved.model, save };
}
