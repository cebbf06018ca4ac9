// The model on the stage as work that would be lost with another model.
import type { EngineStore } from "../engine/engine-store";
import type { Work } from "../ui/unsaved";
import type { ModelStore } from "./model-store";

/** Null where nothing would be lost. */
export function stageWork(store: ModelStore, { engine }: Pick<EngineStore, "engine">): Work | null {
  if (!store.unsaved || !engine) return null;
  const save = async () => (await import("./model-file")).saveModel(store, engine);
  return { what: "the model on the stage, which was made here", save };
}
